// SPDX-License-Identifier: MIT
// Warps that the device makes against those of their twin.
#include "graphics.h"
#include "shadow_drawer.h"
#include "warped_plans.h"

#include "lixel/gl/executor.h"
#include "lixel/gl/passes/gather_pass.h"
#include "lixel/gl/passes/view_pass.h"
#include "lixel/gl/passes/warp_fill_pass.h"
#include "lixel/plan/technique.h"
#include "lixel/plan/warp/region_warps.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lixel::test {
namespace {

class WarpFillTest : public GlTest
{
};

// What the view sees, one entry a pixel, as a frame has it.
struct SeenPixels
{
    gl::Surfaces surfaces;
    gl::ViewTargets targets;
    gl::ViewPass viewPass;
    gl::GatherPass gatherPass;
    gl::PointList points;

    explicit SeenPixels(const gl::Device& device) : surfaces(device), points(device) {}
    ViewSamples look(const gl::Device& device, const CasterBuffers& casters, const View& view)
    {
        surfaces.update(casters);
        targets.resize(device, view.width, view.height);
        viewPass.run(surfaces, view, targets);
        gatherPass.run(surfaces, view, targets, points);
        return points.download();
    }
};

struct Warped
{
    SmallScene scene;
    Box boxWorld;
    View view;
    Light light;
    MapTechnique technique;
    LixelSize lixels;

