// SPDX-License-Identifier: MIT
// Drawing into warped maps, against maps of rays.
#include "graphics.h"
#include "shadow_drawer.h"
#include "warped_plans.h"

#include "plan/random_warps.h"

#include "lixel/gl/executor.h"
#include "lixel/trace/trace_view_samples.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lixel::test {
namespace {

class WarpedDepthTest : public GlTest
{
};

// Lixels whose depths differ by more than 1e-4 of the range.
struct Apart
{
    std::size_t lixels = 0, apart = 0;
    double share() const { return double(apart) / double(lixels); }

    void add(const TracedAtlas& drawn, const TracedAtlas& traced)
    {
        ASSERT_EQ(drawn.size(), traced.size());
        for (std::size_t layer = 0; layer < drawn.size(); ++layer)
            for (std::size_t i = 0; i < drawn[layer].data().size(); ++i) {
                ++lixels;
                apart += !(std::abs(double(drawn[layer].data()[i]) - double(traced[layer].data()[i])) <= 1e-4);
            }
    }
};

// Scenes of any scale, lights far away and among the triangles, so that some lie across w = 0 and behind; holes.
TEST_F(WarpedDepthTest, ExactMapsAreThoseOfRays)
{
    ShadowDrawer draw(device());
    Apart all;
    forEachCase(60, [&](Rng& rng) {
        const double half = rng.logUniform(1e-3, 1e4);
        SmallScene scene = rng.chance(0.5) ? anyObjectsOnAFloor(rng, half) : anyTriangleSoup(rng, 60, half);
        const View view = anyViewOf(rng, {}, half, 64, 64);
        const Light light = anyLightOn(rng, {}, half, 0.1, 1e4);
        FramePlan plan = planFor(scene, view, {&light, 1}, {rng.integer(1, 150), rng.integer(1, 150)});
        if (plan.lights[0].refused) return;
        warpRegions(plan, rng, WarpRaster::Exact, rng.integer(0, 2));
        all.add(draw.drawAtlas(plan, scene.casters()), traceAtlas(TraceScene(scene.casters()), plan));
    });
    std::printf("%zu of %zu lixels apart\n", all.apart, all.lixels);
    EXPECT_LT(all.share(), 1e-4);
}

// What lies in the guard bands alone, where a warp is the identity, is drawn too: taps of wide kernels look there.
TEST_F(WarpedDepthTest, ExactMapsOfPlannedWarpsAreThoseOfRaysToTheEndsOfTheirGuardBands)
{
    ShadowDrawer draw(device());
    Apart all;
    forEachCase(60, [&](Rng& rng) {
        const SmallScene scene = anyObjectsOnAFloor(rng, 1);
        const TraceScene traced(scene.casters());
        const View view = anyViewOf(rng, {}, 1, 64, 64);
        const Light light = anyLightOn(rng, {}, 1, 0.1, 10);
        const ViewSamples samples = traceViewSamples(traced, view);
        const Box box = scene.boxWorld();
        const char* technique = rng.chance(0.5) ? "cube+now+pcf(25,jittered)" : "cube+rtw+pcf(9)";
        const LixelSize lixels{rng.integer(30, 150), rng.integer(30, 150)};
        PlanInput input{view, {&light, 1}, {&box, 1}, {}, std::get<MapTechnique>(*parseTechnique(technique)), lixels};
        input.seen = &samples;
        const FramePlan plan = planShadows(input);
        all.add(draw.drawAtlas(plan, scene.casters()), traceAtlas(traced, plan));
    });
    std::printf("%zu of %zu lixels apart\n", all.apart, all.lixels);
    EXPECT_LT(all.share(), 1e-5);
}

// Large triangles are shared among invocations and looked at run by run.
TEST_F(WarpedDepthTest, ExactMapsOfManyLixelsAndManyRegionsAreThoseOfRays)
{
    ShadowDrawer draw(device());
    Rng rng(3);
    const SmallScene scene = anyObjectsOnAFloor(rng, 1);
    const View view = anyViewOf(rng, {}, 1, 64, 64);
    std::vector<Light> lights;
    for (int i = 0; i < 5; ++i) lights.push_back(anyLightOn(rng, {}, 1));
    FramePlan plan = planFor(scene, view, lights, {700, 900});
    warpRegions(plan, rng, WarpRaster::Exact, 1);
    Apart all;
    all.add(draw.drawAtlas(plan, scene.casters()), traceAtlas(TraceScene(scene.casters()), plan));
    EXPECT_LT(all.share(), 1e-4);
}

// A lamp among the triangles: they lie in both halves, across the rim and straight behind. With a further warp half of the times.
struct LampCase
{
    SmallScene scene;
    FramePlan plan;

