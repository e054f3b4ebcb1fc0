// SPDX-License-Identifier: MIT
#include "lixel/base/enclosing_polygon.h"

#include "lixel/base/rectangle.h"
#include "support/random_cases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lixel {
namespace {

using test::Rng;

std::vector<Vec2d> anyHull(Rng& rng)
{
    std::vector<Vec2d> points;
    const double flat = rng.logUniform(1e-3, 1), size = rng.logUniform(1e-3, 1e3);
    const bool isRound = rng.chance(0.4);
    for (int i = rng.integer(4, 300); i > 0; --i) {
        const double angle = rng.uniform(0, 6.283185307179586), r = isRound ? 1 : std::sqrt(rng.uniform(0, 1));
        points.push_back({size * r * std::cos(angle), size * flat * r * std::sin(angle)});
    }
    std::vector<Vec2d> hull(points.size() + 1);
    hull.resize(convexHull(points, hull));
    return hull;
}

double areaOf(const std::vector<Vec2d>& polygon)
{
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
    return 0.5 * twice;
}

// How far inside the polygon's nearest side; negative outside.
double inside(const std::vector<Vec2d>& polygon, Vec2d p)
{
    double least = INFINITY;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2d a = polygon[i], side = polygon[(i + 1) % polygon.size()] - a;
        if (length(side) > 0) least = std::min(least, cross(side, p - a) / length(side));
    }
    return least;
}

TEST(EnclosingPolygon, HoldsThePolygonWithFewCornersAndStaysConvex)
{
    test::forEachCase(test::kCases, [](Rng& rng) {
        const std::vector<Vec2d> hull = anyHull(rng);
        const auto most = std::size_t(rng.integer(4, 12));
        std::vector<Vec2d> few = hull;
        few.resize(encloseWithFewerCorners(few, most));
        EXPECT_LE(few.size(), most);
        double size = 0;
        for (const Vec2d& p : hull) size = std::max(size, length(p));
        for (const Vec2d& p : hull) EXPECT_GE(inside(few, p), -1e-12 * size);
        for (const Vec2d& p : few) EXPECT_GE(inside(few, p), -1e-12 * size);
        EXPECT_GE(areaOf(few), areaOf(hull) * (1 - 1e-12));
    });
}

// The best polygon of n sides around a circle is the regular one, with n tan(pi / n) / pi of its area: 1.055 for eight. Dropping
// sides one by one comes near.
TEST(EnclosingPolygon, GrowsARoundPolygonByLittle)
{
    std::vector<Vec2d> circle;
    for (int i = 0; i < 200; ++i) circle.push_back({std::cos(0.0314159265 * i), std::sin(0.0314159265 * i)});
    const double area = areaOf(circle);
    circle.resize(encloseWithFewerCorners(circle, 8));
    EXPECT_EQ(circle.size(), 8u);
    EXPECT_LT(areaOf(circle), 1.09 * area);
}

TEST(EnclosingPolygon, WhatHasFewCornersStaysAsItIs)
{
    std::vector<Vec2d> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const std::vector<Vec2d> before = square;
    EXPECT_EQ(encloseWithFewerCorners(square, 4), 4u);
    EXPECT_EQ(square, before);
}

} // namespace
} // namespace lixel
