// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/vec.h"

#include <cstddef>
#include <span>

namespace lixel {

// The convex hull's corners, counter-clockwise, no three in line but for rounding (Andrew's monotone chain, 1979). Sorts `points`; writes the
// corners to `hull`, which needs room for one more than there are points, and returns how many: fewer than three where the
// points lie on a line or are one.
std::size_t convexHull(std::span<Vec2d> points, std::span<Vec2d> hull);

// A rectangle of any orientation: centre + a * halfSize.x * axis + b * halfSize.y * perpendicular(axis), a, b in [-1, 1].
struct OrientedRectangle
{
    Vec2d centre;
    Vec2d axis{1, 0}; // unit; the second axis is (-axis.y, axis.x)
    Vec2d halfSize;   // zero in a direction where all points are one

    double area() const { return 4 * halfSize.x * halfSize.y; }
};

// The smallest rectangle that holds a convex hull as convexHull() gives it: one of its sides lies on a side of the hull
// (Freeman & Shapira 1975; found with rotating calipers, Toussaint 1983). Among areas that are
// equal but for rounding the one with the smaller perimeter, then by the axis; and of the four names of a rectangle always
// the same: points that differ by rounding give rectangles that do. Needs a point.
OrientedRectangle minimumAreaRectangle(std::span<const Vec2d> hull);

// The tightest rectangle with the given direction of its first side, a unit vector. Needs a point.
OrientedRectangle rectangleAlong(std::span<const Vec2d> points, Vec2d axis);

} // namespace lixel
