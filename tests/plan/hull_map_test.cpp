// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/hull_map.h"

#include "lixel/base/rectangle.h"
#include "lixel/plan/fit/lixel_energy.h"
#include "support/random_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace lixel {
namespace {

using namespace test;

// Any hull on the light plane, around its middle or not, and an axis that has it all before it.
struct AnyHull
{
    std::vector<Vec3d> corners;
    std::vector<Vec2d> room;
    double aspect;
    Vec3d w;

    explicit AnyHull(Rng& rng, double aspectOfMap = 0)
        : aspect(aspectOfMap > 0   ? aspectOfMap
                 : rng.chance(0.3) ? 1
                                   : rng.logUniform(0.2, 5))
    {
        std::vector<Vec2d> points, hull;
        const Vec2d stretch{rng.logUniform(0.05, 1), rng.logUniform(0.05, 1)},
            centre{rng.uniform(-1, 1), rng.uniform(-1, 1)};
        for (int i = rng.integer(3, 30); i > 0; --i)
            points.push_back(centre + Vec2d{stretch.x * rng.uniform(-1, 1), stretch.y * rng.uniform(-1, 1)});
        hull.resize(points.size() + 1);
        hull.resize(convexHull(points, hull));
        for (const Vec2d& p : hull) {
            const double depth = rng.logUniform(0.1, 10);
            corners.push_back(depth * Vec3d{p.x, p.y, 1});
        }
        do w = {rng.uniform(-1, 1), rng.uniform(-1, 1), 1};
        while (!isBefore());
        w = rng.logUniform(0.1, 10) * w;
    }

