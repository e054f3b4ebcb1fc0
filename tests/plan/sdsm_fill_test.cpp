// SPDX-License-Identifier: MIT
#include "lixel/plan/partition/sdsm_fill.h"
#include "support/random_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace lixel::test {
namespace {

struct Setting
{
    View view;
    std::array<Light, 1> lights;
    Box boxWorld{{-20, 0, -31}, {20, 3, 0}};
    ViewSamples samples;
    MapTechnique technique{.partition = SdsmPartition{}, .fit = DesiredViewFit{}, .allocation = Allocation::Share};
    LixelSize lixels;

    PlanInput input() const
    {
        PlanInput in{view, lights, {&boxWorld, 1}, samples.originWorld, technique, lixels};
        in.seen = &samples;
        return in;
    }
};

// Points on a floor that a view stands on, some of them turned away from the light.
Setting anySetting(Rng& rng)
{
    Setting s;
    s.technique.partition = SdsmPartition{rng.integer(1, 8)};
    s.technique.kernel = PcfKernel{rng.chance(0.5) ? 1 : 9};
    s.lixels = {rng.integer(40, 300), rng.integer(40, 300)};
    s.samples.originWorld = rng.chance(0.3) ? 1e4 * rng.onSphere() : Vec3d{};
    const Vec3d o = s.samples.originWorld;
    s.boxWorld = translated(s.boxWorld, o);
    s.view = perspectiveView(o + Vec3d{0, 1.6, 0}, o - Vec3d{0, 0, 15}, {0, 1, 0}, 1, 0.1, 1000, 64, 64);
    if (rng.chance(0.2))
        s.view = orthographicView(o + Vec3d{0, 9, 0}, o - Vec3d{0, 0, 15}, {0, 1, 0}, 20, 0, 60, 64, 64);
    s.lights[0].directionWorld = normalized(rng.onSphere() - Vec3d{0, 1.5, 0});
    s.samples.width = s.samples.height = 64;
    for (int i = 0; i < 3000; ++i) {
        s.samples.pixel.push_back({0.5f, 0.5f});
        s.samples.positionLocal.push_back(
            toFloat(Vec3d{rng.uniform(-8, 8), rng.chance(0.9) ? 0 : rng.uniform(0, 3), rng.uniform(-30, -1)}));
        s.samples.normal.push_back(toFloat(rng.chance(0.9) ? Vec3d{0, 1, 0} : rng.onSphere()));
        s.samples.triangle.push_back(kNoTriangle);
    }
    return s;
}

// Where both tables send a point: NDC and depth agree, as far as floats of its coordinates do. Maps hardly wider than those can
// tell points apart have a size that rounding makes, and agree as far as that is known.
void expectSameImage(const shared::mat4& a, const shared::mat4& b, Vec3f p, double farthestSample)
{
    const shared::vec4 point(p.x, p.y, p.z, 1), inA = a * point, inB = b * point;
    const auto tolerance = [&](double value, Vec3d row) {
        const bool isNarrow = 1 / length(row) < 1e-3 * farthestSample;
        return (isNarrow ? 3e-4 : 1e-5) * (1 + std::abs(value));
    };
    EXPECT_NEAR(inA.x, inB.x, tolerance(inB.x, {b[0].x, b[1].x, b[2].x}));
    EXPECT_NEAR(inA.y, inB.y, tolerance(inB.y, {b[0].y, b[1].y, b[2].y}));
    EXPECT_NEAR(inA.z, inB.z, 1e-5 * (1 + std::abs(inB.z)));
    EXPECT_EQ(inA.w, inB.w);
}

// Samples at the very end of what a cascade's map must hold, which rounding takes in or leaves out.
bool isAnyAtBorder(const SdsmFill& fill, const FramePlan& plan, const ViewSamples& samples)
{
    std::vector<double> depths, splits;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Vec3f p = samples.positionLocal[i], n = samples.normal[i];
        if (shared::lxFaces(fill.setup.light, {p.x, p.y, p.z}, {n.x, n.y, n.z}))
            depths.push_back(shared::lxSdsmAt(fill.setup.viewDepth, {p.x, p.y, p.z}));
    }
    const double offset = std::abs(double(fill.setup.viewDepth.w));
    for (const shared::vec4& halfSpace : plan.halfSpaceTable) splits.push_back(halfSpace.w + fill.setup.viewDepth.w);
    splits.push_back(*std::ranges::max_element(depths));
    const auto slack = [&](double end) { return std::max(1e-5 * std::abs(end), 4e-7 * offset); };
    for (std::size_t i = 0; i + 1 < splits.size(); ++i)
        for (const double border : {splits[i] + slack(splits[i]), splits[i] - slack(splits[i + 1])})
            for (const double depth : depths)
                if (std::abs(depth - border) < 1e-6 * (std::abs(border) + offset)) return true;
    return false;
}

