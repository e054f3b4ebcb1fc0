// SPDX-License-Identifier: MIT
#include "lixel/trace/shade.h"

#include "lixel/base/assert.h"
#include "lixel/plan/shading_light.h"
#include "lixel/shared/shading.h"
#include "lixel/trace/parallel.h"
#include "lixel/trace/surface_colours.h"

#include <cmath>
#include <vector>

namespace lixel {
namespace {

shared::vec3 toShared(Vec3f v) { return {v.x, v.y, v.z}; }

Rgba8 displayed(shared::vec3 linear)
{
    const shared::vec3 c = shared::lxDisplayed(linear);
    const auto byte = [](float x) { return std::uint8_t(std::lround(x * 255.0f)); };
    return {byte(c.x), byte(c.y), byte(c.z), 255};
}

} // namespace

Image<Rgba8> shadeTraced(const TraceScene& scene, std::span<const Light> lights, const ViewSamples& samples,
                         std::span<const Visibility> visibility)
{
    LX_ASSERT(lights.size() == visibility.size());
    Image<Rgba8> picture(samples.width, samples.height);
    for (int y = 0; y < picture.height(); ++y) {
        const Rgba8 background = displayed(shared::lxBackground((float(y) + 0.5f) / float(picture.height())));
        for (int x = 0; x < picture.width(); ++x) picture(x, y) = background;
    }

    std::vector<shared::ShadingLight> table;
    for (const Light& light : lights) table.push_back(shadingLight(light, samples.originWorld));
    const SurfaceColours surface = surfaceColours(scene, samples);
    std::vector<Rgba8> colours(samples.size());
    forEachBlock(samples.size(), 4096, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const shared::vec3 normal = toShared(surface.shadingNormal[i]);
            shared::vec3 light = shared::lxAmbientLight(normal);
            for (std::size_t l = 0; l < table.size(); ++l) {
                const float share = visibility[l].value.empty() ? 1.0f : visibility[l].value[i];
                light = light + share * shared::lxDirectLight(table[l], toShared(samples.positionLocal[i]),
                                                              toShared(samples.normal[i]), normal);
            }
            colours[i] = displayed(toShared(surface.baseColour[i]) * light + toShared(surface.emission[i]));
        }
    });

    // Backwards, so that the first sample of a pixel stays.
    for (std::size_t i = samples.size(); i-- > 0;) {
        const int x = int(samples.pixel[i].x), y = int(samples.pixel[i].y);
        if (picture.contains(x, y)) picture(x, y) = colours[i];
    }
    return picture;
}

} // namespace lixel