    Warped(Rng& rng, const char* text, int width, int height)
        : scene(anyObjectsOnAFloor(rng, 1)),
          boxWorld(scene.boxWorld()),
          view(anyViewOf(rng, {}, 1, width, height)),
          light(anyLightOn(rng, {}, 1)),
          technique(std::get<MapTechnique>(parseTechnique(text).value())),
          lixels{rng.integer(20, 90), rng.integer(20, 90)}
    {
    }
    PlanInput input() const { return {view, {&light, 1}, {&boxWorld, 1}, scene.originWorld, technique, lixels}; }
};

// The layout with the warps that the plan makes of the samples.
FramePlan twinOf(const WarpLayout& layout, const Warped& w, const ViewSamples& samples)
{
    FramePlan twin = layout.plan;
    RegionWarpScratch scratch;
    warpRegions({w.view, w.light, twin.originWorld, &samples}, w.technique.warp, twin.lookup, scratch,
                twin.lights[0].regions);
    rebuildWarps(twin);
    return twin;
}

bool isNearBorder(double place, int cells, double reach)
{
    const double scaled = place * cells;
    return std::abs(scaled - std::round(scaled)) < reach;
}

// How far, in cells, floats may move a place: of what is order 1 before it is made lixels, a few roundings. A small part of a
// paraboloid has many lixels to that.
double roundingInCells(const FramePlan& plan, std::size_t region)
{
    constexpr double kRounding = 16 * 0x1p-24;
    const shared::vec4 lixelFromNdc = plan.regionTable[region].lixelFromNdc;
    return std::max(1e-4, kRounding * double(std::max(std::abs(lixelFromNdc.x), std::abs(lixelFromNdc.y))));
}

// Samples so near the border of a cell, of the map or of what rows made of it, that floats may put them on either side; or of the
// region.
bool isAnyAtBorder(const FramePlan& plan, const ViewSamples& samples)
{
    const std::vector<PlannedRegion>& regions = plan.lights[0].regions;
    for (std::size_t r = 0; r < regions.size(); ++r) {
        const PlannedRegion& region = regions[r];
        if (region.warp.isIdentity()) continue;
        const double reach = roundingInCells(plan, r);
        const LightImage image(region.projection(), region.rectangle);
        const LixelRectangle& square = region.warp.square;
        for (const Vec3f& position : samples.positionLocal) {
            for (const Plane& plane : region.halfSpacesLocal)
                if (std::abs(plane.signedDistance(toDouble(position))) < 1e-5) return true;
            const auto lixel = image.lixelAt(toDouble(position));
            if (!lixel) continue;
            const double x = (lixel->x - square.x0) / square.width(), y = (lixel->y - square.y0) / square.height();
            const shared::LxWarped w =
                shared::lxWarped(tableRow(region.warp), {float(x), float(y)}, knotsOf(region.warp));
            if (isNearBorder(x, region.warp.columns, reach) || isNearBorder(y, region.warp.rows, reach) ||
                isNearBorder(double(w.at.x), region.warp.columns, reach))
                return true;
        }
    }
    return false;
}

constexpr const char* kTechniques[] = {"now(importance=count)",
                                       "now(importance=count,power=1,smooth=0)",
                                       "now(importance=count*edges)",
                                       "now(importance=count*distance*normal,smooth=1)",
                                       "cube+now(importance=count)",
                                       "dual-paraboloid+now(importance=count)",
                                       "rtw(importance=count)",
                                       "rtw(importance=distance)",
                                       "rtw(importance=edges*normal,smooth=0)"};

TEST_F(WarpFillTest, WarpsMadeOnTheDeviceAreThoseOfTheTwin)
{
    SeenPixels seen(device());
    gl::WarpFillPass pass;
    gl::WarpRoom room;
    gl::PlanTables tables;
    for (const char* text : kTechniques) {
        int compared = 0;
        double farthest = 0;
        forEachCase(30, [&](Rng& rng) {
            const Warped w(rng, text, rng.integer(4, 24), rng.integer(4, 20));
            FitScratch scratch;
            const auto layout = layoutWarps(w.input(), scratch);
            ASSERT_TRUE(layout);
            if (layout->fills.empty()) return;
            const ViewSamples samples = seen.look(device(), w.scene.casters(), w.view);
            const FramePlan twin = twinOf(*layout, w, samples);
            ASSERT_EQ(twin.warpTable.size(), layout->plan.warpTable.size());
            if (isAnyAtBorder(twin, samples)) return;
            tables.upload(layout->plan);
            pass.run(layout->plan, layout->fills[0], w.view, w.light, seen.points, tables, room);
            const std::vector<float> knots = tables.download().warpKnots;
            ++compared;
            double apart = 0;
            for (std::size_t i = 0; i < knots.size(); ++i)
                apart = std::max(apart, std::abs(double(knots[i]) - double(twin.warpTable[i])));
            EXPECT_LT(apart, 1e-5) << text;
            farthest = std::max(farthest, apart);
        });
        std::printf("%s: %d compared, knots at most %.2g apart\n", text, compared, farthest);
        EXPECT_GT(compared, 8) << text;
    }
}

TEST_F(WarpFillTest, WhatIsNotInThePictureIsLeftToThePlan)
{
    Rng rng(1);
    FitScratch scratch;
    for (const char* text :
         {"focused", "now(importance=count*boundaries)", "now(analysis=forward)", "rtw(analysis=hybrid)"})
        EXPECT_FALSE(layoutWarps(Warped(rng, text, 8, 8).input(), scratch)) << text;
}

// Of the same samples, in double by the plan and in float by the device, few lie so near a border that a shadow differs.
TEST_F(WarpFillTest, AFrameWithWarpsOfTheDeviceShowsTheShadowsOfTheTwinsPlan)
{
    GlExecutor executor;
    std::size_t all = 0, differing = 0;
    forEachCase(8, [&](Rng& rng) {
        const Warped w(rng, "now(importance=count*edges)", 150, 120);
        CasterBuffers casters = w.scene.casters();
        casters.version = rng.bits() | 1;
        const CasterSource source = casters;
        FitScratch scratch;
        const auto layout = layoutWarps(w.input(), scratch);
        if (layout->fills.empty()) return;
        const ViewSamples samples = executor.viewSamples(casters, w.view);
        const FramePlan twin = twinOf(*layout, w, samples);
        GlExecutor::Frame frame{casters, source, w.view, layout->plan, {&w.light, 1}, ObservationGrid{150, 120}};
        frame.warps = layout->fills;
        const Observation onDevice = executor.observe(frame);
        frame.warps = {};
        const GlExecutor::Frame ofTwin{casters, source, w.view, twin, {&w.light, 1}, ObservationGrid{150, 120}};
        const Observation fromTwin = executor.observe(ofTwin);
        ASSERT_EQ(onDevice.lit.size(), fromTwin.lit.size());
        for (std::size_t i = 0; i < onDevice.lit.size(); ++i) {
            ++all;
            differing += onDevice.lit[i] != fromTwin.lit[i];
        }
    });
    std::printf("%zu of %zu differ\n", differing, all);
    EXPECT_LT(double(differing), 1e-3 * double(all));
}

TEST_F(WarpFillTest, AFrameMakesNoObjectAfterTheFirstAndItsWarpHasAPassAndBytes)
{
    GlExecutor executor;
    Rng rng(6);
    const Warped w(rng, "now(importance=count*edges)", 90, 70);
    CasterBuffers casters = w.scene.casters();
    casters.version = 5;
    const CasterSource source = casters;
    FitScratch scratch;
    const auto layout = layoutWarps(w.input(), scratch);
    ASSERT_TRUE(layout && !layout->fills.empty());
    GlExecutor::Frame frame{casters, source, w.view, layout->plan, {&w.light, 1}};
    frame.warps = layout->fills;
    const Image<Rgba8> first = executor.render(frame);
    const std::uint64_t before = gl::objectsMade();
    for (int i = 0; i < 3; ++i) {
        const Image<Rgba8> again = executor.render(frame);
        EXPECT_TRUE(std::equal(again.data().begin(), again.data().end(), first.data().begin()));
    }
    EXPECT_EQ(gl::objectsMade(), before);
    std::vector<std::string> names;
    for (const FrameTimes::Pass& pass : executor.measure(frame, 1).passes) names.push_back(pass.name);
    EXPECT_EQ(names, (std::vector<std::string>{"view", "gather", "importance", "light depth", "lookup", "shade"}));
    EXPECT_GT(executor.warpBytes(), 0u);
}

} // namespace
} // namespace lixel::test