TEST(SdsmFill, TablesMadeFromSamplesAreThoseOfThePlan)
{
    int compared = 0;
    forEachCase(kCases, [&](Rng& rng) {
        const Setting s = anySetting(rng);
        const FramePlan plan = planShadows(s.input());
        std::optional<SdsmLayout> layout = layoutSdsm(s.input());
        ASSERT_TRUE(layout && layout->fills.size() == 1);
        fillSdsm(layout->fills[0], s.samples, layout->plan);
        const FramePlan& filled = layout->plan;
        // The plan leaves cascades without samples out and gives their lixels to others.
        if (plan.regionTable.size() != filled.regionTable.size()) return;
        if (isAnyAtBorder(layout->fills[0], plan, s.samples)) return;
        ++compared;
        double farthest = 0;
        for (const Vec3f& p : s.samples.positionLocal) farthest = std::max(farthest, length(toDouble(p)));
        EXPECT_EQ(filled.atlas, plan.atlas);
        ASSERT_EQ(filled.halfSpaceTable.size(), plan.halfSpaceTable.size());
        for (std::size_t i = 0; i < plan.halfSpaceTable.size(); ++i) {
            EXPECT_NEAR(filled.halfSpaceTable[i].w, plan.halfSpaceTable[i].w,
                        1e-5 * (1 + std::abs(plan.halfSpaceTable[i].w)));
            EXPECT_EQ(filled.halfSpaceTable[i].x, plan.halfSpaceTable[i].x);
        }
        for (std::size_t i = 0; i < plan.regionTable.size(); ++i) {
            EXPECT_EQ(filled.regionTable[i].rectangle.z, plan.regionTable[i].rectangle.z);
            EXPECT_EQ(filled.regionTable[i].place.y, plan.regionTable[i].place.y);
            EXPECT_EQ(filled.regionTable[i].place.z, plan.regionTable[i].place.z);
            for (std::size_t k = 0; k < s.samples.size(); k += 100)
                expectSameImage(filled.regionTable[i].lightClipFromLocal, plan.regionTable[i].lightClipFromLocal,
                                s.samples.positionLocal[k], farthest);
        }
    });
    EXPECT_GT(compared, test::scaled(kCases) / 20);
}

TEST(SdsmFill, EverySampleThatFacesTheLightIsServed)
{
    forEachCase(kCases, [](Rng& rng) {
        const Setting s = anySetting(rng);
        SdsmLayout layout = layoutSdsm(s.input()).value();
        fillSdsm(layout.fills[0], s.samples, layout.plan);
        const std::vector<PlannedRegion>& regions = layout.plan.lights[0].regions;
        for (std::size_t k = 0; k < s.samples.size(); ++k) {
            const Vec3d p = toDouble(s.samples.positionLocal[k]);
            if (!isLightFacing(s.lights[0], s.samples.originWorld, p, toDouble(s.samples.normal[k]))) continue;
            const bool isServed = std::any_of(regions.begin(), regions.end(), [&](const PlannedRegion& region) {
                for (const Plane& plane : region.halfSpacesLocal)
                    if (plane.signedDistance(p) < 0) return false;
                return LightImage(region.lightClipFromLocal, region.rectangle).lixelAt(p).has_value();
            });
            EXPECT_TRUE(isServed);
        }
    });
}

TEST(SdsmFill, WithoutSamplesNothingIsServed)
{
    Rng rng(1);
    const Setting s = anySetting(rng);
    SdsmLayout layout = layoutSdsm(s.input()).value();
    fillSdsm(layout.fills[0], ViewSamples{}, layout.plan);
    for (const PlannedRegion& region : layout.plan.lights[0].regions)
        for (const Vec3f& p : s.samples.positionLocal)
            EXPECT_FALSE(LightImage(region.lightClipFromLocal, region.rectangle).lixelAt(toDouble(p)));
}

TEST(SdsmFill, OnlyUprightCascadesUnderParallelLightHaveALayout)
{
    Rng rng(2);
    Setting s = anySetting(rng);
    EXPECT_TRUE(layoutSdsm(s.input()));
    s.technique.isStable = true;
    EXPECT_FALSE(layoutSdsm(s.input()));
    s = anySetting(rng);
    s.technique.fit = FocusedFit{};
    EXPECT_FALSE(layoutSdsm(s.input()));
    s = anySetting(rng);
    s.lights[0].kind = LightKind::Point;
    EXPECT_FALSE(layoutSdsm(s.input()));
}

} // namespace
} // namespace lixel::test
