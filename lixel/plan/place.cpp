// SPDX-License-Identifier: MIT
#include "lixel/plan/place.h"

#include <algorithm>
#include <cmath>

namespace lixel {
namespace {

// Sides of a map closer than this share are equal but for rounding, which must not turn it.
constexpr double kEqual = 1e-9;

// Lixels that rounding moves receivers by, at most, in the narrowest maps (light_frame.cpp).
constexpr double kRounding = 0.1;

// Moves a parallel map along one axis, by half a lixel at most, so that the world's origin lies on a border of lixels.
void snapRow(Mat4d& clip, int row, int lixels, Vec3d originWorld)
{
    Vec4d r = clip.row(row);
    const double ofWorldOrigin = 0.5 * lixels * (1 + dot(r, point(-originWorld)));
    r.w += 2.0 / lixels * (std::round(ofWorldOrigin) - ofWorldOrigin);
    clip.setRow(row, r);
}

// The share of a side that what is held has of it.
double shrink(int lixels, double reach)
{
    // Where there is no room for the reach, half a lixel is left: rounding and moving to the grid lose no one.
    return std::max(1 - 2 * reach / lixels, 0.5 / lixels);
}

void turnAxes(Mat4d& clip)
{
    const Vec4d x = clip.row(0);
    clip.setRow(0, clip.row(1));
    clip.setRow(1, -1.0 * x); // a turn, not a mirror
}

// The size of its lixels is told apart from the matrix.
LightProjection placeParaboloid(const Fit& fit, const LixelRectangle& rectangle, double reach, bool isTurned)
{
    LightProjection out = fit.projection();
    Paraboloid& p = *out.paraboloid;
    if (isTurned) {
        turnAxes(out.lightClipFromLocal);
        p.centre = {p.centre.y, -p.centre.x};
        p.halfSize = {p.halfSize.y, p.halfSize.x};
    }
    p.halfSize.x /= shrink(rectangle.width(), reach);
    p.halfSize.y /= shrink(rectangle.height(), reach);
    return out;
}

} // namespace

LightProjection place(const Fit& fit, const LixelRectangle& rectangle, const LookupLayout& lookup, Vec3d originWorld,
                      std::optional<bool> turn)
{
    const auto isAcross = [&](double sizeX, double sizeY) {
        return (rectangle.width() > rectangle.height() && sizeX < sizeY * (1 - kEqual)) ||
               (rectangle.width() < rectangle.height() && sizeX * (1 - kEqual) > sizeY);
    };
    if (fit.paraboloid) {
        const Vec2d size = fit.paraboloid->halfSize;
        return placeParaboloid(fit, rectangle, lookup.reach, turn.value_or(isAcross(size.x, size.y)));
    }
    Mat4d clip = fit.lightClipFromLocal;
    // Row x is 1 / half size along x (points: of the light plane), so the larger side has the smaller row.
    if (fit.pixels) {
        const double band = 2 * std::ceil(lookup.reach);
        clip.setRow(0, (1 - band / rectangle.width()) * clip.row(0));
        clip.setRow(1, (1 - band / rectangle.height()) * clip.row(1));
        return clip;
    }
    const double sizeX = 1 / length(xyz(clip.row(0))), sizeY = 1 / length(xyz(clip.row(1)));
    if (turn.value_or(isAcross(sizeX, sizeY))) turnAxes(clip);
    const double reach = lookup.reach + (fit.snapsToWorld ? 0.5 : 0.0);
    clip.setRow(0, shrink(rectangle.width(), reach) * clip.row(0));
    clip.setRow(1, shrink(rectangle.height(), reach) * clip.row(1));
    if (fit.snapsToWorld && rectangle.width() > 1) snapRow(clip, 0, rectangle.width(), originWorld);
    if (fit.snapsToWorld && rectangle.height() > 1) snapRow(clip, 1, rectangle.height(), originWorld);
    return clip;
}

Vec2d guardBand(const LixelRectangle& rectangle, const LookupLayout& lookup)
{
    const auto along = [&](int lixels) {
        return std::max(0.0, std::min(lookup.reach, 0.5 * lixels - 0.5) - kRounding);
    };
    return {along(rectangle.width()), along(rectangle.height())};
}

} // namespace lixel
