// SPDX-License-Identifier: MIT
#include "lixel/trace/exact_area.h"

#include "lixel/base/assert.h"
#include "lixel/trace/parallel.h"
#include "lixel/trace/shadow_ray.h"
#include "lixel/trace/view_rays.h"

#include <cmath>
#include <optional>

namespace lixel {
namespace {

bool facesLight(const TraceScene& scene, const SurfacePoint& point, const Light& light)
{
    return isLightFacing(light, scene.originWorld(), toDouble(point.positionLocal), toDouble(point.normal));
}

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
            int facing = 0, lit = 0;
            for (const std::optional<SurfacePoint>& point :
                 seenThrough(scene, rays, centresWithin(samples.pixel[i], perSide))) {
                if (!point || !facesLight(scene, *point, light)) continue;
                ++facing;
                if (!isInShadow(scene, *point, light)) ++lit;
            }
            if (facing > 0) share[i] = float(lit) / float(facing);
            else share[i] = isInShadow(scene, sample, light) ? 0.0f : 1.0f;
        }
    });
    return share;
}

} // namespace lixel
