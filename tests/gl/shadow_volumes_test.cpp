// SPDX-License-Identifier: MIT
#include "graphics.h"
#include "shadow_drawer.h"

#include "lixel/gl/executor.h"
#include "lixel/judge/score.h"
#include "lixel/trace/exact_visibility.h"
#include "lixel/trace/trace_scene.h"

#include <cmath>
#include <cstdio>

namespace lixel::test {
namespace {

class ShadowVolumes : public GlTest
{
};

View anyPerspectiveViewOf(Rng& rng, Vec3d centreWorld, double half, int width, int height)
{
    while (true) {
        const View view = anyViewOf(rng, centreWorld, half, width, height);
        if (view.eyeAnchored.w != 0) return view;
    }
}

// Open, crossing, non-manifold: as they come.
SmallScene anyOpaqueSoup(Rng& rng, int triangles)
{
    SmallScene scene = anyTriangleSoup(rng, triangles, 1);
    for (Material& material : scene.materials) material.alphaMode = AlphaMode::Opaque;
    return scene;
}

// The rasterizer, whose corners stand at parts of a pixel, finds triangles that the ray through the centre just misses; such a
// sample stands on an edge of its triangle, where a volume begins.
bool isOffCentre(const ViewSamples& samples, const View& view, std::size_t i)
{
    const Vec3d at = pixelFromLocal(view, samples.originWorld, toDouble(samples.positionLocal[i]));
    return std::hypot(at.x - double(samples.pixel[i].x), at.y - double(samples.pixel[i].y)) > 1e-5;
}

// Against exact visibility, over all cases.
struct Tally
{
    std::int64_t lightFacing = 0, wrong = 0, interior = 0, interiorWrong = 0, offCentre = 0;