    LampCase(Rng& rng, const char* technique, bool isWarped)
        : scene(rng.chance(0.5) ? anyObjectsOnAFloor(rng, 1) : anyTriangleSoup(rng, 60, 1))
    {
        const View view = anyViewOf(rng, {}, 1, 64, 64);
        Light lamp;
        lamp.kind = rng.chance(0.8) ? LightKind::Point : LightKind::Spot;
        lamp.positionWorld = rng.logUniform(0.1, 10) * rng.onSphere();
        lamp.directionWorld = normalized(-lamp.positionWorld);
        const Box box = scene.boxWorld();
        plan = planShadows({view,
                            {&lamp, 1},
                            {&box, 1},
                            {},
                            std::get<MapTechnique>(*parseTechnique(technique)),
                            {rng.integer(20, 150), rng.integer(20, 150)}});
        const WarpRaster raster =
            plan.lights[0].regions.empty() ? WarpRaster::Exact : plan.lights[0].regions[0].warp.raster;
        for (PlannedRegion& region : plan.lights[0].regions)
            if (isWarped) region.warp = anyWarp(region.rectangle, rng), region.warp.raster = raster;
        rebuildWarps(plan);
    }
};

TEST_F(WarpedDepthTest, ExactMapsOnParaboloidsAreThoseOfRays)
{
    ShadowDrawer draw(device());
    Apart all;
    forEachCase(80, [&](Rng& rng) {
        const LampCase lamp(rng, rng.chance(0.5) ? "dual-paraboloid" : "dual-paraboloid+uniform", rng.chance(0.5));
        all.add(draw.drawAtlas(lamp.plan, lamp.scene.casters()),
                traceAtlas(TraceScene(lamp.scene.casters()), lamp.plan));
    });
    std::printf("%zu of %zu lixels apart\n", all.apart, all.lixels);
    EXPECT_LT(all.share(), 1e-4);
}

TEST_F(WarpedDepthTest, OnParaboloidsCutTrianglesComeNearerToRaysThanMovedOnes)
{
    ShadowDrawer draw(device());
    Apart moved, cut;
    forEachCase(30, [&](Rng& rng) {
        LampCase lamp(rng, "dual-paraboloid(raster=vertices)+uniform", false);
        const TracedAtlas traced = traceAtlas(TraceScene(lamp.scene.casters()), lamp.plan);
        moved.add(draw.drawAtlas(lamp.plan, lamp.scene.casters()), traced);
        for (PlannedRegion& region : lamp.plan.lights[0].regions) region.warp.raster = WarpRaster::Tessellate;
        cut.add(draw.drawAtlas(lamp.plan, lamp.scene.casters()), traced);
    });
    std::printf("%zu moved, %zu cut, of %zu lixels apart\n", moved.apart, cut.apart, cut.lixels);
    EXPECT_LT(cut.share(), 0.75 * moved.share());
}

TEST_F(WarpedDepthTest, ExactMapsOfAnEvenWarpAreThoseWithout)
{
    ShadowDrawer draw(device());
    Apart all;
    forEachCase(10, [&](Rng& rng) {
        const SmallScene scene = anyTriangleSoup(rng, 60, 1);
        const View view = anyViewOf(rng, {}, 1, 64, 64);
        const Light light = anyLightOn(rng, {}, 1);
        FramePlan plan = planFor(scene, view, {&light, 1}, {100, 90});
        if (plan.lights[0].refused) return;
        const TracedAtlas plain = draw.drawAtlas(plan, scene.casters());
        plan.lights[0].regions[0].warp = smoothWarp(plan.lights[0].regions[0].rectangle, 30, 1, rng);
        rebuildWarps(plan);
        all.add(draw.drawAtlas(plan, scene.casters()), plain);
    });
    std::printf("%zu of %zu lixels apart\n", all.apart, all.lixels);
    EXPECT_LT(all.share(), 5e-3); // a rasterizer moves edges by 1/256 of a lixel
}

TEST_F(WarpedDepthTest, RegionsBesideAWarpedOneAreDrawnAsIfItWereNotThere)
{
    ShadowDrawer draw(device());
    for (const WarpRaster raster : {WarpRaster::Vertices, WarpRaster::Tessellate, WarpRaster::Exact}) {
        Rng rng(9);
        const SmallScene scene = anyTriangleSoup(rng, 100, 1);
        const View view = anyViewOf(rng, {}, 1, 64, 64);
        std::vector<Light> lights;
        for (int i = 0; i < 20; ++i) lights.push_back(anyLightOn(rng, {}, 1));
        FramePlan plan = planFor(scene, view, lights, {64, 48});
        const TracedAtlas plain = draw.drawAtlas(plan, scene.casters());
        for (std::size_t i = 0; i < lights.size(); i += 3)
            for (PlannedRegion& region : plan.lights[i].regions) {
                region.warp = smoothWarp(region.rectangle, 20, 3, rng);
                region.warp.raster = raster;
            }
        rebuildWarps(plan);
        const TracedAtlas maps = draw.drawAtlas(plan, scene.casters());
        for (std::size_t i = 0; i < lights.size(); ++i) {
            if (plan.lights[i].regions.empty()) continue;
            const auto layer = std::size_t(plan.lights[i].regions[0].rectangle.layer);
            EXPECT_EQ(maps[layer].data() == plain[layer].data(), i % 3 != 0) << "light " << i;
        }
    }
}

TEST_F(WarpedDepthTest, CutTrianglesComeNearerToRaysThanMovedOnes)
{
    ShadowDrawer draw(device());
    Apart moved, cut;
    forEachCase(20, [&](Rng& rng) {
        const SmallScene scene = anyTriangleSoup(rng, 60, 1);
        const View view = anyViewOf(rng, {}, 1, 64, 64);
        const Light light = anyLightOn(rng, {}, 1);
        FramePlan plan = planFor(scene, view, {&light, 1}, {128, 128});
        if (plan.lights[0].refused) return;
        PlannedRegion& region = plan.lights[0].regions[0];
        region.warp = smoothWarp(region.rectangle, 64, 3, rng);
        rebuildWarps(plan);
        const TracedAtlas traced = traceAtlas(TraceScene(scene.casters()), plan);
        region.warp.raster = WarpRaster::Vertices;
        moved.add(draw.drawAtlas(plan, scene.casters()), traced);
        region.warp.raster = WarpRaster::Tessellate;
        cut.add(draw.drawAtlas(plan, scene.casters()), traced);
    });
    std::printf("%zu moved, %zu cut, of %zu lixels apart\n", moved.apart, cut.apart, cut.lixels);
    EXPECT_LT(cut.share(), 0.75 * moved.share());
}

// A floor of triangles that share edges, beyond all of the map, cut up unevenly.
TEST_F(WarpedDepthTest, NoCrackOpensWhereTrianglesAreCutUp)
{
    ShadowDrawer draw(device());
    std::size_t holes = 0, covered = 0;
    forEachCase(20, [&](Rng& rng) {
        SmallScene scene;
        const auto corner = [&](int i, int j) {
            const bool isInside = i > 0 && j > 0 && i < 4 && j < 4;
            const auto at = [&](int k) { return 4 * float(k - 2) + (isInside ? float(rng.uniform(-0.3, 0.3)) : 0.0f); };
            return Vec3f{at(i), 0, at(j)};
        };
        for (int j = 0; j <= 4; ++j)
            for (int i = 0; i <= 4; ++i) scene.positions.push_back(corner(i, j));
        for (std::uint32_t j = 0; j < 4; ++j)
            for (std::uint32_t i = 0; i < 4; ++i) {
                const std::uint32_t a = 5 * j + i;
                for (const std::uint32_t index : {a, a + 1, a + 6, a, a + 6, a + 5}) scene.indices.push_back(index);
            }
        scene.material.assign(scene.indices.size() / 3, 0);
        const View view = perspectiveView({0, 1, 1}, {0, 0, 0}, {0, 1, 0}, 0.6, 0.1, 10, 64, 64);
        Light sun;
        sun.directionWorld = normalized(Vec3d{rng.uniform(-0.5, 0.5), -1, rng.uniform(-0.5, 0.5)});
        FramePlan plan = planFor(scene, view, {&sun, 1}, {120, 110});
        ASSERT_FALSE(plan.lights[0].refused);
        PlannedRegion& region = plan.lights[0].regions[0];
        region.warp = smoothWarp(region.rectangle, 64, 4, rng);
        region.warp.raster = WarpRaster::Tessellate;
        rebuildWarps(plan);
        // Near the far side a moved depth may fall behind it.
        const TracedAtlas traced = traceAtlas(TraceScene(scene.casters()), plan),
                          drawn = draw.drawAtlas(plan, scene.casters());
        for (std::size_t i = 0; i < traced[0].data().size(); ++i) {
            if (traced[0].data()[i] < 0.05f) continue;
            ++covered;
            holes += drawn[0].data()[i] <= 0;
        }
    });
    EXPECT_EQ(holes, 0u);
    EXPECT_GT(covered, 100000u);
}

TEST_F(WarpedDepthTest, BothExecutorsAgreeOnSamplesLookedUpInWarpedMaps)
{
    GlExecutor executor;
    std::size_t all = 0, differing = 0;
    forEachCase(10, [&](Rng& rng) {
        const SmallScene scene = anyObjectsOnAFloor(rng, 1);
        const View view = anyViewOf(rng, {}, 1, 160, 120);
        const Light light = anyLightOn(rng, {}, 1);
        FramePlan plan = planFor(scene, view, {&light, 1}, {128, 128});
        if (plan.lights[0].refused) return;
        const CasterBuffers casters = scene.casters();
        const ViewSamples samples = executor.viewSamples(casters, view);
        plan.lights[0].regions[0].warp = countedWarp(plan.lights[0].regions[0], samples, 8);
        rebuildWarps(plan);
        const std::vector<Visibility> drawn = executor.run(plan, casters, samples);
        const std::vector<Visibility> traced = runTraced(TraceScene(casters), plan, samples);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (!isLightFacing(light, {}, toDouble(samples.positionLocal[i]), toDouble(samples.normal[i]))) continue;
            ++all;
            differing += drawn[0].value[i] != traced[0].value[i];
        }
    });
    std::printf("%zu of %zu differ\n", differing, all);
    EXPECT_LT(double(differing), 2e-4 * double(all));
}

