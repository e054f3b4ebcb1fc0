// SPDX-License-Identifier: MIT
#include "lixel/base/rectangle.h"

#include "lixel/base/assert.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace lixel {

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

namespace {

// Moves points that are well inside an octagon of eight extreme ones behind the others (Akl & Toussaint 1978) and returns how many
// others there are: sorting is what a hull costs.
std::size_t leaveOutInner(std::span<Vec2d> points)
{
    constexpr std::size_t kWorthwhile = 32;
    if (points.size() < kWorthwhile) return points.size();
    constexpr std::array<Vec2d, 8> kTowards{{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
    std::array<Vec2d, 8> extreme;
    extreme.fill(points[0]);
    for (const Vec2d& p : points)
        for (std::size_t k = 0; k < 8; ++k)
            if (dot(kTowards[k], p - extreme[k]) > 0) extreme[k] = p;
    if (extreme[0] == extreme[4] && extreme[2] == extreme[6]) return points.size();
    // Sides as lines, inside positive, less a little for rounding; corners that are one have no side between them.
    std::array<Vec2d, 8> normal;
    std::array<double, 8> offset;
    for (std::size_t k = 0; k < 8; ++k) {
        const Vec2d side = extreme[(k + 1) % 8] - extreme[k];
        normal[k] = {-side.y, side.x};
        const double terms = std::abs(side.y * extreme[k].x) + std::abs(side.x * extreme[k].y);
        offset[k] = side == Vec2d{} ? 1 : -dot(normal[k], extreme[k]) - 1e-12 * terms;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        bool isInner = true;
        for (std::size_t k = 0; k < 8 && isInner; ++k) isInner = dot(normal[k], points[i]) + offset[k] > 0;
        if (!isInner) std::swap(points[kept++], points[i]);
    }
    return kept;
}

} // namespace

std::size_t convexHull(std::span<Vec2d> points, std::span<Vec2d> hull)
{
    LX_ASSERT(hull.size() > points.size());
    points = points.first(leaveOutInner(points));
    std::sort(points.begin(), points.end(), [](Vec2d a, Vec2d b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    const auto count = std::size_t(std::unique(points.begin(), points.end()) - points.begin());
    if (count < 3) {
        std::copy_n(points.begin(), count, hull.begin());
        return count;
    }

    // Lower chain from left to right, then the upper one back; a corner stays only where the chain turns left.
    std::size_t size = 0;
    const auto extend = [&](Vec2d p, std::size_t chainStart) {
        while (size >= chainStart + 2 && cross(hull[size - 1] - hull[size - 2], p - hull[size - 1]) <= 0) --size;
        hull[size++] = p;
    };
    for (std::size_t i = 0; i < count; ++i) extend(points[i], 0);
    const std::size_t upperStart = size - 1;
    for (std::size_t i = count - 1; i-- > 0;) extend(points[i], upperStart);
    return size - 1;
}

OrientedRectangle minimumAreaRectangle(std::span<const Vec2d> hull)
{
    LX_ASSERT(!hull.empty());
    if (hull.size() == 1) return rectangleAlong(hull, {1, 0});
    if (hull.size() == 2) return rectangleAlong(hull, (1 / length(hull[1] - hull[0])) * (hull[1] - hull[0]));

    // As the first side turns through the hull's sides, the corners that the other three touch only move on.
    const std::size_t n = hull.size();
    const auto next = [n](std::size_t i) { return i + 1 == n ? 0 : i + 1; };
    const auto advance = [&](std::size_t k, Vec2d towards) {
        for (std::size_t steps = 0; steps < n && dot(towards, hull[next(k)] - hull[k]) >= 0; ++steps) k = next(k);
        return k;
    };
    const auto perimeter = [](const OrientedRectangle& r) { return r.halfSize.x + r.halfSize.y; };
    std::size_t right = 0, top = 0, left = 0;
    OrientedRectangle best;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2d edge = hull[next(i)] - hull[i];
        const Vec2d axis = (1 / length(edge)) * edge, side{-axis.y, axis.x};
        right = advance(i == 0 ? next(i) : right, axis);
        top = advance(i == 0 ? right : top, side);
        left = advance(i == 0 ? top : left, -1.0 * axis);
        const double x0 = dot(axis, hull[left]), x1 = dot(axis, hull[right]);
        const double y0 = dot(side, hull[i]), y1 = dot(side, hull[top]);
        const OrientedRectangle candidate{
            0.5 * (x0 + x1) * axis + 0.5 * (y0 + y1) * side, axis, {0.5 * (x1 - x0), 0.5 * (y1 - y0)}};
        if (i == 0 || candidate.area() < best.area() ||
            (candidate.area() <= best.area() && perimeter(candidate) < perimeter(best)))
            best = candidate;
    }
    return best;
}

} // namespace lixel
