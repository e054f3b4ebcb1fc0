// SPDX-License-Identifier: MIT
#include "lixel/plan/boundary_directions.h"

#include "lixel/plan/observe.h"
#include "support/random_cases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lixel {
namespace {

using namespace test;

// A picture of one wall, lit on one side of a straight edge.
struct HalfLit
{
    Observation observation;
    Vec2d normal, through; // in the picture; towards what is lit

    HalfLit(int width, int height, ObservationGrid grid, Vec2d n, Vec2d p) : normal(n), through(p)
    {
        const View view = perspectiveView({0, 0, 1}, {0, 0, 0}, {0, 1, 0}, 1, 0.1, 10, width, height);
        ViewSamples picture;
        picture.width = width, picture.height = height;
        Visibility lit;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const Vec2d at{x + 0.5, y + 0.5};
                picture.pixel.push_back(toFloat(at));
                picture.positionLocal.push_back({float((at.x - 0.5 * width) / height), float(at.y / height - 0.5), 0});
                picture.normal.push_back({0, 0, 1});
                picture.triangle.push_back(0);
                lit.value.push_back(dot(n, at - p) > 0 ? 1.0f : 0.0f);
            }
        Light light;
        light.directionWorld = {0, 0, -1};
        observation = observe(picture, view, {&light, 1}, {&lit, 1}, grid);
    }
};

TEST(BoundaryDirections, OfAStraightEdgeAreItsNormal)
{
    double worst = 0, sum = 0;
    int count = 0;
    forEachCase(kCases, [&](Rng& rng) {
        const int width = rng.integer(40, 160), height = rng.integer(40, 160);
        const ObservationGrid grid{rng.integer(20, std::min(width, 60)), rng.integer(20, std::min(height, 60))};
        const double angle = rng.uniform(0, 2 * std::numbers::pi);
        const HalfLit half(width, height, grid, {std::cos(angle), std::sin(angle)},
                           {width * rng.uniform(0.4, 0.6), height * rng.uniform(0.4, 0.6)});
        BoundaryDirections directions;
        directions.observe(half.observation, 1);
        const ViewSamples& cells = half.observation.samples;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (!(half.observation.atBoundary[i] & 1)) continue;
            const Vec2f p = cells.pixel[i];
            // Away from the picture's border, where not all is seen.
            if (std::min({p.x / float(width), p.y / float(height), 1 - p.x / float(width), 1 - p.y / float(height)}) <
                0.15)
                continue;
            const Vec2d across = directions.acrossAt(i);
            EXPECT_NEAR(length(across), 1, 1e-9);
            // Seen in cells, whose sides may differ in length: there all angles are alike.
            const Vec2d inCells{across.x * width / grid.width, across.y * height / grid.height},
                expected{half.normal.x * width / grid.width, half.normal.y * height / grid.height};
            const double apart = std::abs(std::atan2(cross(inCells, expected), dot(inCells, expected)));
            worst = std::max(worst, apart), sum += apart, ++count;
        }
    });
    std::printf("%d samples, mean %.2f degrees, worst %.2f degrees\n", count, sum / count * 180 / std::numbers::pi,
                worst * 180 / std::numbers::pi);
    EXPECT_LT(sum / count, 5 * std::numbers::pi / 180);
    // One in two against the cells; 25.9 degrees is the worst of 831,262 samples.
    EXPECT_LT(worst, std::atan(0.5));
}

// Along the rows or columns of cells there is nothing to guess.
TEST(BoundaryDirections, AlongCellsAreExact)
{
    for (const Vec2d n : {Vec2d{1, 0}, Vec2d{-1, 0}, Vec2d{0, 1}, Vec2d{0, -1}}) {
        const HalfLit half(90, 60, {30, 30}, n, {45, 30});
        BoundaryDirections directions;
        directions.observe(half.observation, 1);
        int count = 0;
        for (std::size_t i = 0; i < half.observation.samples.size(); ++i) {
            const Vec2f p = half.observation.samples.pixel[i];
            if (!(half.observation.atBoundary[i] & 1) || std::min({p.x, p.y, 90 - p.x, 60 - p.y}) < 10) continue;
            EXPECT_NEAR(dot(directions.acrossAt(i), n), 1, 1e-12);
            ++count;
        }
        EXPECT_GT(count, 0);
    }
}

TEST(BoundaryDirections, AreNothingWhereAllIsAlikeOrASpeckIsLit)
{
    for (const double side : {-1000.0, 1000.0}) {
        const HalfLit half(60, 60, {30, 30}, {1, 0}, {side, 0});
        BoundaryDirections directions;
        directions.observe(half.observation, 1);
        EXPECT_EQ(directions.acrossAt(half.observation.samples.size() / 2), Vec2d{});
    }
    HalfLit dark(60, 60, {30, 30}, {1, 0}, {1000, 0});
    const std::size_t middle = 15 * 30 + 15;
    dark.observation.lit[middle] = 1;
    BoundaryDirections directions;
    directions.observe(dark.observation, 1);
    EXPECT_EQ(directions.acrossAt(middle), Vec2d{});
}

} // namespace
} // namespace lixel
