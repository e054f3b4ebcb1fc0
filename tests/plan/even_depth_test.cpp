// SPDX-License-Identifier: MIT
// Depths that are even in the distance from the light.
#include "lixel/plan/region_table.h"
#include "lixel/shared/lookup.h"
#include "lixel/shared/lookup/even_depth.h"
#include "plan/receivers.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lixel {
namespace {

using test::forEachCase;
using test::planOf;
using test::RandomSetup;
using test::Rng;

TEST(EvenDepth, ComesBackAndKeepsTheOrder)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const float bend = rng.chance(0.2) ? 0.0f : float(1 - rng.logUniform(1e-6, 1));
        const float depth = float(rng.logUniform(1e-6, 1)), nearer = depth + (1 - depth) * float(rng.uniform(0.01, 1));
        const float even = shared::lxEvenDepth(bend, depth);
        EXPECT_NEAR(shared::lxDepthOfEven(bend, even), depth, 1e-4f * depth + 2e-7f / (1 - bend) * depth);
        EXPECT_LE(even, shared::lxEvenDepth(bend, nearer));
        EXPECT_EQ(shared::lxEvenDepth(bend, 0), 0);
        EXPECT_NEAR(shared::lxEvenDepth(bend, 1), 1, 1e-6f);
        if (bend == 0) {
            EXPECT_EQ(even, depth);
        }
    });
}

// Of three points of a ray from a lamp, even depths are as far apart as the points are; under a sun they are the depths.
TEST(EvenDepth, OfARegionIsLinearInTheDistance)
{
    int lamps = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        const RandomSetup setup = test::anySetup(rng);
        const FramePlan frame = planOf(setup, rng.chance(0.5) ? "cube" : "dual-paraboloid");
        const ShadowPlan& plan = frame.lights.front();
        if (plan.refused || plan.regions.empty()) return;
        const PlannedRegion& region = plan.regions[std::size_t(rng.integer(0, int(plan.regions.size()) - 1))];
        const shared::ShadowRegion row = tableRow(region);
        const double bend = row.projection.z;
        if (setup.light.kind == LightKind::Directional) {
            EXPECT_LT(bend, 1e-6);
            return;
        }
        EXPECT_GT(bend, 0);
        const Box& box = setup.boxesWorld[std::size_t(rng.integer(0, int(setup.boxesWorld.size()) - 1))];
        const Vec3d light = setup.light.positionWorld - setup.originWorld;
        const Vec3d away = 0.5 * (box.min + box.max) - setup.light.positionWorld;
        std::vector<double> distances, evens;
        for (int i = 0; i < 3; ++i) {
            const double distance = rng.uniform(0.2, 1);
            const auto ndc = region.projection().ndcAt(light + distance * away);
            if (!ndc) return;
            const double depth = 0.5 - 0.5 * ndc->z; // 1 near, 0 far
            if (depth < 1e-3 || depth > 1) return;
            distances.push_back(distance);
            evens.push_back(depth / (1 - bend + bend * depth));
        }
        const double slope = (evens[1] - evens[0]) * (distances[2] - distances[0]);
        const double same = (evens[2] - evens[0]) * (distances[1] - distances[0]);
        EXPECT_NEAR(slope, same, 1e-3 * (std::abs(slope) + std::abs(same)) + 1e-9);
        ++lamps;
    });
    EXPECT_GT(lamps, 20);
}

} // namespace
} // namespace lixel
