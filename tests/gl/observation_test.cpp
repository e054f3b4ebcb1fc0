// SPDX-License-Identifier: MIT
#include "graphics.h"
#include "paced_loop.h"
#include "shadow_drawer.h"

#include "lixel/gl/executor.h"
#include "lixel/gl/passes/gather_pass.h"
#include "lixel/gl/passes/observation_readback.h"
#include "lixel/gl/passes/view_pass.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>

namespace lixel::test {
namespace {

class ObservationTest : public GlTest
{
};

void expectSame(const Observation& a, const Observation& b)
{
    EXPECT_EQ(a.samples.pixel, b.samples.pixel);
    EXPECT_EQ(a.samples.positionLocal, b.samples.positionLocal);
    EXPECT_EQ(a.samples.normal, b.samples.normal);
    EXPECT_EQ(a.samples.triangle, b.samples.triangle);
    EXPECT_EQ(a.samples.weight, b.samples.weight);
    EXPECT_EQ(a.samples.atDepthJump, b.samples.atDepthJump);
    EXPECT_EQ(a.lit, b.lit);
    EXPECT_EQ(a.atBoundary, b.atBoundary);
    EXPECT_EQ(a.samples.originWorld, b.samples.originWorld);
    EXPECT_EQ(a.samples.width, b.samples.width);
    EXPECT_EQ(a.view.clipFromAnchored, b.view.clipFromAnchored);
    EXPECT_EQ(a.view.anchorWorld, b.view.anchorWorld);
}

struct Observed
{
    SmallScene scene;
    CasterBuffers casters;
    CasterSource source;
    View view;
    std::vector<Light> lights;
    FramePlan plan;

