// SPDX-License-Identifier: MIT
#include "graphics.h"
#include "shadow_drawer.h"

#include "lixel/gl/device/objects.h"
#include "lixel/gl/executor.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <utility>

namespace lixel::test {
namespace {

class ExecutorTest : public GlTest
{
};

struct Setting
{
    SmallScene scene;
    View view;
    std::vector<Light> lights;
    FramePlan plan;
    CasterBuffers casters;
};

Setting anySetting(Rng& rng, int lights, LixelSize lixels, int width, int height)
{
    Setting s;
    s.scene = anyObjectsOnAFloor(rng, 1);
    s.view = anyViewOf(rng, {}, 1, width, height);
    while (int(s.lights.size()) < lights) {
        s.lights.push_back(anyLightOn(rng, {}, 1));
        if (planFor(s.scene, s.view, {&s.lights.back(), 1}, lixels).lights[0].refused) s.lights.pop_back();
    }
    s.plan = planFor(s.scene, s.view, s.lights, lixels);
    s.casters = s.scene.casters();
    s.casters.version = rng.bits() | 1;
    return s;
}

MapTechnique lookupOf(const char* text) { return std::get<MapTechnique>(*parseTechnique(text)); }

bool isSamePicture(const Image<Rgba8>& a, const Image<Rgba8>& b)
{
    return a.width() == b.width() && a.height() == b.height() &&
           std::memcmp(a.data().data(), b.data().data(), a.data().size() * sizeof(Rgba8)) == 0;
}

TEST_F(ExecutorTest, BothExecutorsAgreeOnTheSameSamples)
{
    GlExecutor executor;
    std::size_t all = 0, differing = 0;
    forEachCase(kCases / 10, [&](Rng& rng) {
        const Setting s = anySetting(rng, 2, {128, 128}, 160, 120);
        const ViewSamples samples = executor.viewSamples(s.casters, s.view);
        const std::vector<Visibility> drawn = executor.run(s.plan, s.casters, samples);
        const std::vector<Visibility> traced = runTraced(TraceScene(s.casters), s.plan, samples);
        for (std::size_t light = 0; light < s.lights.size(); ++light)
            for (std::size_t i = 0; i < samples.size(); ++i) {
                if (!isLightFacing(s.lights[light], {}, toDouble(samples.positionLocal[i]),
                                   toDouble(samples.normal[i])))
                    continue;
                ++all;
                differing += drawn[light].value[i] != traced[light].value[i];
            }
    });
    std::printf("%zu of %zu differ\n", differing, all);
    EXPECT_LT(double(differing), 1e-3 * double(all));
}

template <std::size_t n>
std::string anyOf(const std::array<const char*, n>& all, Rng& rng)
{
    return all[std::size_t(rng.integer(0, int(n) - 1))];
}

// The lookup knows nothing of how its maps came to be: several depths in maps of every partition, fit and warp.
TEST_F(ExecutorTest, BothExecutorsAgreeOnSeveralDepthsInMapsOfAnyKind)
{
    constexpr std::array kPartitions{"", "pssm(3)+", "sdsm(2)+", "cube+"};
    constexpr std::array kFits{"focused", "desired-view(rotated)", "minimal-frustum", "psm", "tsm", "lispsm",
                               "uniform"};
    constexpr std::array kWarps{"", "+rtw(grid=16)", "+now(grid=16)"};
    constexpr std::array kDepths{"+depths(2,max)", "+depths(2,min)", "+depths(3)",
                                 "+depths(4)",     "+depths(5)",     "+depths(8)"};
    constexpr std::array kKernels{"", "+pcf(4)", "+pcf(9,rotated)", "+bilinear", "+dual-plane"};
    GlExecutor executor;
    std::size_t all = 0, differing = 0;
    int refused = 0;
    forEachCase(16, [&](Rng& rng) {
        Setting s = anySetting(rng, 2, {96, 96}, 96, 72);
        const ViewSamples samples = executor.viewSamples(s.casters, s.view);
        const Box box = s.scene.boxWorld();
        const std::string words = anyOf(kPartitions, rng) + anyOf(kFits, rng) + anyOf(kWarps, rng) +
                                  anyOf(kDepths, rng) + anyOf(kKernels, rng);
        SCOPED_TRACE(words);
        PlanInput input{s.view, s.lights, {&box, 1}, s.scene.originWorld, lookupOf(words.c_str()), {96, 96}};
        input.seen = &samples;
        s.plan = planShadows(input);
        const std::vector<Visibility> drawn = executor.run(s.plan, s.casters, samples);
        const std::vector<Visibility> traced = runTraced(TraceScene(s.casters), s.plan, samples);
        for (std::size_t light = 0; light < s.lights.size(); ++light) {
            refused += s.plan.lights[light].refused.has_value();
            if (s.plan.lights[light].refused) continue;
            for (std::size_t i = 0; i < samples.size(); ++i) {
                if (!isLightFacing(s.lights[light], {}, toDouble(samples.positionLocal[i]),
                                   toDouble(samples.normal[i])))
                    continue;
                ++all;
                differing += drawn[light].value[i] != traced[light].value[i];
            }
        }
    });
    std::printf("%zu of %zu differ, %d maps refused\n", differing, all, refused);
    EXPECT_LT(double(differing), 1e-3 * double(all));
    EXPECT_LT(refused, scaled(16) / 2);
}

// A plan without a region has nothing to draw, to prepare or to look up: all is lit, with a plan before it or without.
TEST_F(ExecutorTest, WhereEveryLightIsRefusedAllIsLitWithAnyLookup)
{
    Rng rng(5);
    Setting s = anySetting(rng, 1, {64, 64}, 64, 48);
    s.lights = {Light{}};
    const Box box = s.scene.boxWorld();
    for (const bool isFirst : {true, false})
        for (const char* lookup :
             {"", "+pcf(9)", "+bilinear", "+dual-plane", "+hardware-pcf", "+depths(2,max)", "+depths(4)",
              "+depths(8)+pcf(9)", "+fast-pcf", "+vsm", "+evsm2", "+evsm4", "+msm"}) {
            SCOPED_TRACE(lookup);
            GlExecutor executor;
            const ViewSamples samples = executor.viewSamples(s.casters, s.view);
            const auto planOf = [&](const char* maps) {
                const std::string words = std::string(maps) + lookup;
                return planShadows(
                    {s.view, s.lights, {&box, 1}, s.scene.originWorld, lookupOf(words.c_str()), {64, 64}});
            };
            if (!isFirst) executor.run(planOf("focused"), s.casters, samples);
            const FramePlan refused = planOf("dual-paraboloid");
            ASSERT_TRUE(refused.lights[0].refused);
            const std::vector<Visibility> drawn = executor.run(refused, s.casters, samples);
            EXPECT_TRUE(std::ranges::all_of(drawn[0].value, [](float value) { return value == 1; }));
        }
}

TEST_F(ExecutorTest, AFrameOnTheDeviceIsThePictureOfItsSamplesAndTheirVisibility)
{
    GlExecutor executor;
    forEachCase(6, [&](Rng& rng) {
        const Setting s = anySetting(rng, 3, {64, 64}, rng.integer(1, 90), rng.integer(1, 70));
        const CasterSource source = s.casters;
        const Image<Rgba8> whole = executor.render({s.casters, source, s.view, s.plan, s.lights});
        const ViewSamples samples = executor.viewSamples(s.casters, s.view);
        const std::vector<Visibility> visibility = executor.run(s.plan, source, samples);
        const Image<Rgba8> inSteps = executor.shade(s.casters, s.view, s.lights, samples, visibility);
        ASSERT_EQ(whole.width(), s.view.width);
        ASSERT_EQ(whole.height(), s.view.height);
        EXPECT_TRUE(isSamePicture(whole, inSteps));
    });
}

TEST_F(ExecutorTest, NothingIsMadeAfterTheFirstFrameAndTheSameFrameIsTheSamePicture)
{
    GlExecutor executor;
    Rng rng(11);
    const Setting s = anySetting(rng, 4, {64, 64}, 101, 57);
    const CasterSource source = s.casters;
    const GlExecutor::Frame frame{s.casters, source, s.view, s.plan, s.lights};
    const Image<Rgba8> first = executor.render(frame);
    const std::uint64_t before = gl::objectsMade();
    for (int i = 0; i < 4; ++i) EXPECT_TRUE(isSamePicture(executor.render(frame), first));
    EXPECT_EQ(gl::objectsMade(), before);
}

TEST_F(ExecutorTest, MapsAreDrawnAgainOnlyWhenTheyOrTheirCastersDiffer)
{
    GlExecutor executor;
    Rng rng(13);
    Setting s = anySetting(rng, 3, {40, 30}, 50, 40);
    const ViewSamples samples = executor.viewSamples(s.casters, s.view);
    std::uint64_t before = 0;
    const auto drawn = [&](const CasterSource& source) { // and the maps are right, whether they were drawn or not
        GlExecutor fresh;
        const std::vector<Visibility> got = executor.run(s.plan, source, samples),
                                      wanted = fresh.run(s.plan, source, samples);
        for (std::size_t i = 0; i < got.size(); ++i) EXPECT_EQ(got[i].value, wanted[i].value);
        return executor.mapsDrawn() - std::exchange(before, executor.mapsDrawn());
    };
    EXPECT_EQ(drawn(s.casters), 3u);
    EXPECT_EQ(drawn(s.casters), 0u);
    std::swap(s.plan.lightTable[0], s.plan.lightTable[1]); // the same maps, read by other lights
    EXPECT_EQ(drawn(s.casters), 0u);
    std::swap(s.plan.lightTable[0], s.plan.lightTable[1]);
    s.lights[1].directionWorld = normalized(s.lights[1].directionWorld + Vec3d{0.01, 0, 0.02});
    s.lights[1].positionWorld = s.lights[1].positionWorld + Vec3d{0.1, 0.2, 0};
    s.plan = planFor(s.scene, s.view, s.lights, {40, 30}); // those of lights that stand still stay
    EXPECT_EQ(drawn(s.casters), 1u);
    s.plan = planFor(s.scene, s.view, s.lights, {30, 40});
    EXPECT_EQ(drawn(s.casters), 3u);
    s.casters.version += 2;
    EXPECT_EQ(drawn(s.casters), 3u);
    s.casters.version = 0;
    EXPECT_EQ(drawn(s.casters), 3u);
    EXPECT_EQ(drawn(s.casters), 3u);

    s.casters.version = 5;
    EXPECT_EQ(drawn(s.casters), 3u);
    CasterCallback nothing; // a host's casters have versions of their own
    nothing.draw = [](std::span<const CasterView>) {};
    nothing.version = 5;
    EXPECT_EQ(drawn(nothing), 3u);
    EXPECT_EQ(drawn(nothing), 0u);
}

TEST_F(ExecutorTest, WhatLookupsPrepareStaysWithItsMapsAndNothingIsMadeForItTwice)
{
    GlExecutor executor;
    Rng rng(21);
    const Setting s = anySetting(rng, 2, {60, 50}, 60, 40);
    const CasterSource source = s.casters;
    for (const char* lookup : {"depths(4)+pcf(4)", "depths(8)", "dual-plane+bilinear", "msm", "fast-pcf"}) {
        const FramePlan plan = planFor(s.scene, s.view, s.lights, {60, 50}, lookupOf(lookup));
        const GlExecutor::Frame frame{s.casters, source, s.view, plan, s.lights};
        const std::uint64_t before = executor.plansPrepared();
        const Image<Rgba8> first = executor.render(frame);
        EXPECT_EQ(executor.plansPrepared(), before + 1) << lookup;
        const std::uint64_t made = gl::objectsMade();
        EXPECT_TRUE(isSamePicture(executor.render(frame), first));
        EXPECT_EQ(executor.plansPrepared(), before + 1) << lookup;
        executor.forgetMaps();
        EXPECT_TRUE(isSamePicture(executor.render(frame), first));
        EXPECT_EQ(executor.plansPrepared(), before + 2) << lookup;
        EXPECT_EQ(gl::objectsMade(), made) << lookup;
        EXPECT_EQ(executor.measure(frame, 1).passes[3].name, "prepare");
    }
}

// Any of several lights move, come or go, from frame to frame: what is drawn and prepared for those alone gives the maps that a
// fresh executor draws.
TEST_F(ExecutorTest, MapsOfLightsThatStandStillStayWithWhatIsPreparedFromThem)
{
    GlExecutor executor;
    forEachCase(6, [&](Rng& rng) {
        Setting s = anySetting(rng, 5, {64, 64}, 40, 30);
        const std::vector<Light> all = s.lights;
        constexpr std::array kLookups{"pcf(1)", "depths(4)+pcf(4)", "dual-plane+bilinear", "msm", "evsm2"};
        const MapTechnique lookup = lookupOf(kLookups[std::size_t(rng.integer(0, int(kLookups.size()) - 1))]);
        const ViewSamples samples = executor.viewSamples(s.casters, s.view);
        std::uint64_t drawn = 0, regions = 0;
        for (int frame = 0; frame < 5; ++frame) {
            const int moved = rng.integer(0, int(s.lights.size()) - 1);
            Light& light = s.lights[std::size_t(moved)];
            light.directionWorld = normalized(light.directionWorld + Vec3d{0.01, 0, 0.02});
            light.positionWorld = light.positionWorld + Vec3d{0.1, 0.2, 0};
            s.plan = planFor(s.scene, s.view, s.lights, {64, 64}, lookup);
            GlExecutor fresh;
            const std::uint64_t before = executor.mapsDrawn();
            const auto got = executor.run(s.plan, s.casters, samples), wanted = fresh.run(s.plan, s.casters, samples);
            for (std::size_t i = 0; i < got.size(); ++i) EXPECT_EQ(got[i].value, wanted[i].value);
            drawn += executor.mapsDrawn() - before;
            regions += fresh.mapsDrawn();
            if (frame == 2) s.lights.pop_back();
            if (frame == 3) s.lights = all;
        }
        EXPECT_LT(drawn, regions);
    });
}

TEST_F(ExecutorTest, MeasuringDrawsTheMapsOfEveryFrame)
{
    GlExecutor executor;
    Rng rng(3);
    const Setting s = anySetting(rng, 2, {32, 32}, 24, 24);
    const CasterSource source = s.casters;
    const GlExecutor::Frame frame{s.casters, source, s.view, s.plan, s.lights};
    executor.render(frame);
    executor.render(frame);
    EXPECT_EQ(executor.mapsDrawn(), 2u);
    executor.measure(frame, 4);
    EXPECT_EQ(executor.mapsDrawn(), 2u + 2u * (2 + 2 * 4));
}

TEST_F(ExecutorTest, ThirtyTwoLightsEachDarkenOnlyTheirOwn)
{
    GlExecutor executor;
    Rng rng(5);
    const Setting s = anySetting(rng, 32, {48, 48}, 77, 33);
    const ViewSamples samples = executor.viewSamples(s.casters, s.view);
    const std::vector<Visibility> together = executor.run(s.plan, s.casters, samples);
    ASSERT_EQ(together.size(), 32u);
    for (std::size_t i = 0; i < s.lights.size(); ++i) {
        const FramePlan alone = planFor(s.scene, s.view, {&s.lights[i], 1}, {48, 48});
        EXPECT_EQ(executor.run(alone, s.casters, samples)[0].value, together[i].value) << "light " << i;
    }
}

TEST_F(ExecutorTest, PicturesAndMapsOfAnySizeWorkDownToOnePixelAndOneLixel)
{
    GlExecutor executor;
    Rng rng(2);
    for (const auto [width, height, lixels] : {std::array{1, 1, 1}, std::array{3, 1, 2}, std::array{1, 17, 5},
                                               std::array{255, 2, 33}, std::array{65, 63, 129}}) {
        Setting s = anySetting(rng, 1, {lixels, lixels + 3}, width, height);
        const ViewSamples samples = executor.viewSamples(s.casters, s.view);
        const Visibility visibility = executor.run(s.plan, s.casters, samples)[0];
        EXPECT_EQ(visibility.value.size(), samples.size());
        const Image<Rgba8> picture = executor.shade(s.casters, s.view, s.lights, samples, {&visibility, 1});
        EXPECT_EQ(picture.width(), width);
        EXPECT_EQ(picture.height(), height);
    }
}

TEST_F(ExecutorTest, WhatIsLargerThanTheDeviceIsRefusedByName)
{
    GlExecutor executor;
    Rng rng(2);
    Setting s = anySetting(rng, 1, {16, 16}, 8, 8);
    const ViewSamples samples = executor.viewSamples(s.casters, s.view);
    FramePlan large = s.plan;
    large.atlas.width = 1 << 20;
    EXPECT_THROW(executor.run(large, s.casters, samples), gl::GraphicsError);
    s.view.width = 1 << 20;
    EXPECT_THROW(executor.viewSamples(s.casters, s.view), gl::GraphicsError);
    s.view.width = 8;
    EXPECT_EQ(executor.viewSamples(s.casters, s.view).size(), samples.size());
}

TEST_F(ExecutorTest, TwoExecutorsTakeTurns)
{
    Rng rng(9);
    const Setting s = anySetting(rng, 1, {32, 32}, 40, 30);
    GlExecutor first, second;
    const ViewSamples a = first.viewSamples(s.casters, s.view), b = second.viewSamples(s.casters, s.view);
    EXPECT_EQ(a.positionLocal, b.positionLocal);
    EXPECT_EQ(first.run(s.plan, s.casters, a)[0].value, second.run(s.plan, s.casters, b)[0].value);
    second = GlExecutor();
    EXPECT_EQ(first.viewSamples(s.casters, s.view).triangle, second.viewSamples(s.casters, s.view).triangle);
}

TEST_F(ExecutorTest, AHostsContextGivesTheSamePictureWhateverStateItLeft)
{
    Rng rng(8);
    const Setting s = anySetting(rng, 2, {40, 30}, 50, 41);
    const CasterSource source = s.casters;
    const GlExecutor::Frame frame{s.casters, source, s.view, s.plan, s.lights};
    Image<Rgba8> own;
    {
        GlExecutor headless;
        own = headless.render(frame);
    }
    device().makeCurrent();
    GlExecutor hosted(GlExecutor::Context::Current);
    for (const GLenum capability : {GL_CULL_FACE, GL_SCISSOR_TEST, GL_BLEND, GL_STENCIL_TEST, GL_POLYGON_OFFSET_FILL})
        glEnable(capability);
    glDepthFunc(GL_LESS);
    glClipControl(GL_UPPER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
    glPixelStorei(GL_PACK_ROW_LENGTH, 7);
    EXPECT_TRUE(isSamePicture(hosted.render(frame), own));
}

TEST_F(ExecutorTest, AFrameHasATimeAndEachPassItsOwn)
{
    GlExecutor executor;
    Rng rng(4);
    const Setting s = anySetting(rng, 1, {64, 64}, 64, 48);
    const CasterSource source = s.casters;
    GlExecutor::Frame frame{s.casters, source, s.view, s.plan, s.lights};
    const FrameTimes times = executor.measure(frame, 3);
    EXPECT_GT(times.frameMs, 0);
    std::vector<std::string> names;
    for (const FrameTimes::Pass& pass : times.passes) names.push_back(pass.name);
    EXPECT_EQ(names, (std::vector<std::string>{"view", "gather", "light depth", "lookup", "shade"}));
    EXPECT_EQ(times.gpuMs.has_value(), !executor.isSoftware());
    EXPECT_EQ(times.trianglesDrawn + times.trianglesCulled, s.scene.indices.size() / 3);

    frame.observed = ObservationGrid{};
    EXPECT_EQ(executor.measure(frame, 1).passes[4].name, "sample");
}

} // namespace
} // namespace lixel::test
