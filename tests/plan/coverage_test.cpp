// SPDX-License-Identifier: MIT
// Coverage: every receiver that faces the light lies, with the lookup's whole reach, inside the map of the region that serves it,
// and whatever may shadow it projects to the same place; or the plan refuses by name.
#include "lixel/plan/shadow_plan.h"
#include "lixel/shared/lookup.h"
#include "plan/ordinary_setups.h"
#include "plan/random_setups.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <map>

namespace lixel {
namespace {

using test::forEachCase;
using test::RandomSetup;
using test::Rng;

bool isInView(const RandomSetup& setup, Vec3d pointLocal)
{
    const Vec4d c = clipFromLocal(setup.view, setup.originWorld) * point(pointLocal);
    return c.w > 0 && std::abs(c.x) <= c.w && std::abs(c.y) <= c.w && std::abs(c.z) <= c.w;
}

// Points of the boxes that are in view, with normals towards the light.
ViewSamples anySamples(const RandomSetup& setup, Rng& rng)
{
    ViewSamples samples;
    samples.width = setup.view.width;
    samples.height = setup.view.height;
    samples.originWorld = setup.originWorld;
    for (int i = 0; i < 400 && samples.size() < 40; ++i) {
        const Box& box = setup.boxesWorld[std::size_t(rng.integer(0, int(setup.boxesWorld.size()) - 1))];
        const Vec3d exact = Vec3d{rng.uniform(box.min.x, box.max.x), rng.uniform(box.min.y, box.max.y),
                                  rng.uniform(box.min.z, box.max.z)} -
                            setup.originWorld;
        const Vec3f p{float(exact.x), float(exact.y), float(exact.z)};
        if (!isInView(setup, toDouble(p))) continue;
        const Vec3d n = towardsLight(setup.light, setup.originWorld, toDouble(p));
        if (!isLightFacing(setup.light, setup.originWorld, toDouble(p), n)) continue;
        const Vec3d pixel = pixelFromLocal(setup.view, setup.originWorld, toDouble(p));
        samples.pixel.push_back({float(pixel.x), float(pixel.y)});
        samples.positionLocal.push_back(p);
        samples.normal.push_back({float(n.x), float(n.y), float(n.z)});
        samples.triangle.push_back(kNoTriangle);
    }
    return samples;
}

shared::vec3 toShared(Vec3f a) { return {a.x, a.y, a.z}; }

// The region that serves a sample, by the very functions that executors use; nothing where none does.
const PlannedRegion* serving(const FramePlan& plan, Vec3f positionLocal, Vec3f normal, shared::LxReceiver& receiver)
{
    for (std::size_t r = 0; r < plan.regionTable.size(); ++r) {
        const shared::ShadowRegion& region = plan.regionTable[r];
        bool isHeld = true;
        for (int i = 0; i < int(region.place.z); ++i)
            isHeld = isHeld && shared::lxHolds(plan.halfSpaceTable[std::size_t(region.place.y) + std::size_t(i)],
                                               toShared(positionLocal));
        if (!isHeld) continue;
        receiver = shared::lxReceive(region, toShared(positionLocal), toShared(normal));
        if (receiver.isInside != 0) return &plan.lights[0].regions[r];
    }
    return nullptr;
}

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

void expectCovers(const RandomSetup& setup, const char* technique, Tally& tally, Rng& rng)
{
    const ViewSamples samples = anySamples(setup, rng);
    if (samples.size() == 0) return; // nothing is asked
    PlanInput input{setup.view,
                    {&setup.light, 1},
                    setup.boxesWorld,
                    setup.originWorld,
                    std::get<MapTechnique>(*parseTechnique(technique)),
                    {512, 384}};
    input.seen = &samples;
    const FramePlan plan = planShadows(input);
    ++tally.cases;
    if (plan.lights[0].refused) {
        ++tally.refusals[std::string(nameOf(*plan.lights[0].refused))];
        return;
    }
    EXPECT_LE(plan.lixelsOf(0), 512 * 384);
    const double reach = plan.lookup.reach - 0.1; // rounding of a map as narrow as fits make them (kLeastPerRounding)
    for (std::size_t i = 0; i < samples.size(); ++i) {
        shared::LxReceiver receiver;
        const PlannedRegion* region = serving(plan, samples.positionLocal[i], samples.normal[i], receiver);
        ASSERT_NE(region, nullptr) << technique << ": unserved";
        const LixelRectangle& r = region->rectangle;
        EXPECT_GE(receiver.lixel.x, r.x0 + reach);
        EXPECT_LE(receiver.lixel.x, r.x1 - reach);
        EXPECT_GE(receiver.lixel.y, r.y0 + reach);
        EXPECT_LE(receiver.lixel.y, r.y1 - reach);
        const Vec3d p = toDouble(samples.positionLocal[i]);
        const Vec4d c = region->lightClipFromLocal * point(p);
        EXPECT_GT(c.w, 0);
        EXPECT_LE(c.z / c.w, 1);
        // Anything between it and the light is drawn in the same place, no farther.
        const Vec3d caster = p + rng.uniform(0, 0.5) * setup.radius * towardsLight(setup.light, setup.originWorld, p);
        const Vec4d q = region->lightClipFromLocal * point(caster);
        if (q.w > 1e-6 * c.w) {
            EXPECT_NEAR(q.x / q.w, c.x / c.w, 1e-5 * c.w / q.w) << technique;
            EXPECT_NEAR(q.y / q.w, c.y / c.w, 1e-5 * c.w / q.w) << technique;
            EXPECT_LE(q.z / q.w, c.z / c.w + 1e-9) << technique;
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
                                       "psm+else(cube+desired-view)",
                                       "pssm(2)+tsm+else(focused)"};

class Coverage : public testing::TestWithParam<const char*>
{
};

TEST_P(Coverage, HoldsForEveryReceiverOfAnySetupOrIsRefusedByName)
{
    Tally tally;
    forEachCase(test::kCases, [&](Rng& rng) { expectCovers(test::anySetup(rng), GetParam(), tally, rng); });
    print(GetParam(), tally);
}

TEST_P(Coverage, IsSeldomRefusedInOrdinarySetups)
{
    Tally tally;
    forEachCase(test::kCases, [&](Rng& rng) { expectCovers(test::ordinarySetup(rng), GetParam(), tally, rng); });
    print(GetParam(), tally);
    EXPECT_EQ(tally.refused(), 0); // the bar for warped fits is 2 %
}

std::string testName(const testing::TestParamInfo<const char*>& technique)
{
    std::string name;
    for (const char c : std::string_view(technique.param))
        name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(Techniques, Coverage, testing::ValuesIn(kTechniques), testName);

} // namespace
} // namespace lixel
