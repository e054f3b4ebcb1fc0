// SPDX-License-Identifier: MIT
// Coverage where geometry is degenerate and lixels are few: what is planned is finite and serves every receiver, or is refused by name.
#include "plan/awkward_setups.h"

#include "plan/planed_setups.h"
#include "plan/receivers.h"

#include <gtest/gtest.h>

#include <string>

namespace lixel {
namespace {

using test::forEachCase;
using test::RandomSetup;
using test::Rng;

constexpr LixelSize kBudgets[] = {{512, 384}, {16, 16}, {512, 1}, {1, 512}, {2, 7}, {3, 3}, {1, 1}};

void expectFinite(const FramePlan& plan)
{
    for (const shared::ShadowRegion& region : plan.regionTable)
        for (int i = 0; i < 4; ++i) {
            const shared::vec4 column = region.lightClipFromLocal[i];
            EXPECT_TRUE(std::isfinite(column.x + column.y + column.z + column.w));
        }
}

void expectServed(const FramePlan& plan, const ViewSamples& samples, bool isRoomy)
{
    for (std::size_t i = 0; i < samples.size(); ++i) {
        shared::LxReceiver receiver{};
        const PlannedRegion* region = test::serving(plan, samples.positionLocal[i], samples.normal[i], receiver);
        ASSERT_NE(region, nullptr) << "unserved";
        if (isRoomy) test::expectReachInside(*region, plan.lookup, receiver);
    }
}

class Awkward : public testing::TestWithParam<const char*>
{
};

void expectAnySetupServed(Rng& rng, const char* technique)
{
    const RandomSetup setup = test::awkwardSetup(rng);
    const ViewSamples samples = test::anySamples(setup, rng);
    const LixelSize budget = kBudgets[rng.integer(0, 6)];
    PlanInput input{setup.view,
                    {&setup.light, 1},
                    setup.boxesWorld,
                    setup.originWorld,
                    std::get<MapTechnique>(*parseTechnique(technique)),
                    budget};
    if (rng.chance(0.7) || needsViewSamples(input.technique)) input.seen = &samples;
    input.seenIsAll = input.seen && rng.chance(0.5);
    test::PlanedCase planed;
    if (test::wantsMore(input.technique)) planed.giveTo(input, setup, samples, rng, false);
    const FramePlan plan = planShadows(input);
    EXPECT_LE(plan.lixelsOf(0), std::int64_t(budget.width) * budget.height);
    expectFinite(plan);
    if (!plan.lights[0].refused) expectServed(plan, samples, budget.width * budget.height >= 256);
    else if (samples.size() > 0) {
        EXPECT_NE(*plan.lights[0].refused, FitFailure::NothingInView);
    }
}

TEST_P(Awkward, SetupsHaveFinitePlansThatServeEveryReceiverOrAreRefusedByName)
{
    forEachCase(3 * test::kCases, [](Rng& rng) { expectAnySetupServed(rng, GetParam()); });
}

// Setups that many random cases came upon, where plans were wrong once.
TEST(AwkwardFinds, AreServed)
{
    struct Find
    {
        const char* technique;
        std::uint64_t seed;
    };
    for (const Find& find : {
             Find{"planes(a,b,c)+plane-optimal+else(psm)+pcf(9)", 20230028}, // rounding, cropped to what is seen
             Find{"pssm(3)+scene-optimal", 20144776},                        // a line through the light, w but rounding
             Find{"dual-paraboloid", 20333432},                              // what is seen lies all around the lamp
         }) {
        SCOPED_TRACE(find.technique);
        Rng rng(find.seed);
        expectAnySetupServed(rng, find.technique);
    }
}

constexpr const char* kTechniques[] = {"uniform",
                                       "focused",
                                       "desired-view",
                                       "desired-view(rotated)",
                                       "minimal-frustum",
                                       "psm",
                                       "psm(shift=none)",
                                       "tsm",
                                       "lispsm",
                                       "focused(stable)",
                                       "lispsm(stable)",
                                       "pssm(9)",
                                       "pssm(4)+lispsm",
                                       "pssm(3,stable)",
                                       "sdsm(3,stable)",
                                       "sdsm(4)",
                                       "sdsm(4,stable)",
                                       "cube",
                                       "cube+uniform",
                                       "cube+desired-view",
                                       "cube+psm",
                                       "dual-paraboloid",
                                       "dual-paraboloid+uniform",
                                       "dual-paraboloid+desired-view",
                                       "psm+else(cube+desired-view)",
                                       "pssm(2)+tsm+else(focused)",
                                       "uniform+else(cube)"};

INSTANTIATE_TEST_SUITE_P(Techniques, Awkward, testing::ValuesIn(kTechniques), test::testName);
INSTANTIATE_TEST_SUITE_P(Planes, Awkward, testing::ValuesIn(test::kPlaneTechniques), test::testName);
INSTANTIATE_TEST_SUITE_P(Scene, Awkward, testing::ValuesIn(test::kSceneTechniques), test::testName);

} // namespace
} // namespace lixel
