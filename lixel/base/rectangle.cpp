// SPDX-License-Identifier: MIT
#include "lixel/base/rectangle.h"

#include "lixel/base/assert.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace lixel {
namespace {

// Areas and perimeters closer than this share are equal but for rounding.
constexpr double kEqual = 1e-9;

// Corners nearer to each other than this share of the hull are one corner, come to twice: what is between them has no direction.
constexpr double kLeastSide = 1e-9;

// By so much of the hull's size a corner may lie behind its neighbours by rounding alone.
constexpr double kDent = 1e-13;

// Of all names of a rectangle, and of all equal rectangles, the one whose axis is nearest to this direction, 17 degrees up:
// then no two of those that regular shapes have (multiples of 15 and of 22.5 degrees) are equally near.
constexpr Vec2d kPreferredAxis{0.95630475596303544, 0.29237170472273677};

OrientedRectangle preferredName(OrientedRectangle r)
{
    OrientedRectangle preferred = r;
    for (int quarter = 1; quarter < 4; ++quarter) {
        r = {r.centre, {-r.axis.y, r.axis.x}, {r.halfSize.y, r.halfSize.x}};
        if (dot(r.axis, kPreferredAxis) > dot(preferred.axis, kPreferredAxis)) preferred = r;
    }
    return preferred;
}

bool isBetter(const OrientedRectangle& a, const OrientedRectangle& b)
{
    const double perimeterA = a.halfSize.x + a.halfSize.y, perimeterB = b.halfSize.x + b.halfSize.y;
    const auto differ = [](double x, double y) { return std::abs(x - y) > kEqual * std::max(x, y); };
    if (differ(a.area(), b.area())) return a.area() < b.area();
    if (differ(perimeterA, perimeterB)) return perimeterA < perimeterB;
    return dot(a.axis, kPreferredAxis) > dot(b.axis, kPreferredAxis);
}

Vec2d placeOf(Vec2d p) { return p; }
Vec2d placeOf(const NumberedPoint& p) { return p.p; }

template <typename Point>
std::size_t hullOf(std::span<Point> points, std::span<Point> hull)
{
    std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) {
        const Vec2d p = placeOf(a), q = placeOf(b);
        return p.x < q.x || (p.x == q.x && p.y < q.y);
    });
    const auto isSame = [](const Point& a, const Point& b) { return placeOf(a) == placeOf(b); };
    const auto count = std::size_t(std::unique(points.begin(), points.end(), isSame) - points.begin());
    if (count < 3) {
        std::copy_n(points.begin(), count, hull.begin());
        return count;
    }

    // Lower chain from left to right, then the upper one back; a corner stays only where the chain turns left. Each point is asked
    // in one of them only, by the line between the ends: of points in line but for rounding both chains would keep some.
    std::size_t size = 0;
    const auto extend = [&](const Point& point, std::size_t chainStart) {
        const Vec2d p = placeOf(point);
        while (size >= chainStart + 2) {
            const Vec2d last = placeOf(hull[size - 1]);
            if (cross(last - placeOf(hull[size - 2]), p - last) > 0) break;
            --size;
        }
        hull[size++] = point;
    };
    const Vec2d first = placeOf(points[0]), across = placeOf(points[count - 1]) - first;
    const auto isAbove = [&](const Point& point) { return cross(across, placeOf(point) - first) > 0; };
    extend(points[0], 0);
    for (std::size_t i = 1; i + 1 < count; ++i)
        if (!isAbove(points[i])) extend(points[i], 0);
    extend(points[count - 1], 0);
    const std::size_t upperStart = size - 1;
    for (std::size_t i = count - 1; i-- > 1;)
        if (isAbove(points[i])) extend(points[i], upperStart);
    extend(points[0], upperStart);
    return size - 1;
}

} // namespace

OrientedRectangle rectangleAlong(std::span<const Vec2d> points, Vec2d axis)
{
    LX_ASSERT(!points.empty());
    const Vec2d side{-axis.y, axis.x};
    Vec2d low{dot(axis, points[0]), dot(side, points[0])}, high = low;
    for (const Vec2d& p : points) {
        const Vec2d q{dot(axis, p), dot(side, p)};
        low = {std::min(low.x, q.x), std::min(low.y, q.y)};
        high = {std::max(high.x, q.x), std::max(high.y, q.y)};
    }
    const Vec2d middle = 0.5 * (low + high);
    return {middle.x * axis + middle.y * side, axis, 0.5 * (high - low)};
}