    void add(const ViewSamples& samples, const View& view, const Light& light, const Visibility& visibility,
             std::span<const float> exact)
    {
        const std::vector<Zone> zones = zonesOf(samples, light, exact);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (zones[i] == Zone::FacingAway) continue;
            const bool isWrong = (visibility.value[i] >= 0.5f) != (exact[i] >= 0.5f);
            const bool isInterior = zones[i] == Zone::Interior, isOff = isWrong && isOffCentre(samples, view, i);
            ++lightFacing, wrong += isWrong, offCentre += isInterior && isOff;
            interior += isInterior, interiorWrong += isInterior && isWrong && !isOff;
        }
    }
    void print() const
    {
        std::printf("%lld of %lld wrong; in the interior %lld of %lld, and %lld on edges of their own triangles\n",
                    static_cast<long long>(wrong), static_cast<long long>(lightFacing),
                    static_cast<long long>(interiorWrong), static_cast<long long>(interior),
                    static_cast<long long>(offCentre));
    }
};

Tally tallyOf(int cases, const std::function<SmallScene(Rng&)>& anyScene)
{
    GlExecutor executor;
    Tally tally;
    forEachCase(cases, [&](Rng& rng) {
        const SmallScene scene = anyScene(rng);
        const View view = anyPerspectiveViewOf(rng, scene.originWorld, 1, 160, 120);
        std::vector<Light> lights;
        for (int i = rng.integer(1, 3); i > 0; --i)
            lights.push_back(anyLightOn(rng, scene.originWorld, 1, 0.3, rng.chance(0.2) ? 1e6 : 50));
        const ViewSamples samples = executor.viewSamples(scene.casters(), view);
        const auto visibility = executor.shadowVolumes(scene.casters(), view, lights, samples);
        ASSERT_TRUE(visibility);
        const TraceScene traced(scene.casters());
        for (std::size_t i = 0; i < lights.size(); ++i) {
            const std::vector<float> exact = exactVisibility(traced, samples, lights[i]);
            tally.add(samples, view, lights[i], (*visibility)[i], exact);
        }
    });
    tally.print();
    return tally;
}

TEST_F(ShadowVolumes, AreExactOnObjectsOnAFloor)
{
    const Tally tally = tallyOf(60, [](Rng& rng) { return anyObjectsOnAFloor(rng, 1); });
    EXPECT_LT(double(tally.wrong), 5e-4 * double(tally.lightFacing));
    EXPECT_LE(double(tally.interiorWrong), 1e-5 * double(tally.interior));
    EXPECT_GT(tally.interior, 100000);
}

TEST_F(ShadowVolumes, AreExactOnTrianglesWithoutOrder)
{
    const Tally tally = tallyOf(60, [](Rng& rng) { return anyOpaqueSoup(rng, rng.integer(1, 200)); });
    EXPECT_LT(double(tally.wrong), 5e-4 * double(tally.lightFacing));
    EXPECT_LE(double(tally.interiorWrong), 1e-5 * double(tally.interior));
}

TEST_F(ShadowVolumes, DoNotCareHowTrianglesAreTurned)
{
    GlExecutor executor;
    forEachCase(10, [&](Rng& rng) {
        const SmallScene scene = anyObjectsOnAFloor(rng, 1);
        SmallScene turned = scene;
        for (std::size_t t = 0; t + 2 < turned.indices.size(); t += 3)
            if (rng.chance(0.5)) std::swap(turned.indices[t], turned.indices[t + 1]);
        const View view = anyPerspectiveViewOf(rng, {}, 1, 160, 120);
        const Light light = anyLightOn(rng, {}, 1);
        const ViewSamples samples = executor.viewSamples(scene.casters(), view);
        const auto one = executor.shadowVolumes(scene.casters(), view, {&light, 1}, samples);
        const auto other = executor.shadowVolumes(turned.casters(), view, {&light, 1}, samples);
        ASSERT_TRUE(one && other);
        std::size_t differing = 0;
        for (std::size_t i = 0; i < samples.size(); ++i) differing += (*one)[0].value[i] != (*other)[0].value[i];
        EXPECT_LE(differing, samples.size() / 10000);
    });
}

// Where bodies touch, what is seen lies in the planes of triangles that are not its own.
TEST_F(ShadowVolumes, SurfacesThatCoincideDoNotShadowEachOther)
{
    const Tally tally = tallyOf(20, [](Rng& rng) {
        SmallScene scene = anyObjectsOnAFloor(rng, 1);
        for (std::vector<std::uint32_t>* list : {&scene.indices, &scene.material}) {
            const std::vector<std::uint32_t> once = *list;
            list->insert(list->end(), once.begin(), once.end());
        }
        return scene;
    });
    EXPECT_LT(double(tally.wrong), 5e-4 * double(tally.lightFacing));
    EXPECT_LE(double(tally.interiorWrong), 1e-5 * double(tally.interior));
}

TEST_F(ShadowVolumes, HoldAnEyeInsideThem)
{
    // A roof over the eye and all that it sees, lit from above: all in shadow but the roof's far surroundings.
    SmallScene scene;
    scene.addQuad({-4, 0, 4}, {4, 0, 4}, {4, 0, -4}, {-4, 0, -4});
    scene.addQuad({-2, 2, 2}, {2, 2, 2}, {2, 2, -2}, {-2, 2, -2});
    const View view = perspectiveView({0, 1, 0}, {3, 0, 0}, {0, 1, 0}, 1.2, 0.01, 100, 160, 120);
    GlExecutor executor;
    const ViewSamples samples = executor.viewSamples(scene.casters(), view);
    Light sun, lamp;
    sun.directionWorld = {0, -1, 0};
    lamp.kind = LightKind::Point, lamp.positionWorld = {0, 200, 0};
    const std::vector<Light> lights{sun, lamp};
    const auto visibility = executor.shadowVolumes(scene.casters(), view, lights, samples);
    ASSERT_TRUE(visibility);
    std::size_t dark = 0, lit = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double x = std::abs(double(samples.positionLocal[i].x + samples.originWorld.x));
        const double z = std::abs(double(samples.positionLocal[i].z + samples.originWorld.z));
        const double outermost = std::max(x, z);
        for (const Visibility& light : *visibility) {
            if (outermost < 1.95) {
                EXPECT_EQ(light.value[i], 0) << x << " " << z;
                ++dark;
            }
            if (outermost > 2.1) {
                EXPECT_EQ(light.value[i], 1) << x << " " << z;
                ++lit;
            }
        }
    }
    EXPECT_GT(dark, 1000u);
    EXPECT_GT(lit, 1000u);
}

