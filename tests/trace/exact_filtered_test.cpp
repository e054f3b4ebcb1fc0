// SPDX-License-Identifier: MIT
#include "lixel/trace/exact_filtered.h"

#include "lixel/plan/light_image.h"
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
    const std::vector<float> filtered = exactFiltered(s.scene, s.plan.lights[0], s.samples, s.sun, 1e-6, 2);
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
    const std::vector<float> filtered = exactFiltered(s.scene, s.plan.lights[0], s.samples, s.sun, side, 32);
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

// What percentage closer filtering is an estimate of: finer maps with as wide a filter in the world come nearer to it.
TEST(ExactFiltered, IsWhatPercentageCloserFilteringTendsTo)
{
    const HalfShade s({0.3, -1, 0.2}, 64);
    const std::vector<float> filtered = exactFiltered(s.scene, s.plan.lights[0], s.samples, s.sun, 3, 16);
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
