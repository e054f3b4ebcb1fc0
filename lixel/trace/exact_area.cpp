// SPDX-License-Identifier: MIT
#include "lixel/trace/exact_area.h"

#include "lixel/base/assert.h"
#include "lixel/trace/lit_share.h"
#include "lixel/trace/parallel.h"
#include "lixel/trace/view_rays.h"

#include <cmath>
#include <optional>

namespace lixel {
namespace {

// Centres of the squares of the pixel that holds the point.
std::vector<Vec2d> centresWithin(Vec2f pixel, int perSide)
{
    const Vec2d corner{std::floor(double(pixel.x)), std::floor(double(pixel.y))};
    std::vector<Vec2d> centres;
    for (int y = 0; y < perSide; ++y)
        for (int x = 0; x < perSide; ++x) centres.push_back(corner + Vec2d{(x + 0.5) / perSide, (y + 0.5) / perSide});
    return centres;
}

} // namespace

std::vector<float> exactArea(const TraceScene& scene, const View& view, const ViewSamples& samples, const Light& light,
                             int n)
{
    const int perSide = int(std::lround(std::sqrt(double(n))));
    LX_ASSERT(perSide >= 1 && perSide * perSide == n);
    LX_ASSERT(samples.originWorld == scene.originWorld());
    const ViewRays rays(view, scene.originWorld());
    std::vector<float> share(samples.size(), 0.0f);
    forEachBlock(samples.size(), 256, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const SurfacePoint sample = surfacePoint(samples, i);
            if (!facesLight(scene, sample, light)) continue;
            LitShare lit(scene, light);
            for (const std::optional<SurfacePoint>& point :
                 seenThrough(scene, rays, centresWithin(samples.pixel[i], perSide)))
                lit.add(point);
            share[i] = lit.around(sample);
        }
    });
    return share;
}

} // namespace lixel
