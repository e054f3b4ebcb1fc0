// SPDX-License-Identifier: MIT
#include "lixel/plan/light_image.h"

namespace lixel {

LightImage::LightImage(const Mat4d& lightClipFromLocal, const LixelRectangle& rectangle)
    : lightClipFromLocal_(lightClipFromLocal), localFromLightClip_(inverse(lightClipFromLocal)), rectangle_(rectangle)
{
}

std::optional<Vec3d> LightImage::lixelAt(Vec3d pointLocal) const
{
    const Vec4d clip = lightClipFromLocal_ * point(pointLocal);
    if (!(clip.w > 0)) return std::nullopt;
    const Vec3d lixel{rectangle_.x0 + (0.5 + 0.5 * clip.x / clip.w) * rectangle_.width(),
                      rectangle_.y0 + (0.5 + 0.5 * clip.y / clip.w) * rectangle_.height(), clip.z / clip.w};
    const bool isInside =
        lixel.x >= rectangle_.x0 && lixel.x < rectangle_.x1 && lixel.y >= rectangle_.y0 && lixel.y < rectangle_.y1;
    return isInside ? std::optional(lixel) : std::nullopt;
}

std::optional<LightRay> LightImage::rayThrough(Vec2d lixel) const
{
    if (!localFromLightClip_) return std::nullopt;
    const double x = 2 * (lixel.x - rectangle_.x0) / rectangle_.width() - 1;
    const double y = 2 * (lixel.y - rectangle_.y0) / rectangle_.height() - 1;
    // From the near side to the far side; homogeneous, so that a far side at infinity gives a direction.
    const Vec4d near = *localFromLightClip_ * Vec4d{x, y, -1, 1}, far = *localFromLightClip_ * Vec4d{x, y, 1, 1};
    const Vec3d origin = (1 / near.w) * xyz(near);
    const Vec3d travel = xyz(far) - far.w * origin;
    return LightRay{origin, far.w < 0 ? -travel : travel};
}

LightImage::Tangents LightImage::tangents(Vec3d pointLocal, Vec3d first, Vec3d second) const
{
    const Vec4d clip = lightClipFromLocal_ * point(pointLocal);
    const Vec3d ndc = (1 / clip.w) * xyz(clip);
    const auto along = [&](Vec3d tangent) {
        // d(clip / w) = (d clip - ndc d w) / w
        const Vec4d change = lightClipFromLocal_ * direction(tangent);
        const Vec3d d = (1 / clip.w) * (xyz(change) - change.w * ndc);
        return Vec3d{0.5 * rectangle_.width() * d.x, 0.5 * rectangle_.height() * d.y, d.z};
    };
    return {along(first), along(second)};
}

} // namespace lixel
