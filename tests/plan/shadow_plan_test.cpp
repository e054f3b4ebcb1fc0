// SPDX-License-Identifier: MIT
#include "lixel/plan/shadow_plan.h"

#include "plan/ordinary_setups.h"
#include "plan/receivers.h"

#include <gtest/gtest.h>

namespace lixel {
namespace {

using test::forEachCase;
using test::ordinarySetup;
using test::RandomSetup;
using test::Rng;

PlanInput inputOf(const RandomSetup& setup, const char* technique)
{
    return {setup.view,
            {&setup.light, 1},
            setup.boxesWorld,
            setup.originWorld,
            std::get<MapTechnique>(*parseTechnique(technique)),
            {640, 480}};
}

TEST(Given, AMatrixIsTakenAsItIs)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const RandomSetup setup = ordinarySetup(rng);
        const FramePlan own = planShadows(inputOf(setup, "focused"));
        if (own.lights[0].refused) return;
        const std::vector<GivenLight> given{
            {"", {{own.lights[0].regions[0].lightClipFromLocal * translation(-setup.originWorld), std::nullopt, {}}}}};
        PlanInput input = inputOf(setup, "matrix(any.json)");
        input.given = given;
        const FramePlan plan = planShadows(input);
        ASSERT_EQ(plan.lights[0].regions.size(), 1u);
        const PlannedRegion &a = own.lights[0].regions[0], &b = plan.lights[0].regions[0];
        EXPECT_EQ(a.rectangle, b.rectangle);
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j)
                EXPECT_NEAR(a.lightClipFromLocal.m[i][j], b.lightClipFromLocal.m[i][j],
                            1e-12 * (1 + length(setup.originWorld)) * length(xyz(a.lightClipFromLocal.row(i))) + 1e-15);
    });
}

TEST(Given, ALightThatTheFileDoesNotNameIsRefused)
{
    Rng rng(1);
    const RandomSetup setup = ordinarySetup(rng);
    EXPECT_EQ(planShadows(inputOf(setup, "matrix(any.json)")).lights[0].refused, FitFailure::NotGiven);
    const std::vector<GivenLight> given{{"another", {{Mat4d{}, std::nullopt, {}}}}};
    PlanInput input = inputOf(setup, "plan(any.json)");
    input.given = given;
    EXPECT_EQ(planShadows(input).lights[0].refused, FitFailure::NotGiven);
}

TEST(Budget, SizesGivenForRegionsAreTheirsWhereThereAreAsMany)
{
    forEachCase(test::kCases, [](Rng& rng) {
        RandomSetup setup = ordinarySetup(rng);
        setup.light.kind = LightKind::Directional;
        PlanInput input = inputOf(setup, "pssm(3)");
        const std::vector<LixelSize> sizes{{300, 200}, {100, 150}, {64, 64}};
        input.lixelsOfRegions = sizes;
        const FramePlan plan = planShadows(input);
        for (std::size_t i = 0; plan.lights[0].regions.size() == 3 && i < 3; ++i) {
            EXPECT_EQ(plan.lights[0].regions[i].rectangle.width(), sizes[i].width);
            EXPECT_EQ(plan.lights[0].regions[i].rectangle.height(), sizes[i].height);
        }
        const std::size_t regions = plan.lights[0].regions.size();
        input.lixelsOfRegions = {sizes.data(), 1};
        if (regions > 1) {
            EXPECT_EQ(planShadows(input).lixelsOf(0), std::int64_t(input.lixels.width) * input.lixels.height);
        }
        input.lixelsOfRegions = {};
        input.lixels = {1, 1};
        if (regions > 1) {
            EXPECT_EQ(planShadows(input).lights[0].refused, FitFailure::TooFewLixels);
        }
    });
}

ViewSamples oneSample(const RandomSetup& setup, Vec3d pointLocal)
{
    ViewSamples samples;
    samples.width = setup.view.width;
    samples.height = setup.view.height;
    samples.originWorld = setup.originWorld;
    const Vec3d n = towardsLight(setup.light, setup.originWorld, pointLocal);
    samples.pixel.push_back({});
    samples.positionLocal.push_back({float(pointLocal.x), float(pointLocal.y), float(pointLocal.z)});
    samples.normal.push_back({float(n.x), float(n.y), float(n.z)});
    samples.triangle.push_back(kNoTriangle);
    return samples;
}

TEST(Else, HasAMapOnlyWhereAReceiverNeedsIt)
{
    forEachCase(test::kCases, [](Rng& rng) {
        RandomSetup setup = ordinarySetup(rng);
        setup.light.kind = LightKind::Directional;
        const Vec3d eye = setup.view.anchorWorld - setup.originWorld;
        const ViewSamples samples = oneSample(setup, eye + Vec3d{1, -1, 1});
        PlanInput input = inputOf(setup, "desired-view+else(focused)");
        input.seen = &samples;
        input.seenIsAll = true;
        EXPECT_EQ(planShadows(input).lights[0].regions.size(), 1u); // its own sample is inside
        input.seenIsAll = false;
        const FramePlan both = planShadows(input);
        const bool isFocusedRefused = planShadows(inputOf(setup, "focused")).lights[0].refused.has_value();
        EXPECT_EQ(both.lights[0].regions.size(), isFocusedRefused ? 1u : 2u);
    });
}

