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
    // A point counts as inner up to `beyond` outside the octagon, against the size of it all. Negative: that much inside. The
    // points must stay as long as the sieve does.
    HullSieve(std::span<const Vec2d> points, double beyond);

    // Calls `take` with the number of each point that is not inner, in their order.
    template <typename Take>
    void forEachOuter(const Take& take) const
    {
        Flags isOuter;
        for (std::size_t begin = 0; begin < points_.size(); begin += isOuter.size()) {
            const std::size_t count = std::min(isOuter.size(), points_.size() - begin);
            flagOuter(begin, count, isOuter);
            for (std::size_t i = 0; i < count; ++i)
                if (isOuter[i] > 0) take(begin + i);
        }
    }

private:
    using Flags = std::array<double, 64>; // not 0: outer; as numbers they are made in vector code
    void flagOuter(std::size_t begin, std::size_t count, Flags& isOuter) const;

    std::span<const Vec2d> points_;
    std::array<std::size_t, 8> extreme_{}; // counter-clockwise from +x, each farthest along its direction, or nearly
    std::array<Vec2d, 8> normal_{};        // the sides of their octagon, inside positive
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
