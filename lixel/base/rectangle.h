// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/vec.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace lixel {

// The convex hull's corners, counter-clockwise, no three in line but for rounding (Andrew's monotone chain, 1979). Sorts `points`; writes the
// corners to `hull`, which needs room for one more than there are points, and returns how many: fewer than three where the
// points lie on a line or are one.
std::size_t convexHull(std::span<Vec2d> points, std::span<Vec2d> hull);

// The same for points that remember who they are.
struct NumberedPoint
{
    Vec2d p;
    std::uint32_t number = 0;
};
std::size_t convexHull(std::span<NumberedPoint> points, std::span<NumberedPoint> hull);

// Tells of most points at once that they are no corners of the hull of all: they lie well inside eight extreme ones (S. Akl,
// G. Toussaint. A Fast Convex Hull Algorithm. 1978). What it does not call inner may be a corner or not.
class HullSieve
{
public:
    // A point counts as inner up to `beyond` outside the octagon, against the size of it all. Negative: that much inside.
    HullSieve(std::span<const Vec2d> points, double beyond);
    bool isInner(Vec2d p) const
    {
        if (p.x > low_.x && p.x < high_.x && p.y > low_.y && p.y < high_.y) return true;
        if (!isWorthwhile_) return false;
        for (std::size_t k = 0; k < 8; ++k)
            if (!(dot(normal_[k], p) + offset_[k] > 0)) return false;
        return std::find(corner_.begin(), corner_.end(), p) == corner_.end();
    }

private:
    Vec2d low_{1, 1}, high_{-1, -1};           // a box inside the octagon of extreme points
    std::array<Vec2d, 8> corner_{}, normal_{}; // the octagon, and its sides, inside positive
    std::array<double, 8> offset_{};
    bool isWorthwhile_ = false;
};

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