    bool isBefore() const
    {
        return std::ranges::all_of(corners, [this](Vec3d r) { return dot(w, r) > 0.05 * r.z; });
    }
    HullMaps looking()
    {
        HullMaps maps(corners, aspect, room);
        EXPECT_TRUE(maps.lookAlong(w));
        return maps;
    }
};

Vec2d mapped(const PlaneWarp& map, Vec3d r) { return {dot(map.x, r) / dot(map.w, r), dot(map.y, r) / dot(map.w, r)}; }

struct Reach
{
    double left = INFINITY, right = -INFINITY, low = INFINITY, high = -INFINITY;
};
Reach reachOf(const PlaneWarp& map, const AnyHull& hull)
{
    Reach reach;
    for (const Vec3d& r : hull.corners) {
        const Vec2d u = mapped(map, r);
        reach.left = std::min(reach.left, u.x), reach.right = std::max(reach.right, u.x);
        reach.low = std::min(reach.low, u.y), reach.high = std::max(reach.high, u.y);
    }
    return reach;
}

// The hull, as the light sees it along an axis, on orthonormal axes of its own.
std::vector<Vec2d> imageOf(const AnyHull& hull)
{
    const Vec3d w = normalized(hull.w), e1 = anyPerpendicular(w), e2 = cross(w, e1);
    std::vector<Vec2d> image;
    for (const Vec3d& r : hull.corners) image.push_back((1 / dot(w, r)) * Vec2d{dot(e1, r), dot(e2, r)});
    return image;
}

TEST(HullMaps, EveryMapHoldsTheHullAndTouchesAllItsSides)
{
    forEachCase(kCases, [](Rng& rng) {
        AnyHull hull(rng);
        HullMaps maps = hull.looking();
        const double x = 0.5 * std::sqrt(hull.aspect), y = 0.25 / x;
        for (std::size_t i = 0; i < maps.sideCount(); ++i)
            for (const bool isSheared : {false, true})
                for (const bool isTurned : {false, true}) {
                    const HullMaps::Sides sides = isSheared ? maps.sheared(maps.sides(i)) : maps.sides(i);
                    const Reach reach = reachOf(maps.rows(sides, isTurned), hull);
                    EXPECT_NEAR(reach.left, -x, 1e-9 * x);
                    EXPECT_NEAR(reach.right, x, 1e-9 * x);
                    EXPECT_NEAR(reach.low, -y, 1e-9 * y);
                    EXPECT_NEAR(reach.high, y, 1e-9 * y);
                }
    });
}

TEST(HullMaps, ASideOfTheMapLiesOnASideOfTheHull)
{
    forEachCase(kCases, [](Rng& rng) {
        AnyHull hull(rng, 1);
        HullMaps maps = hull.looking();
        ASSERT_EQ(maps.sideCount(), hull.corners.size() + 1);
        for (std::size_t i = 0; i + 1 < maps.sideCount(); ++i) {
            const PlaneWarp map = maps.rows(maps.sides(i), false);
            const double a = mapped(map, hull.corners[i]).y,
                         b = mapped(map, hull.corners[(i + 1) % hull.corners.size()]).y;
            EXPECT_NEAR(a, -0.5, 1e-9);
            EXPECT_NEAR(b, -0.5, 1e-9);
        }
        // The last stands upright on the way in which w grows: along u at w constant, that is.
        const PlaneWarp last = maps.rows(maps.sides(maps.sideCount() - 1), false);
        const Vec3d alongX = dualBasis(last).b1;
        EXPECT_NEAR(alongX.z, 0, 1e-12 * length(alongX));
    });
}

// Rows without shear are at right angles, as long as the map's sides ask, and w is the axis.
TEST(HullMaps, RowsAreARectanglesOnTheImage)
{
    forEachCase(kCases, [](Rng& rng) {
        AnyHull hull(rng);
        HullMaps maps = hull.looking();
        const Vec3d w = normalized(hull.w);
        for (const bool isTurned : {false, true}) {
            const HullMaps::Sides sides = maps.sides(std::size_t(rng.integer(0, int(maps.sideCount()) - 1)));
            const PlaneWarp map = maps.rows(sides, isTurned);
            const Vec3d x = map.x - dot(map.x, w) * w, y = map.y - dot(map.y, w) * w;
            EXPECT_NEAR(dot(x, y), 0, 1e-9 * length(x) * length(y));
            EXPECT_GT(dot(x, cross(y, w)), 0); // turned, not mirrored
            EXPECT_LT(length(map.w - w), 1e-12);
            const double across = 2 * (isTurned ? sides.half.y : sides.half.x),
                         along = 2 * (isTurned ? sides.half.x : sides.half.y);
            EXPECT_NEAR(length(x) * across, std::sqrt(hull.aspect), 1e-9 * std::sqrt(hull.aspect));
            EXPECT_NEAR(length(y) * along, 1 / std::sqrt(hull.aspect), 1e-9 / std::sqrt(hull.aspect));
        }
    });
}

TEST(HullMaps, StepsAreTheRowsDualBasis)
{
    forEachCase(kCases, [](Rng& rng) {
        AnyHull hull(rng);
        HullMaps maps = hull.looking();
        for (const bool isSheared : {false, true})
            for (const bool isTurned : {false, true}) {
                const HullMaps::Sides upright = maps.sides(std::size_t(rng.integer(0, int(maps.sideCount()) - 1)));
                const HullMaps::Sides sides = isSheared ? maps.sheared(upright) : upright;
                const DualBasis dual = dualBasis(maps.rows(sides, isTurned));
                const HullMaps::Steps steps = maps.steps(sides, isTurned);
                EXPECT_LT(length(steps.alongX - dual.b1), 1e-9 * length(dual.b1));
                EXPECT_LT(length(steps.alongY - dual.b2), 1e-9 * length(dual.b2));
            }
    });
}

TEST(HullMaps, TheLeastOfItsRectanglesIsTheMinimumAreaRectangle)
{
    forEachCase(kCases, [](Rng& rng) {
        AnyHull hull(rng);
        HullMaps maps = hull.looking();
        double least = INFINITY;
        for (std::size_t i = 0; i + 1 < maps.sideCount(); ++i) least = std::min(least, 4 * maps.sides(i).area());
        EXPECT_NEAR(least, minimumAreaRectangle(imageOf(hull)).area(), 1e-9 * least);
    });
}

TEST(HullMaps, TheShearedMapIsTheLeastOfAllShears)
{
    forEachCase(kCases, [](Rng& rng) {
        AnyHull hull(rng);
        HullMaps maps = hull.looking();
        const HullMaps::Sides upright = maps.sides(std::size_t(rng.integer(0, int(maps.sideCount()) - 1)));
        const HullMaps::Sides sheared = maps.sheared(upright);
        EXPECT_LE(sheared.half.x, upright.half.x);
        EXPECT_EQ(sheared.half.y, upright.half.y);
        const PlaneWarp rectangle = maps.rows(upright, false);
        for (double shear = -5; shear <= 5; shear += 0.01) {
            double low = INFINITY, high = -INFINITY;
            for (const Vec3d& r : hull.corners) {
                const Vec2d u = mapped(rectangle, r);
                const double x = u.x + shear * u.y;
                low = std::min(low, x), high = std::max(high, x);
            }
            // Of the upright map's width.
            const double width = (high - low) / std::sqrt(hull.aspect);
            EXPECT_GE(width, sheared.half.x / upright.half.x * (1 - 1e-9));
        }
    });
}

// The figure's hull: a bottom edge, and all above lies to the left of its ends. Sheared to the right until the leftmost of what is above
// stands over the edge's left end, as the caption says, provided that the right stays within.
TEST(HullMaps, ShearsTheHullOfFigure3AsItsCaptionSays)
{
    forEachCase(kCases, [](Rng& rng) {
        // Along the frame's axis: the image is the hull itself. The edge from (0, 0) to (1, 0), tops left of its left end.
        const double lean = rng.uniform(0.05, 0.6), top = rng.uniform(0.5, 1), wide = rng.uniform(0.1, 0.5);
        AnyHull hull(rng, 1);
        const Vec2d points[] = {{0, 0}, {1, 0}, {1 - lean - wide, 0.8 * top}, {-lean, top}};
        hull.corners.clear();
        for (const Vec2d& p : points) hull.corners.push_back({p.x - 0.5, p.y - 0.5, 1});
        hull.w = {0, 0, 1};
        HullMaps maps = hull.looking();
        const HullMaps::Sides bottom = maps.sides(0);
        EXPECT_NEAR(2 * bottom.half.x, 1 + lean, 1e-12);
        const HullMaps::Sides sheared = maps.sheared(bottom);
        const PlaneWarp map = maps.rows(sheared, false);
        const Vec2d bottomLeft = mapped(map, hull.corners[0]), topLeft = mapped(map, hull.corners[3]);
        EXPECT_NEAR(topLeft.x, bottomLeft.x, 1e-9);
        EXPECT_NEAR(topLeft.x, -0.5, 1e-9);
        EXPECT_NEAR(2 * sheared.half.x, 1, 1e-9); // as wide as the edge
        EXPECT_NEAR(sheared.shear, lean / top, 1e-9);
    });
}

TEST(HullMaps, RefusesAxesThatLeaveACornerBehind)
{
    forEachCase(kCases, [](Rng& rng) {
        AnyHull hull(rng);
        HullMaps maps(hull.corners, hull.aspect, hull.room);
        const Vec3d corner = hull.corners[std::size_t(rng.integer(0, int(hull.corners.size()) - 1))];
        const Vec3d w = hull.w - (rng.uniform(1, 2) * dot(hull.w, corner) / dot(corner, corner)) * corner;
        EXPECT_FALSE(maps.lookAlong(w));
        EXPECT_TRUE(maps.lookAlong(hull.w));
    });
}

} // namespace
} // namespace lixel
