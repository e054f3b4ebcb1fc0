// SPDX-License-Identifier: MIT
#include "graphics.h"
#include "shadow_drawer.h"

#include "lixel/gl/device/objects.h"
#include "lixel/gl/frame_loop.h"

#include <algorithm>
#include <cmath>

namespace lixel::test {
namespace {

class FrameLoopTest : public GlTest
{
};

MapTechnique techniqueOf(const char* text) { return std::get<MapTechnique>(*parseTechnique(text)); }

// A camera that walks along an arc over objects on a floor, under two lights.
struct Walk
{
    SmallScene scene;
    Box boxWorld;
    CasterBuffers casters;
    CasterSource source;
    std::vector<Light> lights;
    View view;

    explicit Walk(Rng& rng)
    {
        scene = anyObjectsOnAFloor(rng, 1);
        boxWorld = scene.boxWorld();
        casters = scene.casters();
        casters.version = rng.bits() | 1;
        source = casters;
        while (lights.size() < 2) {
            lights.push_back(anyLightOn(rng, {}, 1));
            goTo(0);
            if (planFor(scene, view, {&lights.back(), 1}, {48, 48}).lights[0].refused) lights.pop_back();
        }
    }
    void goTo(int frame)
    {
        const double angle = 0.03 * frame;
        view = perspectiveView({2 * std::sin(angle), 0.8, 2 * std::cos(angle)}, {0, 0.1, 0}, {0, 1, 0}, 0.9, 0.01, 20,
                               90, 70);
    }
    FrameLoop::Subject subject() const { return {casters, source, {&boxWorld, 1}, view, lights}; }
};

// But for rounding: maps that are kept are fitted again to the samples of each frame.
bool isSamePlan(const FramePlan& a, const FramePlan& b)
{
    if (a.atlas != b.atlas || a.layers != b.layers || a.regionTable.size() != b.regionTable.size()) return false;
    for (std::size_t light = 0; light < a.lights.size(); ++light)
        for (std::size_t i = 0; i < a.lights[light].regions.size(); ++i) {
            const PlannedRegion &one = a.lights[light].regions[i], &other = b.lights[light].regions[i];
            if (one.rectangle != other.rectangle) return false;
            for (int row = 0; row < 4; ++row)
                for (int column = 0; column < 4; ++column) {
                    const double x = one.lightClipFromLocal.m[row][column], y = other.lightClipFromLocal.m[row][column];
                    if (!(std::abs(x - y) <= 1e-9 * (1 + std::abs(x)))) return false;
                }
        }
    return true;
}

constexpr ObservationGrid kGrid{40, 30};
constexpr int kArrival = GlExecutor::kObservationAge + 1; // frames from the one observed to the first planned from it

TEST_F(FrameLoopTest, ObservationsReachPlansAFixedNumberOfFramesLater)
{
    GlExecutor executor, still;
    Rng rng(3);
    Walk walk(rng);
    for (const int every : {1, 2, 3, 5}) {
        FrameLoop loop(executor, {techniqueOf("desired-view(rotated)+else(focused)"), {48, 48}, every, kGrid});
        std::vector<Observation> wanted;
        for (int frame = 0; frame < 14; ++frame) {
            walk.goTo(frame);
            loop.draw(walk.subject());
            wanted.push_back(
                still.observe({walk.casters, walk.source, walk.view, loop.plan(), walk.lights, kGrid, {}}));
            const Observation* const observed = loop.observed();
            ASSERT_EQ(observed != nullptr, frame >= kArrival);
            if (!observed) continue;
            const int from = (frame - kArrival) / every * every;
            EXPECT_EQ(observed->ageFrames, frame - from);
            const Observation& then = wanted[std::size_t(from)];
            EXPECT_EQ(observed->view.clipFromAnchored, then.view.clipFromAnchored);
            EXPECT_EQ(observed->samples.positionLocal, then.samples.positionLocal);
            EXPECT_EQ(observed->lit, then.lit);
            EXPECT_EQ(observed->atBoundary, then.atBoundary);
        }
    }
}

// First it is planned from what the maps of the start show, then from what its own do; then it rests.
TEST_F(FrameLoopTest, WhatAMapLeavesLitIsLookedForWithStandardMapsNowAndThen)
{
    GlExecutor executor;
    Rng rng(8);
    const Walk walk(rng);
    constexpr int kEvery = 3, kStandardEvery = 2;
    FrameLoop standard(executor, {techniqueOf("focused"), {48, 48}});
    standard.draw(walk.subject());
    const FramePlan focused = standard.plan();
    FrameLoop loop(executor, {techniqueOf("scene-optimal(uncovered=lit)"), {48, 48}, kEvery, kGrid, kStandardEvery});
    for (int frame = 0; frame < 25; ++frame) {
        loop.draw(walk.subject());
        const bool isStandard = frame < kArrival || frame % (kEvery * kStandardEvery) == 0;
        EXPECT_EQ(isSamePlan(loop.plan(), focused), isStandard) << "frame " << frame;
    }
}

TEST_F(FrameLoopTest, UnderAStillCameraPlansComeToRest)
{
    GlExecutor executor;
    Rng rng(8);
    const Walk walk(rng);
    constexpr int kEvery = 3, kSettled = kArrival + 6 * kEvery; // maps are made from what they let be seen
    for (const char* text : {"focused", "desired-view(rotated)", "sdsm(4)", "sdsm(2)+lispsm", "planes(auto)",
                             "scene-optimal", "scene-optimal(metric=l2,search=paper,uncovered=lit)"}) {
        FrameLoop loop(executor, {techniqueOf(text), {48, 48}, kEvery, kGrid, 0}); // no standard maps
        FramePlan settled;
        for (int frame = 0; frame < 45; ++frame) {
            loop.draw(walk.subject());
            if (frame == kSettled) settled = loop.plan();
            EXPECT_TRUE(frame <= kSettled || isSamePlan(loop.plan(), settled)) << text << ", frame " << frame;
        }
    }
}

TEST_F(FrameLoopTest, WhatNeedsNoObservationIsPlannedFromTheViewAlone)
{
    GlExecutor executor;
    Rng rng(4);
    Walk walk(rng);
    for (const char* text : {"focused", "lispsm", "pssm(3)"}) {
        FrameLoop loop(executor, {techniqueOf(text), {48, 48}, 1, kGrid});
        EXPECT_FALSE(loop.observes());
        for (int frame = 0; frame < 6; ++frame) {
            walk.goTo(frame);
            std::vector<FrameTimes::Pass> passes;
            loop.draw(walk.subject(), &passes);
            EXPECT_EQ(loop.observed(), nullptr);
            EXPECT_TRUE(std::ranges::none_of(passes, [](const auto& pass) { return pass.name == "sample"; }));
            EXPECT_TRUE(
                isSamePlan(loop.plan(), planFor(walk.scene, walk.view, walk.lights, {48, 48}, techniqueOf(text))));
        }
    }
}

TEST_F(FrameLoopTest, OnlyFramesThatAreObservedAreSampled)
{
    GlExecutor executor;
    Rng rng(5);
    Walk walk(rng);
    FrameLoop loop(executor, {techniqueOf("sdsm(2)"), {48, 48}, 3, kGrid});
    for (int frame = 0; frame < 10; ++frame) {
        walk.goTo(frame);
        executor.forgetMaps();
        std::vector<FrameTimes::Pass> passes;
        loop.draw(walk.subject(), &passes);
        std::vector<std::string> names;
        for (const FrameTimes::Pass& pass : passes) names.push_back(pass.name);
        std::vector<std::string> wanted{"view", "gather", "light depth", "lookup", "shade", "readback"};
        if (frame % 3 == 0) wanted.insert(wanted.begin() + 4, "sample");
        EXPECT_EQ(names, wanted) << frame;
    }
}

TEST_F(FrameLoopTest, AMovingLoopMakesNoObjectsOnceItHasObserved)
{
    GlExecutor executor;
    Rng rng(6);
    Walk walk(rng);
    for (const char* text : {"focused", "desired-view(rotated)", "sdsm(4)", "planes(auto)", "scene-optimal"}) {
        FrameLoop loop(executor, {techniqueOf(text), {48, 48}, 3, kGrid});
        std::uint64_t before = 0;
        for (int frame = 0; frame < 40; ++frame) {
            walk.goTo(frame);
            loop.draw(walk.subject());
            if (frame == kArrival) before = gl::objectsMade();
        }
        EXPECT_EQ(gl::objectsMade(), before) << text;
    }
}

// Forgotten maps are drawn as if casters had moved.
TEST_F(FrameLoopTest, MapsOfAStillLoopAreDrawnAgainOnlyWhereForgotten)
{
    GlExecutor executor;
    Rng rng(7);
    const Walk walk(rng);
    FrameLoop loop(executor, {techniqueOf("focused"), {48, 48}});
    loop.draw(walk.subject());
    const std::uint64_t once = executor.mapsDrawn();
    loop.draw(walk.subject());
    EXPECT_EQ(executor.mapsDrawn(), once);
    executor.forgetMaps();
    loop.draw(walk.subject());
    EXPECT_EQ(executor.mapsDrawn(), 2 * once);
}

// What was observed counts from the old origin, and its bits are of the old lights.
TEST_F(FrameLoopTest, ANewOriginOrOtherLightsStartTheLoopAgain)
{
    GlExecutor executor;
    Rng rng(9);
    Walk walk(rng);
    FrameLoop loop(executor, {techniqueOf("desired-view(rotated)+else(focused)"), {48, 48}, 2, kGrid});
    const auto drawAndCountStarts = [&](int frames) {
        int starts = 0;
        for (int frame = 0; frame < frames; ++frame) {
            loop.draw(walk.subject());
            starts += loop.observed() == nullptr;
        }
        return starts;
    };
    EXPECT_EQ(drawAndCountStarts(8), kArrival);
    EXPECT_EQ(drawAndCountStarts(8), 0);
    walk.lights.pop_back();
    EXPECT_EQ(drawAndCountStarts(8), kArrival);
    walk.casters.originWorld = walk.scene.originWorld = {0.25, 0, 0};
    walk.casters.version += 2;
    walk.source = walk.casters;
    EXPECT_EQ(drawAndCountStarts(8), kArrival);
    loop.restart();
    EXPECT_EQ(drawAndCountStarts(8), kArrival);
}

} // namespace
} // namespace lixel::test