// One body under one light, nothing else. On its outline the rasterizer may find the inside of a sphere, which is dark.
void expectAloneIsLit(GlExecutor& executor, Rng& rng)
{
    const double half = rng.logUniform(1e-3, 1e4);
    SmallScene scene;
    scene.originWorld = rng.chance(0.3) ? 1e5 * rng.onSphere() : Vec3d{};
    if (rng.chance(0.5)) scene.addSphere({}, half, rng.integer(4, 40));
    else
        scene.addQuad(toFloat(half * Vec3d{-1, 0, 1}), toFloat(half * Vec3d{1, 0, 1}), toFloat(half * Vec3d{1, 0, -1}),
                      toFloat(half * Vec3d{-1, 0, -1}));
    const View view = anyPerspectiveViewOf(rng, scene.originWorld, half, 80, 60);
    const Light light = anyLightOn(rng, scene.originWorld, half, 1.2, 1e6);
    const ViewSamples samples = executor.viewSamples(scene.casters(), view);
    const auto visibility = executor.shadowVolumes(scene.casters(), view, {&light, 1}, samples);
    ASSERT_TRUE(visibility);
    const std::vector<float> exact = exactVisibility(TraceScene(scene.casters()), samples, light);
    std::size_t dark = 0, inside = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (!isLightFacing(light, scene.originWorld, toDouble(samples.positionLocal[i]), toDouble(samples.normal[i])))
            continue;
        const bool isInside = exact[i] < 0.5f && isOffCentre(samples, view, i);
        inside += isInside;
        dark += !isInside && (*visibility)[0].value[i] != 1;
    }
    EXPECT_LE(inside, 2u);
    EXPECT_EQ(dark, 0u) << "half " << half << " light " << int(light.kind) << " of " << samples.size();
}

TEST_F(ShadowVolumes, APlaneOrSphereAloneIsLitAtAnySlopeAndScale)
{
    GlExecutor executor;
    forEachCase(kCases, [&](Rng& rng) { expectAloneIsLit(executor, rng); });
}

// By what the rasterizer rounds: across a plane's border its volume's side came before the sample, and a sample of a sphere is on
// the inside.
TEST_F(ShadowVolumes, ASampleOnTheOutlineOfABodyAloneIsLit)
{
    GlExecutor executor;
    for (const std::uint64_t seed : {20040722, 20041067}) {
        Rng rng(seed);
        expectAloneIsLit(executor, rng);
    }
}

TEST_F(ShadowVolumes, AreRefusedByNameForHolesAndParallelViews)
{
    GlExecutor executor;
    SmallScene scene;
    scene.addQuad({-4, 0, 4}, {4, 0, 4}, {4, 0, -4}, {-4, 0, -4});
    const Light sun;
    const View parallel = orthographicView({0, 3, 0}, {1, 0, 0}, {0, 1, 0}, 4, 0.1, 10, 16, 12);
    const auto flat =
        executor.shadowVolumes(scene.casters(), parallel, {&sun, 1}, executor.viewSamples(scene.casters(), parallel));
    ASSERT_FALSE(flat);
    EXPECT_EQ(nameOf(flat.error()), "parallel-view");

    scene.materials.resize(1);
    scene.materials[0].alphaMode = AlphaMode::Mask;
    const View view = perspectiveView({0, 3, 0}, {1, 0, 0}, {0, 1, 0}, 1, 0.1, 10, 16, 12);
    const auto holed =
        executor.shadowVolumes(scene.casters(), view, {&sun, 1}, executor.viewSamples(scene.casters(), view));
    ASSERT_FALSE(holed);
    EXPECT_EQ(nameOf(holed.error()), "masked-casters");
}

TEST_F(ShadowVolumes, AnEmptySceneIsLit)
{
    GlExecutor executor;
    const SmallScene scene;
    const View view = perspectiveView({0, 3, 0}, {1, 0, 0}, {0, 1, 0}, 1, 0.1, 10, 16, 12);
    const Light sun;
    const auto visibility =
        executor.shadowVolumes(scene.casters(), view, {&sun, 1}, executor.viewSamples(scene.casters(), view));
    ASSERT_TRUE(visibility);
    EXPECT_EQ(visibility->size(), 1u);
    EXPECT_TRUE((*visibility)[0].value.empty());
}

} // namespace
} // namespace lixel::test
