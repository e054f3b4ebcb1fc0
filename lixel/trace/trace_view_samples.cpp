// SPDX-License-Identifier: MIT
#include "lixel/trace/trace_view_samples.h"

#include "lixel/trace/parallel.h"
#include "lixel/trace/view_rays.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace lixel {

constexpr std::size_t kRaysABlock = 2048; // a small picture is one block: it starts no thread

ViewSamples traceViewSamples(const TraceScene& scene, const View& view)
{
    const ViewRays rays(view, scene.originWorld());
    const auto width = std::size_t(view.width), height = std::size_t(view.height);
    std::vector<std::optional<SurfacePoint>> seen(width * height);
    forEachBlock(height, std::max<std::size_t>(1, kRaysABlock / width), [&](std::size_t first, std::size_t last) {
        std::vector<Vec2d> pixels(width);
        for (std::size_t y = first; y < last; ++y) {
            for (std::size_t x = 0; x < width; ++x) pixels[x] = {double(x) + 0.5, double(y) + 0.5};
            const std::vector<std::optional<SurfacePoint>> row = seenThrough(scene, rays, pixels);
            std::copy(row.begin(), row.end(), seen.begin() + std::ptrdiff_t(y * width));
        }
    });
    ViewSamples samples;
    samples.width = view.width, samples.height = view.height;
    samples.originWorld = scene.originWorld();
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (!seen[i]) continue;
        const std::size_t x = i % width, y = i / width;
        samples.pixel.push_back({float(x) + 0.5f, float(y) + 0.5f});
        samples.positionLocal.push_back(seen[i]->positionLocal);
        samples.normal.push_back(seen[i]->normal);
        samples.triangle.push_back(seen[i]->triangle);
    }
    return samples;
}

} // namespace lixel
