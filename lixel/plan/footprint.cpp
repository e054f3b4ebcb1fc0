// SPDX-License-Identifier: MIT
#include "lixel/plan/footprint.h"

#include <limits>

namespace lixel {

std::optional<Footprint> footprint(const View& view, Vec3d originWorld, const LightImage& image, Vec3d pointLocal,
                                   Vec3d normal)
{
    if (!image.lixelAt(pointLocal)) return std::nullopt;
    const Mat4d viewClipFromLocal = clipFromLocal(view, originWorld);
    const Vec4d clip = viewClipFromLocal * point(pointLocal);
    if (!(clip.w > 0)) return std::nullopt;

    // Both images along the same two tangents of the plane; the chain rule takes one to the other.
    const Vec3d t1 = anyPerpendicular(normal), t2 = cross(normal, t1);
    const Vec3d ndc = (1 / clip.w) * xyz(clip);
    const auto pixelsAlong = [&](Vec3d tangent) {
        const Vec4d change = viewClipFromLocal * direction(tangent);
        const Vec3d d = (1 / clip.w) * (xyz(change) - change.w * ndc);
        return Vec2d{0.5 * view.width * d.x, 0.5 * view.height * d.y};
    };
    const Vec2d p1 = pixelsAlong(t1), p2 = pixelsAlong(t2);
    const double pixelArea = cross(p1, p2);
    if (!(std::abs(pixelArea) > 1e-12 * length(p1) * length(p2))) return std::nullopt;
    const auto [l1, l2] = image.tangents(pointLocal, t1, t2);

    Footprint f;
    // [l1 l2] * inverse([p1 p2])
    f.lixelFromPixel[0][0] = (l1.x * p2.y - l2.x * p1.y) / pixelArea;
    f.lixelFromPixel[0][1] = (l2.x * p1.x - l1.x * p2.x) / pixelArea;
    f.lixelFromPixel[1][0] = (l1.y * p2.y - l2.y * p1.y) / pixelArea;
    f.lixelFromPixel[1][1] = (l2.y * p1.x - l1.y * p2.x) / pixelArea;

    // Singular values of the 2x2 matrix: half the sum and difference of two hypotenuses. The smallest lixels per pixel is
    // one over the most pixels per lixel.
    const auto& m = f.lixelFromPixel;
    const double s = std::hypot(m[0][0] + m[1][1], m[1][0] - m[0][1]),
                 d = std::hypot(m[0][0] - m[1][1], m[1][0] + m[0][1]);
    f.lixelsPerPixel = std::abs(m[0][0] * m[1][1] - m[0][1] * m[1][0]);
    const double largest = 0.5 * (s + d);
    const double smallest = largest > 0 ? f.lixelsPerPixel / largest : 0;
    f.pixelsPerLixel = smallest > 0 ? 1 / smallest : std::numeric_limits<double>::infinity();

    const Vec3d across = cross(l1, l2);
    f.depthPerLixel = {-across.x / across.z, -across.y / across.z};
    return f;
}

} // namespace lixel