TEST(Else, ServesWhatLiesBeyondTheFarSideOfAMapMadeForOthers)
{
    // A table on a floor under a lamp right above: the samples given are the table's alone.
    RandomSetup setup;
    setup.boxesWorld = {{{-5, 0, -5}, {5, 0, 5}}, {{-1, 1, -1}, {1, 1, 1}}};
    setup.view = perspectiveView({0, 3, 6}, {0, 0, 0}, {0, 1, 0}, 1, 0.1, 100, 640, 480);
    setup.light.directionWorld = {0, -1, 0};
    ViewSamples samples = oneSample(setup, {-1, 1, -1});
    const ViewSamples other = oneSample(setup, {1, 1, 1});
    samples.pixel.push_back(other.pixel[0]);
    samples.positionLocal.push_back(other.positionLocal[0]);
    samples.normal.push_back(other.normal[0]);
    samples.triangle.push_back(other.triangle[0]);
    PlanInput input = inputOf(setup, "desired-view+else(focused)");
    input.seen = &samples;
    const FramePlan plan = planShadows(input);
    ASSERT_EQ(plan.lights[0].regions.size(), 2u);
    shared::LxReceiver receiver{};
    EXPECT_EQ(test::serving(plan, {0.5f, 1, 0.5f}, {0, 1, 0}, receiver), &plan.lights[0].regions[0]);
    EXPECT_EQ(test::serving(plan, {0.5f, 0, 0.5f}, {0, 1, 0}, receiver), &plan.lights[0].regions[1]);
}

TEST(Else, ThatIsRefusedForSomeOfItsCellsDoesNotHideTheRefusal)
{
    // A lamp amidst the nearest of four cascades: no one map holds what is around it, whichever fit is asked.
    RandomSetup setup;
    setup.boxesWorld = {{{-50, -1, -50}, {50, 0, 50}}, {{-50, 4, -50}, {50, 5, 50}}};
    setup.view = perspectiveView({0, 2, 0}, {1, 2, 0}, {0, 1, 0}, 1.5, 0.1, 100, 640, 480);
    setup.light.kind = LightKind::Point;
    setup.light.positionWorld = {8, 2, 0};
    const FramePlan plan = planShadows(inputOf(setup, "pssm(4)+else(pssm(4)+minimal-frustum)"));
    ASSERT_TRUE(plan.lights[0].refused);
    EXPECT_EQ(*plan.lights[0].refused, FitFailure::ExtentNotInHemisphere);
    EXPECT_TRUE(plan.lights[0].regions.empty());
}

TEST(Else, ServesLightsThatTheFitRefuses)
{
    forEachCase(test::kCases, [](Rng& rng) {
        RandomSetup setup = ordinarySetup(rng);
        setup.light.kind = LightKind::Point;
        setup.light.range = INFINITY;
        setup.light.positionWorld = setup.boxesWorld.back().centre();
        const FramePlan plain = planShadows(inputOf(setup, "focused"));
        const FramePlan helped = planShadows(inputOf(setup, "focused+else(cube)"));
        if (plain.lights[0].refused == FitFailure::ExtentNotInHemisphere) {
            EXPECT_FALSE(helped.lights[0].refused);
            EXPECT_GT(helped.lights[0].regions.size(), 1u);
        }
    });
}

TEST(SeveralLights, EachHasItsOwnLayerAndBudgetAndOneRefusalDoesNotTouchTheOthers)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const RandomSetup setup = ordinarySetup(rng);
        Light amidst = setup.light;
        amidst.kind = LightKind::Point;
        amidst.positionWorld = setup.boxesWorld.front().centre();
        const std::vector<Light> lights{setup.light, amidst, setup.light};
        PlanInput input = inputOf(setup, "focused");
        input.lights = lights;
        const FramePlan plan = planShadows(input), alone = planShadows(inputOf(setup, "focused"));
        int served = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_LE(plan.lixelsOf(i), 640 * 480);
            for (const PlannedRegion& region : plan.lights[i].regions) EXPECT_EQ(region.rectangle.layer, served);
            served += !plan.lights[i].refused;
        }
        EXPECT_EQ(plan.layers, served);
        if (!alone.lights[0].refused) {
            EXPECT_EQ(plan.lights[2].regions[0].lightClipFromLocal, alone.lights[0].regions[0].lightClipFromLocal);
        }
    });
}

} // namespace
} // namespace lixel
