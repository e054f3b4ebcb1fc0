// SPDX-License-Identifier: MIT
#include "lixel/plan/host_view.h"

#include <cmath>

namespace lixel {
namespace {

// Below this share of the lengths of rows x, y and w, their determinant is rounding: they have no common point.
constexpr double kLeastDeterminant = 1e-14;

// The common null vector of rows x, y and w.
std::optional<Vec4d> eyeOf(const Mat4d& clip)
{
    const Vec4d rowX = clip.row(0), rowY = clip.row(1), rowW = clip.row(3);
    const Vec3d x = xyz(rowX), y = xyz(rowY), w = xyz(rowW);
    if (w == Vec3d{}) {
        const Vec3d along = normalized(cross(x, y));
        return direction(dot(xyz(clip.row(2)), along) > 0 ? -along : along);
    }
    const double determinant = dot(x, cross(y, w));
    if (!(std::abs(determinant) > kLeastDeterminant * length(x) * length(y) * length(w))) return std::nullopt;
    // Cramer's rule for the three planes x = 0, y = 0, w = 0.
    const Vec3d sum = rowX.w * cross(y, w) + rowY.w * cross(w, x) + rowW.w * cross(x, y);
    return point(-1 / determinant * sum);
}

} // namespace

std::optional<View> viewFromHost(const Mat4d& hostClipFromView, const Mat4d& viewFromWorld, const ClipConvention& host,
                                 int width, int height)
{
    const std::optional<Mat4d> worldFromView = inverse(viewFromWorld);
    if (!worldFromView) return std::nullopt;
    Mat4d viewFromAnchored = viewFromWorld;
    for (int i = 0; i < 3; ++i) viewFromAnchored.m[i][3] = 0;
    return viewFromHost(hostClipFromView * viewFromAnchored, transformPoint(*worldFromView, {}), host, width, height);
}

std::optional<View> viewFromHost(const Mat4d& hostClipFromAnchored, Vec3d anchorWorld, const ClipConvention& host,
                                 int width, int height)
{
    const Mat4d clipFromAnchored = fromHost(hostClipFromAnchored, host);
    if (!isFinite(clipFromAnchored) || !inverse(clipFromAnchored) || width <= 0 || height <= 0) return std::nullopt;
    const std::optional<Vec4d> eye = eyeOf(clipFromAnchored);
    if (!eye) return std::nullopt;
    return View{clipFromAnchored, anchorWorld, *eye, width, height};
}

} // namespace lixel
