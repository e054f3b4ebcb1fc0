// SPDX-License-Identifier: MIT
#include "lixel/plan/light_image.h"

#include "lixel/plan/warp/texture_warp.h"

namespace lixel {
namespace {

shared::vec2 toShared(Vec2d p) { return {float(p.x), float(p.y)}; }

// From the light on, along a ray of the half sphere and beyond.
LightRay rayOnto(const Paraboloid& paraboloid, const Mat4d& lightClipFromLocal, Vec2d ndc)
{
    const Vec4d x = lightClipFromLocal.row(0), y = lightClipFromLocal.row(1), w = lightClipFromLocal.row(3);
    const Vec3d ray = paraboloidRay(
        {paraboloid.centre.x + paraboloid.halfSize.x * ndc.x, paraboloid.centre.y + paraboloid.halfSize.y * ndc.y});
    return {-(x.w * xyz(x) + y.w * xyz(y) + w.w * xyz(w)), ray.x * xyz(x) + ray.y * xyz(y) + ray.z * xyz(w)};
}

} // namespace

LightImage::LightImage(const LightProjection& projection, const LixelRectangle& rectangle, const TextureWarp* warp)
    : projection_(projection), rectangle_(rectangle), warp_(warp && !warp->isIdentity() ? warp : nullptr)
{
    if (!projection.paraboloid) localFromLightClip_ = inverse(projection.lightClipFromLocal);
}

// The fit alone, in lixels of the rectangle.
Vec3d LightImage::unwarpedAt(Vec3d ndc) const
{
    return {rectangle_.x0 + (0.5 + 0.5 * ndc.x) * rectangle_.width(),
            rectangle_.y0 + (0.5 + 0.5 * ndc.y) * rectangle_.height(), ndc.z};
}

std::optional<Vec3d> LightImage::lixelAt(Vec3d pointLocal) const
{
    const auto ndc = projection_.ndcAt(pointLocal);
    if (!ndc) return std::nullopt;
    Vec3d lixel = unwarpedAt(*ndc);
    const bool isInside =
        lixel.x >= rectangle_.x0 && lixel.x < rectangle_.x1 && lixel.y >= rectangle_.y0 && lixel.y < rectangle_.y1;
    if (!isInside) return std::nullopt;
    if (warp_) {
        const shared::LxWarped warped =
            shared::lxWarpedLixel(tableRow(*warp_), toShared({lixel.x, lixel.y}), knotsOf(*warp_));
        lixel.x = warped.at.x, lixel.y = warped.at.y;
    }
    return lixel;
}

std::optional<LightRay> LightImage::rayThrough(Vec2d lixel) const
{
    if (warp_) {
        const shared::vec2 unwarped = shared::lxUnwarpedLixel(tableRow(*warp_), toShared(lixel), knotsOf(*warp_));
        lixel = {unwarped.x, unwarped.y};
    }
    const double x = 2 * (lixel.x - rectangle_.x0) / rectangle_.width() - 1;
    const double y = 2 * (lixel.y - rectangle_.y0) / rectangle_.height() - 1;
    if (projection_.paraboloid) return rayOnto(*projection_.paraboloid, projection_.lightClipFromLocal, {x, y});
    if (!localFromLightClip_) return std::nullopt;
    // From the near side to the far side; homogeneous, so that a far side at infinity gives a direction.
    const Vec4d near = *localFromLightClip_ * Vec4d{x, y, -1, 1}, far = *localFromLightClip_ * Vec4d{x, y, 1, 1};
    const Vec3d origin = (1 / near.w) * xyz(near);
    const Vec3d travel = xyz(far) - far.w * origin;
    return LightRay{origin, far.w < 0 ? -travel : travel};
}

LightImage::Tangents LightImage::tangents(Vec3d pointLocal, Vec3d first, Vec3d second) const
{
    const auto along = [&](Vec3d tangent) {
        const Vec3d d = projection_.ndcAlong(pointLocal, tangent);
        return Vec3d{0.5 * rectangle_.width() * d.x, 0.5 * rectangle_.height() * d.y, d.z};
    };
    if (!warp_) return {along(first), along(second)};
    const auto ndc = projection_.ndcAt(pointLocal);
    const Vec3d unwarped = ndc ? unwarpedAt(*ndc) : Vec3d{};
    const shared::LxWarped w =
        shared::lxWarpedLixel(tableRow(*warp_), toShared({unwarped.x, unwarped.y}), knotsOf(*warp_));
    const auto warped = [&](Vec3d d) {
        return Vec3d{d.x * w.alongX.x + d.y * w.alongY.x, d.x * w.alongX.y + d.y * w.alongY.y, d.z};
    };
    return {warped(along(first)), warped(along(second))};
}

} // namespace lixel
