// SPDX-License-Identifier: MIT
#include "lixel/base/rectangle.h"

#include "support/random_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <vector>

namespace lixel {
namespace {

using test::forEachCase;
using test::Rng;

std::vector<Vec2d> anyPoints(Rng& rng)
{
    std::vector<Vec2d> points;
    const bool onGrid = rng.chance(0.3); // many in line, many the same
    const double flat = rng.logUniform(1e-3, 1), angle = rng.uniform(0, 6.3);
    for (int i = rng.integer(1, rng.chance(0.2) ? 400 : 60); i > 0; --i) {
        const Vec2d p = onGrid ? Vec2d{double(rng.integer(-3, 3)), double(rng.integer(-3, 3))}
                               : Vec2d{rng.uniform(-1, 1), flat * rng.uniform(-1, 1)};
        points.push_back(
            {std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y});
    }
    return points;
}

std::vector<Vec2d> hullOf(std::vector<Vec2d> points)
{
    std::vector<Vec2d> hull(points.size() + 1);
    hull.resize(convexHull(points, hull));
    return hull;
}

TEST(ConvexHull, HoldsEveryPointAndTurnsLeftAtEveryCorner)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const std::vector<Vec2d> points = anyPoints(rng), hull = hullOf(points);
        for (std::size_t i = 0; i < hull.size() && hull.size() > 2; ++i) {
            const Vec2d a = hull[i], b = hull[(i + 1) % hull.size()], c = hull[(i + 2) % hull.size()];
            // In a sliver of points nearly in line, rounding decides the sign: of products of coordinates up to 5.
            EXPECT_GT(cross(b - a, c - b), -4 * 5 * 5 * 0x1p-53);
            for (const Vec2d& p : points) EXPECT_GE(cross(b - a, p - a), -1e-12);
        }
    });
}

// Rounding puts such points on either side of lines between others, now and then not the same side for both chains of the hull.
TEST(ConvexHull, OfPointsInLineButForRoundingHasNoMoreCornersThanPoints)
{
    const auto any = [](Rng& rng) { return Vec2d{rng.uniform(-1, 1), rng.uniform(-1, 1)}; };
    forEachCase(100 * test::kCases, [&](Rng& rng) {
        const Vec2d from = any(rng), along = any(rng);
        std::vector<Vec2d> points;
        for (int i = rng.integer(4, 8); i > 0; --i) points.push_back(from + rng.uniform(-1, 1) * along);
        const std::size_t count = points.size();
        const Vec2d untouched{7, 7};
        std::vector<Vec2d> hull(2 * count, untouched);
        EXPECT_LE(convexHull(points, {hull.data(), count + 1}), count);
        for (std::size_t i = count + 1; i < hull.size(); ++i) EXPECT_EQ(hull[i], untouched);
    });
}

TEST(MinimumAreaRectangle, HoldsEveryPointHasASideOnTheHullAndIsNoLargerThanAnyTriedAngle)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const std::vector<Vec2d> points = anyPoints(rng), hull = hullOf(points);
        const OrientedRectangle r = minimumAreaRectangle(hull);
        const Vec2d side{-r.axis.y, r.axis.x};
        for (const Vec2d& p : points) {
            EXPECT_LE(std::abs(dot(r.axis, p - r.centre)), r.halfSize.x + 1e-12);
            EXPECT_LE(std::abs(dot(side, p - r.centre)), r.halfSize.y + 1e-12);
        }
        if (hull.size() < 3) return;
        double closest = 1;
        for (std::size_t i = 0; i < hull.size(); ++i) {
            const Vec2d edge = hull[(i + 1) % hull.size()] - hull[i];
            closest = std::min(
                {closest, std::abs(cross(r.axis, edge)) / length(edge), std::abs(dot(r.axis, edge)) / length(edge)});
        }
        EXPECT_LT(closest, 1e-12);
        for (int i = 0; i < 90; ++i) {
            const double angle = i * std::numbers::pi / 180;
            EXPECT_LE(r.area(), rectangleAlong(points, {std::cos(angle), std::sin(angle)}).area() + 1e-12);
        }
    });
}

// Points that come another way, rounded otherwise, give the same map: no turned or mirrored one among equals.
TEST(MinimumAreaRectangle, OfPointsMovedByRoundingIsTheSameButForRounding)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const double angle = rng.uniform(0, 6.3), wide = rng.uniform(0.2, 2), high = rng.uniform(0.2, 2);
        const Vec2d axis{std::cos(angle), std::sin(angle)}, side{-axis.y, axis.x};
        std::vector<Vec2d> corners, moved;
        for (const double x : {-wide, wide})
            for (const double y : {-high, high}) {
                corners.push_back(x * axis + y * side);
                moved.push_back(corners.back() + 1e-14 * Vec2d{rng.uniform(-1, 1), rng.uniform(-1, 1)});
            }
        const OrientedRectangle r = minimumAreaRectangle(hullOf(corners)), s = minimumAreaRectangle(hullOf(moved));
        EXPECT_GT(dot(r.axis, s.axis), 1 - 1e-9);
        EXPECT_NEAR(r.halfSize.x, s.halfSize.x, 1e-12);
    });
}

TEST(MinimumAreaRectangle, OfAPointOrALineIsThatPointOrLine)
{
    const std::vector<Vec2d> one{{2, 3}}, line{{0, 0}, {3, 4}};
    EXPECT_EQ(minimumAreaRectangle(one).area(), 0);
    const OrientedRectangle r = minimumAreaRectangle(line);
    EXPECT_NEAR(r.halfSize.x, 2.5, 1e-15);
    EXPECT_NEAR(r.halfSize.y, 0, 1e-15);
}

} // namespace
} // namespace lixel
