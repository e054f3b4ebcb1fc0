// SPDX-License-Identifier: MIT
#include "lixel/trace/plane_probe.h"

#include "lixel/base/assert.h"
#include "lixel/shared/lookup.h"
#include "lixel/trace/exact_visibility.h"
#include "lixel/trace/light_map.h"

#include <cmath>

namespace lixel {
namespace {

shared::vec3 toShared(Vec3f a) { return {a.x, a.y, a.z}; }

// The place of the plane that the light image has at this lixel.
Vec3d onPlane(const LightImage& image, const Plane& planeLocal, Vec2d lixel)
{
    const LightRay ray = image.rayThrough(lixel).value();
    const double t = -planeLocal.signedDistance(ray.originLocal) / dot(planeLocal.normal, ray.directionLocal);
    return ray.originLocal + t * ray.directionLocal;
}

// Exact visibility around a sample.
std::vector<float> exactBeside(const TraceScene& scene, const PlannedRegion& region, const Light& light,
                               const ViewSamples& samples, std::size_t i, double besideLixels)
{
    const LightImage image(region.projection(), region.rectangle, &region.warp);
    const Vec3d p = toDouble(samples.positionLocal[i]);
    const auto lixel = image.lixelAt(p);
    if (!lixel) return {};
    ViewSamples beside;
    beside.originWorld = samples.originWorld;
    const double by = besideLixels;
    for (const Vec2d& offset : {Vec2d{by, 0}, Vec2d{-by, 0}, Vec2d{0, by}, Vec2d{0, -by}}) {
        beside.pixel.push_back(samples.pixel[i]);
        beside.positionLocal.push_back(
            toFloat(onPlane(image, *region.pixelPlaneLocal, {lixel->x + offset.x, lixel->y + offset.y})));
        beside.normal.push_back(samples.normal[i]);
        beside.triangle.push_back(samples.triangle[i]);
    }
    return exactVisibility(scene, beside, light);
}

bool isNearCaster(const TraceScene& scene, const PlannedRegion& region, const shared::ShadowRegion& row,
                  const ViewSamples& samples, std::size_t i)
{
    const shared::LxReceiver receiver =
        shared::lxReceive(row, toShared(samples.positionLocal[i]), toShared(samples.normal[i]));
    if (receiver.isInside == 0) return false;
    const float x = std::floor(receiver.lixel.x), y = std::floor(receiver.lixel.y);
    const shared::vec2 centre{x + 0.5f, y + 0.5f};
    const float stored = tracedDepth(scene, region, int(x), int(y));
    return stored <= shared::lxShadowingDepth(receiver, centre);
}

} // namespace

PlaneProbe probeOnPlane(const TraceScene& scene, const FramePlan& plan, std::size_t lightNumber, std::size_t region,
                        const Light& light, const ViewSamples& samples, std::size_t sample, double besideLixels)
{
    const PlannedRegion& planned = plan.lights[lightNumber].regions[region];
    LX_ASSERT(planned.pixelPlaneLocal);
    const std::size_t row = std::size_t(plan.lightTable[lightNumber].regions.x) + region;
    return {exactBeside(scene, planned, light, samples, sample, besideLixels),
            isNearCaster(scene, planned, plan.regionTable[row], samples, sample)};
}

} // namespace lixel