HullSieve::HullSieve(std::span<const Vec2d> points, double beyond) : points_(points)
{
    constexpr std::size_t kWorthwhile = 32;
    if (points.size() < kWorthwhile) return;
    std::array<double, 8> most;
    most.fill(-std::numeric_limits<double>::infinity());
    const auto take = [&](std::size_t k, double along, std::size_t i) {
        if (along > most[k]) most[k] = along, extreme_[k] = i;
    };
    // Of many points some give nearly as large an octagon; a number that divides few others meets all corners of boxes.
    const std::size_t step = points.size() < 8 * kWorthwhile ? 1 : 3;
    for (std::size_t i = 0; i < points.size(); i += step) {
        const Vec2d p = points[i];
        const double sum = p.x + p.y, difference = p.y - p.x;
        take(0, p.x, i), take(1, sum, i), take(2, p.y, i), take(3, difference, i);
        take(4, -p.x, i), take(5, -sum, i), take(6, -p.y, i), take(7, -difference, i);
    }
    const double width = most[0] + most[4], height = most[2] + most[6];
    if (!(width > 0 || height > 0)) return;

    // Sides as lines; corners that are one have no side between them.
    isWorthwhile_ = true;
    for (std::size_t k = 0; k < 8; ++k) {
        const Vec2d from = points[extreme_[k]], side = points[extreme_[(k + 1) % 8]] - from;
        normal_[k] = {-side.y, side.x};
        offset_[k] = side == Vec2d{} ? 1 : -dot(normal_[k], from) + beyond * (width + height) * length(side);
    }
}

void HullSieve::flagOuter(std::size_t begin, std::size_t count, Flags& isOuter) const
{
    isOuter.fill(isWorthwhile_ ? 0 : 1);
    if (!isWorthwhile_) return;
    Flags x, y, least;
    for (std::size_t i = 0; i < count; ++i) x[i] = points_[begin + i].x, y[i] = points_[begin + i].y;
    least.fill(std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k < 8; k += 4) { // four sides at once: what stays in registers is not stored for each
        const std::array<Vec2d, 4> n{normal_[k], normal_[k + 1], normal_[k + 2], normal_[k + 3]};
        const std::array<double, 4> d{offset_[k], offset_[k + 1], offset_[k + 2], offset_[k + 3]};
        for (std::size_t i = 0; i < count; ++i) {
            const double one = std::min(n[0].x * x[i] + n[0].y * y[i] + d[0], n[1].x * x[i] + n[1].y * y[i] + d[1]);
            const double two = std::min(n[2].x * x[i] + n[2].y * y[i] + d[2], n[3].x * x[i] + n[3].y * y[i] + d[3]);
            least[i] = std::min(std::min(one, two), least[i]);
        }
    }
    for (std::size_t i = 0; i < count; ++i) isOuter[i] = least[i] > 0 ? 0.0 : 1.0;
    // The octagon's own corners are corners of all, however far beyond it a point counts as inner.
    for (const std::size_t corner : extreme_)
        if (corner >= begin && corner < begin + count) isOuter[corner - begin] = 1;
}

std::size_t convexHull(std::span<Vec2d> points, std::span<Vec2d> hull)
{
    LX_ASSERT(hull.size() > points.size());
    // Sorting is what a hull costs: most points are left out before.
    std::size_t kept = 0;
    HullSieve(points, -kLeastSide).forEachOuter([&](std::size_t i) { std::swap(points[kept++], points[i]); });
    return hullOf(points.first(kept), hull);
}

std::size_t convexHull(std::span<NumberedPoint> points, std::span<NumberedPoint> hull)
{
    LX_ASSERT(hull.size() > points.size());
    return hullOf(points, hull);
}

OrientedRectangle minimumAreaRectangle(std::span<const Vec2d> hull)
{
    LX_ASSERT(!hull.empty());
    if (hull.size() == 1) return rectangleAlong(hull, {1, 0});
    if (hull.size() == 2)
        return preferredName(rectangleAlong(hull, (1 / length(hull[1] - hull[0])) * (hull[1] - hull[0])));

    // As the first side turns through the hull's sides, the corners that the other three touch only move on.
    const std::size_t n = hull.size();
    const double size = 2 * length(rectangleAlong(hull, {1, 0}).halfSize);
    const auto next = [n](std::size_t i) { return i + 1 == n ? 0 : i + 1; };
    const auto advance = [&](std::size_t k, Vec2d towards) {
        for (std::size_t steps = 0; steps < n && dot(towards, hull[next(k)] - hull[k]) >= -kDent * size; ++steps)
            k = next(k);
        return k;
    };
    std::size_t right = 0, top = 0, left = 0;
    std::optional<OrientedRectangle> best;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2d edge = hull[next(i)] - hull[i];
        if (length(edge) <= kLeastSide * size) continue;
        const Vec2d axis = (1 / length(edge)) * edge, side{-axis.y, axis.x};
        right = advance(best ? right : next(i), axis);
        top = advance(best ? top : right, side);
        left = advance(best ? left : top, -1.0 * axis);
        const double x0 = dot(axis, hull[left]), x1 = dot(axis, hull[right]);
        const double y0 = dot(side, hull[i]), y1 = dot(side, hull[top]);
        const OrientedRectangle candidate =
            preferredName({0.5 * (x0 + x1) * axis + 0.5 * (y0 + y1) * side, axis, {0.5 * (x1 - x0), 0.5 * (y1 - y0)}});
        if (!best || isBetter(candidate, *best)) best = candidate;
    }
    LX_ASSERT(best); // of n sides around the hull one is longer than its size over n
    return *best;
}

} // namespace lixel
