// SPDX-License-Identifier: MIT
#include "lixel/trace/exact_filtered.h"

#include "lixel/plan/light_image.h"
#include "lixel/shared/lookup/kernel.h"
#include "lixel/trace/exact_visibility.h"
#include "lixel/trace/trace_executor.h"
#include "lixel/trace/trace_view_samples.h"
#include "trace/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lixel {
namespace {

using namespace test;

// A floor half of which lies in the shadow of a plate with a straight edge, under the sun.
struct HalfShade
{
    LocalTriangles casters = triangles(joined(gridPlane(3, 4), box({-3, 1, -3}, {0, 1.01, 3})));
    TraceScene scene{casters, {}, {}};
    Light sun;
    View view = perspectiveView({1, 6, 5}, {0, 0, 0}, {0, 1, 0}, 0.9, 0.1, 100, 64, 64);
    ViewSamples samples = traceViewSamples(scene, view);
    FramePlan plan;

    explicit HalfShade(Vec3d direction, int lixels)
    {
        sun.directionWorld = normalized(direction);
        Box box;
        for (const Vec3f& p : casters.positionLocal) box.include(toDouble(p));
        plan = planShadows({view,
                            {&sun, 1},
                            {&box, 1},
                            {},
                            std::get<MapTechnique>(*parseTechnique("focused+pcf(9)")),
                            {lixels, lixels}});
    }
};

TEST(ExactFiltered, OfAFootprintOfNextToNothingIsExactVisibility)
{
    const HalfShade s({0.3, -1, 0.1}, 64);
    const std::vector<float> exact = exactVisibility(s.scene, s.samples, s.sun);
    const std::vector<float> filtered = exactFiltered(s.scene, s.plan.lights[0], s.samples, s.sun, {1e-6}, 2);
    for (std::size_t i = 0; i < exact.size(); ++i) EXPECT_EQ(filtered[i], exact[i]);
}

// Across a straight edge the share grows with the place of the sample, by a side of the footprint from dark to lit.
TEST(ExactFiltered, OfAStraightEdgeIsTheShareOfTheSquareOnItsLitSide)
{
    const HalfShade s({0, -1, 0}, 64);
    const PlannedRegion& region = s.plan.lights[0].regions.front();
    const LightImage image(region.lightClipFromLocal, region.rectangle);
    const Vec3d edge = *image.lixelAt({0, 0, 0}), beside = *image.lixelAt({1, 0, 0});
    const Vec2d across{beside.x - edge.x, beside.y - edge.y};
    const double lixels = std::hypot(across.x, across.y);
    const Vec2d n = (1 / lixels) * across;
    const double side = 3, most = 0.5 * side * (std::abs(n.x) + std::abs(n.y)),
                 least = 0.5 * side / std::max(std::abs(n.x), std::abs(n.y));
    const std::vector<float> filtered = exactFiltered(s.scene, s.plan.lights[0], s.samples, s.sun, {side}, 32);
    int between = 0;
    for (std::size_t i = 0; i < s.samples.size(); ++i) {
        const Vec3f p = s.samples.positionLocal[i];
        if (p.y != 0 || std::abs(p.z) > 2 || p.x < -2) continue;
        const double place = double(p.x) * lixels; // from the edge, lixels
        if (std::abs(place) > most) {
            EXPECT_EQ(filtered[i], place > 0 ? 1 : 0);
        }
        if (std::abs(place) < 0.2 * least) {
            EXPECT_NEAR(filtered[i], 0.5 + place / side * std::max(std::abs(n.x), std::abs(n.y)), 0.2);
            ++between;
        }
    }
    EXPECT_GT(between, 5);
}

// The share of a square of side 1 that is less than `place` along a direction: of the sum of two evenly spread numbers.
double shareBelow(double place, Vec2d direction)
{
    const double a = std::max(std::abs(direction.x), std::abs(direction.y)),
                 b = std::max(std::min(std::abs(direction.x), std::abs(direction.y)), 1e-9);
    const auto ramp = [](double x) { return x > 0 ? 0.5 * x * x : 0; };
    const double h = 0.5 * (a + b), k = 0.5 * (a - b);
    return (ramp(place + h) - ramp(place + k) - ramp(place - k) + ramp(place - h)) / (a * b);
}

// The taps of a rotated kernel, and the square that they stand for, are turned by the same angle of the sample.
TEST(ExactFiltered, OfARotatedKernelIsTheShareOfTheTurnedSquare)
{
    const HalfShade s({0, -1, 0}, 64);
    const PlannedRegion& region = s.plan.lights[0].regions.front();
    const LightImage image(region.lightClipFromLocal, region.rectangle);
    const Vec3d edge = *image.lixelAt({0, 0, 0}), beside = *image.lixelAt({1, 0, 0});
    const Vec2d across{beside.x - edge.x, beside.y - edge.y};
    const double lixels = std::hypot(across.x, across.y), side = 5;
    const shared::vec2 n{float(across.x / lixels), float(across.y / lixels)};
    const auto filtered = exactFiltered(s.scene, s.plan.lights[0], s.samples, s.sun, {side, true}, 64);
    int between = 0;
    for (std::size_t i = 0; i < s.samples.size(); ++i) {
        const Vec3f p = s.samples.positionLocal[i];
        if (p.y != 0 || std::abs(p.z) > 2 || p.x < -2) continue;
        // The edge across the square as the square sees it: turned back, which is the transpose.
        const std::uint32_t seed = shared::lxSeedOf({p.x, p.y, p.z});
        const shared::vec2 x = shared::lxTurned({1, 0}, seed), y = shared::lxTurned({0, 1}, seed);
        const double share =
            shareBelow(double(p.x) * lixels / side, {double(n.x * x.x + n.y * x.y), double(n.x * y.x + n.y * y.y)});
        EXPECT_NEAR(filtered[i], share, 0.03);
        between += share > 0.1 && share < 0.9;
    }
    EXPECT_GT(between, 20);
}

// What percentage closer filtering is an estimate of: finer maps with as wide a filter in the world come nearer to it.
TEST(ExactFiltered, IsWhatPercentageCloserFilteringTendsTo)
{
    const HalfShade s({0.3, -1, 0.2}, 64);
    const std::vector<float> filtered = exactFiltered(s.scene, s.plan.lights[0], s.samples, s.sun, {3}, 16);
    const Visibility pcf = runTraced(s.scene, s.plan, s.samples).front();
    double sum = 0, worst = 0;
    int partial = 0;
    for (std::size_t i = 0; i < s.samples.size(); ++i) {
        if (filtered[i] <= 0 || filtered[i] >= 1) continue;
        ++partial;
        sum += double(pcf.value[i] - filtered[i]);
        worst = std::max(worst, double(std::abs(pcf.value[i] - filtered[i])));
    }
    ASSERT_GT(partial, 50);
    EXPECT_LT(std::abs(sum / partial), 0.08);
    EXPECT_LT(worst, 0.5);
}

} // namespace
} // namespace lixel