TEST_F(WarpedDepthTest, BothExecutorsAgreeOnSamplesLookedUpOnParaboloids)
{
    GlExecutor executor;
    std::size_t all = 0, differing = 0;
    forEachCase(10, [&](Rng& rng) {
        const SmallScene scene = anyObjectsOnAFloor(rng, 1);
        const View view = anyViewOf(rng, {}, 1, 160, 120);
        Light lamp;
        lamp.kind = LightKind::Point;
        lamp.positionWorld = Vec3d{rng.uniform(-1, 1), rng.uniform(0.8, 2), rng.uniform(-1, 1)};
        const CasterBuffers casters = scene.casters();
        const ViewSamples samples = executor.viewSamples(casters, view);
        const Box box = scene.boxWorld();
        const char* techniques[] = {"dual-paraboloid", "dual-paraboloid+pcf(9)", "dual-paraboloid+desired-view+now",
                                    "cube+now"};
        PlanInput input{view,
                        {&lamp, 1},
                        {&box, 1},
                        {},
                        std::get<MapTechnique>(*parseTechnique(techniques[rng.integer(0, 3)])),
                        {128, 128}};
        input.seen = &samples;
        const FramePlan plan = planShadows(input);
        if (plan.lights[0].refused) return;
        const std::vector<Visibility> drawn = executor.run(plan, casters, samples);
        const std::vector<Visibility> traced = runTraced(TraceScene(casters), plan, samples);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (!isLightFacing(lamp, {}, toDouble(samples.positionLocal[i]), toDouble(samples.normal[i]))) continue;
            ++all;
            differing += drawn[0].value[i] != traced[0].value[i];
        }
    });
    std::printf("%zu of %zu differ\n", differing, all);
    EXPECT_LT(double(differing), 2e-4 * double(all));
}

