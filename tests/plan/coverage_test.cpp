// SPDX-License-Identifier: MIT
// Coverage: every receiver that faces the light lies, with the lookup's whole reach, inside the map of the region that serves it,
// and whatever may shadow it projects to the same place; or the plan refuses by name.
#include "plan/ordinary_setups.h"
#include "plan/planed_setups.h"
#include "plan/receivers.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <map>

namespace lixel {
namespace {

using test::forEachCase;
using test::RandomSetup;
using test::Rng;
using test::serving;

struct Tally
{
    int cases = 0;
    std::map<std::string, int> refusals;

    int refused() const
    {
        int sum = 0;
        for (const auto& [reason, count] : refusals) sum += count;
        return sum;
    }
};

// How far a point is from the light, as its image has it.
double awayFrom(const LightProjection& projection, Vec3d p)
{
    const Vec4d c = projection.lightClipFromLocal * point(p);
    return projection.paraboloid ? length(Vec3d{c.x, c.y, c.w}) : c.w;
}

void expectCovers(const RandomSetup& setup, const char* technique, bool isOrdinary, Tally& tally, Rng& rng)
{
    const ViewSamples samples = test::anySamples(setup, rng);
    if (samples.size() == 0) return; // nothing is asked
    PlanInput input{setup.view,
                    {&setup.light, 1},
                    setup.boxesWorld,
                    setup.originWorld,
                    std::get<MapTechnique>(*parseTechnique(technique)),
                    {512, 384}};
    input.seen = &samples;
    test::PlanedCase planed;
    if (test::wantsMore(input.technique)) planed.giveTo(input, setup, samples, rng, isOrdinary);
    const FramePlan plan = planShadows(input);
    ++tally.cases;
    if (plan.lights[0].refused) {
        ++tally.refusals[std::string(nameOf(*plan.lights[0].refused))];
        return;
    }
    EXPECT_LE(plan.lixelsOf(0), 512 * 384);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        shared::LxReceiver receiver{};
        const PlannedRegion* region = serving(plan, samples.positionLocal[i], samples.normal[i], receiver);
        ASSERT_NE(region, nullptr) << technique << ": unserved";
        test::expectReachInside(*region, plan.lookup, receiver);
        const Vec3d p = toDouble(samples.positionLocal[i]);
        const LightProjection projection = region->projection();
        const auto at = projection.ndcAt(p);
        ASSERT_TRUE(at);
        EXPECT_LE(at->z, 1);
        // Anything between it and the light is drawn in the same place, no farther.
        const Vec3d toLight = towardsLight(setup.light, setup.originWorld, p);
        const Vec3d caster = p + rng.uniform(0, 0.5) * setup.radius * toLight;
        if (setup.light.kind != LightKind::Directional &&
            dot(toLight, setup.light.positionWorld - setup.originWorld - caster) <= 0)
            continue; // beyond it
        const double perNearness = awayFrom(projection, p) / awayFrom(projection, caster);
        const auto before = projection.ndcAt(caster);
        if (before && perNearness < 1e6) {
            EXPECT_NEAR(before->x, at->x, 1e-5 * perNearness) << technique;
            EXPECT_NEAR(before->y, at->y, 1e-5 * perNearness) << technique;
            EXPECT_LE(before->z, at->z + 1e-9) << technique;
        }
    }
}

void print(const char* technique, const Tally& tally)
{
    std::printf("%-28s %d cases", technique, tally.cases);
    for (const auto& [reason, count] : tally.refusals) std::printf(", %s %d", reason.c_str(), count);
    std::printf("\n");
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
                                       "pssm(4)",
                                       "pssm(4)+lispsm",
                                       "pssm(3,stable)",
                                       "sdsm(4)",
                                       "sdsm(4)+lispsm",
                                       "cube",
                                       "cube+desired-view",
                                       "cube+psm",
                                       "dual-paraboloid",
                                       "dual-paraboloid+uniform",
                                       "dual-paraboloid+desired-view",
                                       "dual-paraboloid+desired-view+now(grid=64)",
                                       "psm+else(cube+desired-view)",
                                       "pssm(2)+tsm+else(focused)",
                                       "now(importance=count*edges,grid=64)",
                                       "cube+desired-view+rtw(grid=64)",
                                       "lispsm+now(smooth=0,power=1,floor=0,lines=nearest,grid=32)+pcf(9)"};

class Coverage : public testing::TestWithParam<const char*>
{
};

TEST_P(Coverage, HoldsForEveryReceiverOfAnySetupOrIsRefusedByName)
{
    Tally tally;
    forEachCase(test::kCases, [&](Rng& rng) { expectCovers(test::anySetup(rng), GetParam(), false, tally, rng); });
    print(GetParam(), tally);
}

TEST_P(Coverage, IsSeldomRefusedInOrdinarySetups)
{
    Tally tally;
    forEachCase(test::kCases, [&](Rng& rng) { expectCovers(test::ordinarySetup(rng), GetParam(), true, tally, rng); });
    print(GetParam(), tally);
    tally.refusals.erase(std::string(nameOf(FitFailure::NoPlaceOfLight))); // which no set-up can help
    EXPECT_EQ(tally.refused(), 0);                                         // the bar for warped fits is 2 %
}

INSTANTIATE_TEST_SUITE_P(Techniques, Coverage, testing::ValuesIn(kTechniques), test::testName);
INSTANTIATE_TEST_SUITE_P(Planes, Coverage, testing::ValuesIn(test::kPlaneTechniques), test::testName);
INSTANTIATE_TEST_SUITE_P(Scene, Coverage, testing::ValuesIn(test::kSceneTechniques), test::testName);

} // namespace
} // namespace lixel
