// SPDX-License-Identifier: MIT
#include "lixel/trace/exact_filtered.h"

#include "lixel/base/assert.h"
#include "lixel/plan/light_image.h"
#include "lixel/shared/lookup/kernel.h"
#include "lixel/trace/lit_share.h"
#include "lixel/trace/parallel.h"

#include <algorithm>
#include <optional>

namespace lixel {
namespace {

struct Served
{
    LightImage image;
    Vec3d lixelAndDepth;
};

// By the first region that holds the point.
std::optional<Served> servedAt(const ShadowPlan& plan, Vec3d pointLocal)
{
    for (const PlannedRegion& region : plan.regions) {
        const auto isOutside = [&](const Plane& plane) { return plane.signedDistance(pointLocal) < 0; };
        if (std::ranges::any_of(region.halfSpacesLocal, isOutside)) continue;
        const LightImage image(region.projection(), region.rectangle, &region.warp);
        if (const auto lixel = image.lixelAt(pointLocal)) return Served{image, *lixel};
    }
    return std::nullopt;
}

// Where the light's ray through a place of the map meets the plane of the sample.
std::optional<SurfacePoint> onPlaneOf(const SurfacePoint& sample, const LightImage& image, Vec2d place)
{
    const auto ray = image.rayThrough(place);
    if (!ray) return std::nullopt;
    const Vec3d normal = toDouble(sample.normal);
    const double along = dot(normal, ray->directionLocal);
    if (along == 0) return std::nullopt;
    const double t = dot(normal, toDouble(sample.positionLocal) - ray->originLocal) / along;
    const Vec3d p = ray->originLocal + t * ray->directionLocal;
    if (!isFinite(p)) return std::nullopt;
    return SurfacePoint{toFloat(p), sample.normal, kNoTriangle};
}

// A place of the filter's square, turned as the sample's taps are.
Vec2d offsetOf(const LixelFilter& filter, Vec2d place, const SurfacePoint& sample)
{
    if (!filter.isRotated) return place;
    const Vec3f& p = sample.positionLocal;
    const shared::vec2 turned = shared::lxTurned({float(place.x), float(place.y)}, shared::lxSeedOf({p.x, p.y, p.z}));
    return {turned.x, turned.y};
}

} // namespace

std::vector<float> exactFiltered(const TraceScene& scene, const ShadowPlan& plan, const ViewSamples& samples,
                                 const Light& light, const LixelFilter& filter, int n)
{
    LX_ASSERT(samples.originWorld == scene.originWorld() && filter.side > 0 && n > 0);
    std::vector<float> share(samples.size(), 0.0f);
    forEachBlock(samples.size(), 64, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const SurfacePoint sample = surfacePoint(samples, i);
            if (!facesLight(scene, sample, light)) continue;
            const auto served = servedAt(plan, toDouble(sample.positionLocal));
            LitShare lit(scene, light);
            for (int k = 0; served && k < n * n; ++k) {
                const int column = k % n, row = k / n;
                const Vec2d place{(column + 0.5) / n - 0.5, (row + 0.5) / n - 0.5};
                const Vec2d middle{served->lixelAndDepth.x, served->lixelAndDepth.y};
                lit.add(onPlaneOf(sample, served->image, middle + offsetOf(filter, filter.side * place, sample)));
            }
            share[i] = lit.around(sample);
        }
    });
    return share;
}

} // namespace lixel