    Observed(Rng& rng, int lightCount, int width, int height)
    {
        scene = anyObjectsOnAFloor(rng, 1);
        if (rng.chance(0.3)) scene.originWorld = 1e5 * rng.onSphere();
        view = anyViewOf(rng, scene.originWorld, 1, width, height);
        for (int i = 0; i < lightCount; ++i) lights.push_back(anyLightOn(rng, scene.originWorld, 1));
        plan = planFor(scene, view, lights, {48, 48});
        casters = scene.casters();
        casters.version = rng.bits() | 1;
        source = casters;
    }
    GlExecutor::Frame frame(ObservationGrid grid) const { return {casters, source, view, plan, lights, grid}; }
};

TEST_F(ObservationTest, TheDeviceObservesExactlyWhatItsSamplesAndTheirVisibilitySay)
{
    GlExecutor executor;
    std::size_t samples = 0, lit = 0, boundaries = 0, jumps = 0;
    forEachCase(40, [&](Rng& rng) {
        const Observed o(rng, rng.integer(0, 5), rng.integer(1, 250), rng.integer(1, 200));
        const ObservationGrid grid{rng.integer(1, 200), rng.integer(1, 200)};
        const Observation observed = executor.observe(o.frame(grid));
        const ViewSamples picture = executor.viewSamples(o.casters, o.view);
        const std::vector<Visibility> visibility = executor.run(o.plan, o.source, picture);
        expectSame(observed, observe(picture, o.view, o.lights, visibility, grid));
        EXPECT_EQ(observed.ageFrames, 0);
        samples += observed.samples.size();
        for (const std::uint32_t bits : observed.lit) lit += bits != 0;
        for (const std::uint32_t bits : observed.atBoundary) boundaries += bits != 0;
        for (const std::uint8_t isAtJump : observed.samples.atDepthJump) jumps += isAtJump;
    });
    std::printf("%zu samples, %zu lit, %zu at boundaries, %zu at depth jumps\n", samples, lit, boundaries, jumps);
    EXPECT_GT(lit, samples / 10);
    EXPECT_GT(boundaries, samples / 1000);
    EXPECT_GT(jumps, samples / 1000);
}

TEST_F(ObservationTest, ThirtyTwoLightsHaveABitEachAndFurtherOnesNone)
{
    GlExecutor executor;
    Rng rng(21);
    const Observed o(rng, 40, 120, 90);
    const Observation observed = executor.observe(o.frame({60, 45}));
    const ViewSamples picture = executor.viewSamples(o.casters, o.view);
    expectSame(observed, observe(picture, o.view, o.lights, executor.run(o.plan, o.source, picture), {60, 45}));
    std::uint32_t any = 0;
    for (const std::uint32_t bits : observed.lit) any |= bits;
    EXPECT_NE(any >> 31, 0u);
}

TEST_F(ObservationTest, WithoutLightsTheSamplesAloneAreObserved)
{
    GlExecutor executor;
    Rng rng(2);
    const Observed o(rng, 0, 300, 200);
    const Observation observed = executor.observe(o.casters, o.view);
    expectSame(observed, observe(executor.viewSamples(o.casters, o.view), o.view, {}, {}));
    EXPECT_TRUE(observed.lit.empty() && observed.atBoundary.empty());
    EXPECT_LE(observed.samples.size(), 180u * 180u);
    EXPECT_GT(observed.samples.size(), 1000u);
}

TEST_F(ObservationTest, ListsThatAreSplitGiveTheSameCells)
{
    Rng rng(6);
    const Observed o(rng, 3, 171, 99);
    gl::ViewTargets targets;
    targets.resize(device(), o.view.width, o.view.height);
    ShadowDrawer draw(device());
    draw.drawAtlas(o.plan, o.source);
    gl::ViewPass().run(draw.surfaces, o.view, targets);
    gl::GatherPass gather;
    gl::SamplePass pass(device());
    gl::ObservationReadback readback(0);
    const ObservationGrid grid{30, 20};
    const auto observed = [&] {
        gather.run(draw.surfaces, o.view, targets, draw.points);
        draw.lookupPass.run(o.plan, draw.tables, {draw.atlas, draw.prepared}, draw.points, draw.visibility);
        pass.run(draw.points, draw.visibility, o.lights, grid);
        readback.push(pass, {o.view, o.scene.originWorld, grid, true});
        Observation observation;
        EXPECT_TRUE(readback.take(observation));
        return observation;
    };
    const Observation whole = observed();
    const LowLimits low(device(), 32 * 1024);
    expectSame(observed(), whole);
    EXPECT_GT(draw.points.parts().size(), 10u);
}

TEST_F(ObservationTest, ALoopGivesTheObservationOfTheFrameBeforeTheLast)
{
    GlExecutor executor, still;
    Rng rng(5);
    Observed o(rng, 2, 90, 70);
    std::vector<Observation> wanted;
    Observation observed;
    for (int frame = 0; frame < 12; ++frame) {
        o.view = anyViewOf(rng, o.scene.originWorld, 1, frame < 6 ? 90 : 70, 70);
        o.plan = planFor(o.scene, o.view, o.lights, {48, 48});
        wanted.push_back(still.observe(o.frame({40, 30})));
        const bool isThere = executor.advance(o.frame({40, 30}), observed);
        ASSERT_EQ(isThere, frame >= GlExecutor::kObservationAge);
        if (!isThere) continue;
        EXPECT_EQ(observed.ageFrames, GlExecutor::kObservationAge);
        expectSame(observed, wanted[std::size_t(frame - GlExecutor::kObservationAge)]);
    }
    executor.restart();
    EXPECT_FALSE(executor.advance(o.frame({40, 30}), observed));
}

// A window's loop, whose context the executor shares. Delays come before a frame, on the device or on the host.
TEST_F(ObservationTest, SixHundredFramesOfAPacedLoopMeetNoFenceThatIsNotSignalled)
{
    Rng rng(9);
    const Observed o(rng, 1, 64, 48);
    const DeviceDelay delay;
    for (const auto& [name, deviceRounds, hostMs] :
         {std::tuple{"even", 0, 0}, std::tuple{"late device", 400, 0}, std::tuple{"late host", 0, 3}}) {
        GlExecutor executor(GlExecutor::Context::Current);
        Observation observed;
        std::uint64_t before = 0;
        runPaced(600, [&](int frame) {
            if (deviceRounds && frame % 5 == 0) delay.queue(deviceRounds);
            if (hostMs && frame % 5 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(hostMs));
            EXPECT_EQ(executor.advance(o.frame({32, 24}), observed), frame >= 2);
            if (frame == 3) before = gl::objectsMade();
        });
        EXPECT_EQ(executor.readbackWaits(), 0u) << name;
        EXPECT_EQ(gl::objectsMade(), before) << name;
    }
}

} // namespace
} // namespace lixel::test
