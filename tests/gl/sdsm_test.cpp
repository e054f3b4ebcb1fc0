// SPDX-License-Identifier: MIT
#include "graphics.h"
#include "shadow_drawer.h"

#include "lixel/gl/device/objects.h"
#include "lixel/gl/executor.h"
#include "lixel/gl/passes/sdsm_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace lixel::test {
namespace {

class SdsmTest : public GlTest
{
};

struct Cascades
{
    SmallScene scene;
    View view;
    std::array<Light, 2> lights;
    Box boxWorld;
    MapTechnique technique{.partition = SdsmPartition{}, .fit = DesiredViewFit{}, .allocation = Allocation::Share};
    LixelSize lixels;

    explicit Cascades(Rng& rng)
    {
        scene = anyObjectsOnAFloor(rng, 1);
        if (rng.chance(0.3)) scene.originWorld = 1e5 * rng.onSphere();
        boxWorld = scene.boxWorld();
        view = anyViewOf(rng, scene.originWorld, 1, rng.integer(30, 150), rng.integer(30, 120));
        for (Light& light : lights) light.directionWorld = normalized(rng.onSphere() - Vec3d{0, 1.2, 0});
        technique.partition = SdsmPartition{rng.integer(1, 6)};
        lixels = {rng.integer(60, 200), rng.integer(60, 200)};
    }
    SdsmLayout layout() const
    {
        return layoutSdsm({view, lights, {&boxWorld, 1}, scene.originWorld, technique, lixels}).value();
    }
};

// Samples so near a split's overlap that pow() of driver and compiler may put them on either side.
bool isAnyBetween(const SdsmFill& fill, const FramePlan& plan, const ViewSamples& samples)
{
    const auto count = std::size_t(fill.setup.regions.y), first = std::size_t(fill.setup.regions.z);
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const double split = plan.halfSpaceTable[first + i].w + fill.setup.viewDepth.w;
        for (const Vec3f& p : samples.positionLocal) {
            const double depth = shared::lxSdsmAt(fill.setup.viewDepth, {p.x, p.y, p.z});
            if (std::abs(depth - split) < 1e-4 * (std::abs(split) + std::abs(fill.setup.viewDepth.w))) return true;
        }
    }
    return false;
}

void expectSameTables(const gl::PlanTables::Content& device, const FramePlan& twin, const ViewSamples& samples)
{
    ASSERT_EQ(device.regions.size(), twin.regionTable.size());
    ASSERT_EQ(device.halfSpaces.size(), twin.halfSpaceTable.size());
    for (std::size_t i = 0; i < device.halfSpaces.size(); ++i) {
        const shared::vec4 &a = device.halfSpaces[i], &b = twin.halfSpaceTable[i];
        EXPECT_TRUE(a.x == b.x && a.y == b.y && a.z == b.z);
        EXPECT_NEAR(a.w, b.w, 1e-5 * (1 + std::abs(b.w)));
    }
    for (std::size_t i = 0; i < device.regions.size(); ++i) {
        const shared::ShadowRegion &a = device.regions[i], &b = twin.regionTable[i];
        EXPECT_TRUE(a.rectangle.x == b.rectangle.x && a.rectangle.w == b.rectangle.w && a.place.y == b.place.y);
        for (const Vec3f& p : samples.positionLocal) {
            const shared::vec4 point(p.x, p.y, p.z, 1), inA = a.lightClipFromLocal * point,
                                                        inB = b.lightClipFromLocal * point;
            ASSERT_NEAR(inA.x, inB.x, 1e-5 * (1 + std::abs(inB.x)));
            ASSERT_NEAR(inA.y, inB.y, 1e-5 * (1 + std::abs(inB.y)));
            ASSERT_NEAR(inA.z, inB.z, 1e-5 * (1 + std::abs(inB.z)));
            ASSERT_EQ(inA.w, inB.w);
        }
    }
}

