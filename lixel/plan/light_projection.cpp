// SPDX-License-Identifier: MIT
#include "lixel/plan/light_projection.h"

#include <cmath>

namespace lixel {
namespace {

// From the light, in the axes of a paraboloid's map.
Vec3d awayFromLight(Vec4d clip) { return {clip.x, clip.y, clip.w}; }

// Rays that are straight behind but for rounding have no place.
constexpr double kLeastReach = 1e-12;

} // namespace

Vec2d onParaboloid(Vec3d ray) { return {ray.x / (1 + ray.z), ray.y / (1 + ray.z)}; }

Vec3d paraboloidRay(Vec2d place)
{
    const double squared = dot(place, place);
    return 1 / (1 + squared) * Vec3d{2 * place.x, 2 * place.y, 1 - squared};
}

std::optional<Vec3d> LightProjection::ndcAt(Vec3d pointLocal) const
{
    const Vec4d clip = lightClipFromLocal * point(pointLocal);
    if (!paraboloid) return clip.w > 0 ? std::optional(1 / clip.w * xyz(clip)) : std::nullopt;
    const Vec3d away = awayFromLight(clip);
    const double distance = length(away);
    if (!(distance + away.z > kLeastReach * distance)) return std::nullopt;
    const Paraboloid& p = *paraboloid;
    const Vec2d place = onParaboloid(1 / distance * away);
    const double left = p.near * (p.far / distance - 1) / (p.far - p.near); // 1 at the near side, 0 at the far
    return Vec3d{(place.x - p.centre.x) / p.halfSize.x, (place.y - p.centre.y) / p.halfSize.y, 1 - 2 * left};
}

Vec3d LightProjection::ndcAlong(Vec3d pointLocal, Vec3d tangent) const
{
    const Vec4d clip = lightClipFromLocal * point(pointLocal), change = lightClipFromLocal * direction(tangent);
    if (!paraboloid) {
        // d(clip / w) = (d clip - ndc d w) / w
        const Vec3d ndc = 1 / clip.w * xyz(clip);
        return 1 / clip.w * (xyz(change) - change.w * ndc);
    }
    // place = (x, y) / (r + z), and r changes by q . d.
    const Paraboloid& p = *paraboloid;
    const Vec3d away = awayFromLight(clip), d = awayFromLight(change);
    const double distance = length(away), ofDistance = dot(away, d) / distance;
    const double reach = distance + away.z, ofReach = ofDistance + d.z;
    const double ofLeft = -p.near * p.far / (p.far - p.near) * ofDistance / (distance * distance);
    return {(d.x - away.x / reach * ofReach) / reach / p.halfSize.x,
            (d.y - away.y / reach * ofReach) / reach / p.halfSize.y, -2 * ofLeft};
}

} // namespace lixel
