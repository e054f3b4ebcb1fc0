// SPDX-License-Identifier: MIT
#include "lixel/trace/view_rays.h"

#include "lixel/base/assert.h"
#include "lixel/trace/ray_triangle.h"

#include <limits>

namespace lixel {
namespace {

bool keepsAlpha(const void* scene, std::uint32_t triangle, float u, float v)
{
    return static_cast<const TraceScene*>(scene)->keeps(triangle, u, v);
}

// The point of the triangle on the ray; the triangle was found in floats, hence may be missed by a little in double.
std::optional<SurfacePoint> pointOn(const TraceScene& scene, std::uint32_t triangle, const ViewRay& ray)
{
    const Corners corners = scene.corners(triangle);
    const std::optional<Vec3d> normal = unitNormal(corners);
    const std::optional<double> t = meetPlane(ray.origin, ray.direction, corners);
    if (!normal || !t) return std::nullopt;
    const Vec3d p = drawnInto(corners, ray.origin + *t * ray.direction, 0).value();
    return SurfacePoint{toFloat(p), toFloat(dot(*normal, ray.direction) > 0 ? -*normal : *normal), triangle};
}

} // namespace

ViewRays::ViewRays(const View& view, Vec3d originWorld)
    : anchorLocal_(view.anchorWorld - originWorld), width_(view.width), height_(view.height)
{
    const std::optional<Mat4d> inverted = inverse(view.clipFromAnchored);
    LX_ASSERT(inverted.has_value());
    anchoredFromClip_ = *inverted;
}

std::optional<ViewRay> ViewRays::through(Vec2d pixel) const
{
    const double x = 2 * pixel.x / width_ - 1, y = 2 * pixel.y / height_ - 1;
    const Vec4d near = anchoredFromClip_ * Vec4d{x, y, -1, 1}, far = anchoredFromClip_ * Vec4d{x, y, 1, 1};
    if (!(near.w > 0)) return std::nullopt;
    // The derivative of the point by the depth, up to a positive factor; finite also where the far plane is not.
    const Vec3d along = near.w * xyz(far) - far.w * xyz(near);
    const Vec3d first = xyz(near) / near.w;
    const double tFar = far.w > 0 ? length(xyz(far) / far.w - first) : std::numeric_limits<double>::infinity();
    return ViewRay{first + anchorLocal_, normalized(along), tFar};
}

std::vector<std::optional<SurfacePoint>> seenThrough(const TraceScene& scene, const ViewRays& rays,
                                                     std::span<const Vec2d> pixels)
{
    std::vector<std::optional<ViewRay>> ray(pixels.size());
    std::vector<SearchRay> search(pixels.size());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        ray[i] = rays.through(pixels[i]);
        search[i] = {{}, {}, 0, -1};
        if (!ray[i]) continue;
        const Interval inScene =
            clipToBox(ray[i]->origin, ray[i]->direction, scene.searchBoxLocal(), {0, ray[i]->tFar});
        search[i] = searchRay(ray[i]->origin, ray[i]->direction, inScene);
    }
    std::vector<SearchHit> hits(pixels.size());
    scene.embree().nearest(search, hits, keepsAlpha, &scene);
    std::vector<std::optional<SurfacePoint>> points(pixels.size());
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (hits[i].triangle != kNoTriangle) points[i] = pointOn(scene, hits[i].triangle, *ray[i]);
    return points;
}

} // namespace lixel