TEST_F(SdsmTest, TablesMadeOnTheDeviceAreThoseOfTheTwin)
{
    GlExecutor executor(GlExecutor::Context::Current); // the passes' own
    gl::SdsmPass pass;
    gl::PlanTables tables;
    gl::PointList points(device());
    int compared = 0;
    forEachCase(kCases, [&](Rng& rng) {
        const Cascades c(rng);
        const ViewSamples samples = executor.viewSamples(c.scene.casters(), c.view);
        SdsmLayout layout = c.layout();
        points.upload(samples);
        tables.upload(layout.plan);
        for (const SdsmFill& fill : layout.fills) pass.run(fill, points, tables);
        const gl::PlanTables::Content content = tables.download();
        for (const SdsmFill& fill : layout.fills) fillSdsm(fill, samples, layout.plan);
        if (std::ranges::any_of(layout.fills,
                                [&](const SdsmFill& fill) { return isAnyBetween(fill, layout.plan, samples); }))
            return;
        ++compared;
        expectSameTables(content, layout.plan, samples);
    });
    std::printf("%d compared\n", compared);
    EXPECT_GT(compared, 20);
}

TEST_F(SdsmTest, ListsThatAreSplitGiveTheSameTables)
{
    Rng rng(3);
    const Cascades c(rng);
    GlExecutor executor(GlExecutor::Context::Current); // the passes' own
    const ViewSamples samples = executor.viewSamples(c.scene.casters(), c.view);
    const SdsmLayout layout = c.layout();
    gl::SdsmPass pass;
    gl::PlanTables tables;
    gl::PointList points(device());
    const auto made = [&] {
        points.upload(samples);
        tables.upload(layout.plan);
        pass.run(layout.fills[0], points, tables);
        return tables.download();
    };
    FramePlan whole = layout.plan;
    whole.regionTable = made().regions;
    whole.halfSpaceTable = made().halfSpaces;
    const LowLimits low(device(), 16 * 1024);
    expectSameTables(made(), whole, samples);
    EXPECT_GT(points.parts().size(), 3u);
}

// A frame whose tables never leave the device against one whose plan is made from samples that were read back.
TEST_F(SdsmTest, AFrameWithTablesOfTheDeviceShowsTheShadowsOfTheTwinsPlan)
{
    GlExecutor executor;
    std::size_t all = 0, differing = 0;
    forEachCase(20, [&](Rng& rng) {
        const Cascades c(rng);
        CasterBuffers casters = c.scene.casters();
        casters.version = rng.bits() | 1;
        const CasterSource source = casters;
        SdsmLayout layout = c.layout();
        const Observation made =
            executor.observe({casters, source, c.view, layout.plan, c.lights, ObservationGrid{150, 120}, layout.fills});
        const ViewSamples samples = executor.viewSamples(casters, c.view);
        for (const SdsmFill& fill : layout.fills) fillSdsm(fill, samples, layout.plan);
        const Observation twin =
            executor.observe({casters, source, c.view, layout.plan, c.lights, ObservationGrid{150, 120}});
        ASSERT_EQ(made.lit.size(), twin.lit.size());
        all += made.lit.size();
        for (std::size_t i = 0; i < made.lit.size(); ++i) differing += made.lit[i] != twin.lit[i];

        const std::vector<Visibility> visibility = executor.run(layout.plan, source, samples);
        for (std::size_t light = 0; light < c.lights.size(); ++light)
            for (std::size_t i = 0; i < samples.size(); ++i) {
                const bool isFacing = isLightFacing(c.lights[light], samples.originWorld,
                                                    toDouble(samples.positionLocal[i]), toDouble(samples.normal[i]));
                ASSERT_FALSE(isFacing && visibility[light].unserved[i]);
            }
    });
    std::printf("%zu of %zu differ\n", differing, all);
    EXPECT_LT(double(differing), 1e-3 * double(all));
}

TEST_F(SdsmTest, FramesAfterTheFirstMakeNoObjectsAndNameThePass)
{
    GlExecutor executor;
    Rng rng(8);
    const Cascades c(rng);
    CasterBuffers casters = c.scene.casters();
    casters.version = 1;
    const CasterSource source = casters;
    const SdsmLayout layout = c.layout();
    const GlExecutor::Frame frame{casters, source, c.view, layout.plan, c.lights, std::nullopt, layout.fills};
    executor.render(frame);
    const std::uint64_t before = gl::objectsMade();
    for (int i = 0; i < 3; ++i) executor.render(frame);
    EXPECT_EQ(gl::objectsMade(), before);
    EXPECT_EQ(executor.mapsDrawn(), 4 * layout.plan.regionTable.size());
    EXPECT_EQ(executor.measure(frame, 1).passes[2].name, "sdsm");
}

} // namespace
} // namespace lixel::test