TEST_F(WarpedDepthTest, MapsAreDrawnAgainWhenTheirWarpOrItsRasterDiffers)
{
    GlExecutor executor;
    Rng rng(13);
    const SmallScene scene = anyObjectsOnAFloor(rng, 1);
    const View view = anyViewOf(rng, {}, 1, 64, 64);
    const Light sun;
    FramePlan plan = planFor(scene, view, {&sun, 1}, {64, 64});
    CasterBuffers casters = scene.casters();
    casters.version = 7;
    PlannedRegion& region = plan.lights[0].regions[0];
    const auto drawsAgain = [&] {
        rebuildWarps(plan);
        const std::uint64_t before = executor.mapsDrawn();
        executor.drawMaps(plan, casters);
        return executor.mapsDrawn() > before;
    };
    EXPECT_TRUE(drawsAgain());
    region.warp = smoothWarp(region.rectangle, 16, 2, rng);
    EXPECT_TRUE(drawsAgain());
    EXPECT_FALSE(drawsAgain());
    region.warp.rowKnots[3] += 1e-4f;
    EXPECT_TRUE(drawsAgain());
    region.warp.raster = WarpRaster::Vertices;
    EXPECT_TRUE(drawsAgain());
    EXPECT_FALSE(drawsAgain());
}

} // namespace
} // namespace lixel::test
