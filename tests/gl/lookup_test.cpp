// SPDX-License-Identifier: MIT
#include "graphics.h"
#include "shadow_drawer.h"

#include "lixel/trace/trace_view_samples.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>

namespace lixel::test {
namespace {

class LookupTest : public GlTest
{
};

ViewSamples anySamples(Rng& rng, int count, double half)
{
    ViewSamples samples;
    samples.width = 64, samples.height = 64;
    for (int i = 0; i < count; ++i) {
        samples.pixel.push_back({float(rng.integer(0, 63)) + 0.5f, float(rng.integer(0, 63)) + 0.5f});
        samples.positionLocal.push_back(toFloat(rng.inBox(half)));
        samples.normal.push_back(toFloat(rng.onSphere()));
        samples.triangle.push_back(kNoTriangle);
    }
    return samples;
}

constexpr std::array kLookups{"pcf(1)",
                              "pcf(4)",
                              "pcf(9)",
                              "pcf(16)",
                              "pcf(25)",
                              "pcf(16,rotated)",
                              "pcf(9,jittered)",
                              "bilinear",
                              "hardware-pcf",
                              "dual-plane",
                              "bilinear+dual-plane",
                              "fast-pcf",
                              "depths(2,max)",
                              "depths(2,min)+pcf(9)",
                              "depths(3,q=25)+pcf(4)",
                              "depths(4)+pcf(4)",
                              "depths(5)+pcf(4)",
                              "depths(8,q=25)+pcf(9)+dual-plane"};

TEST_F(LookupTest, ShaderAndCppAgreeOnAnyMap)
{
    ShadowDrawer draw(device());
    std::size_t all = 0, differing = 0, unserved = 0;
    std::map<std::string, std::size_t> differingBy;
    forEachCase(200, [&](Rng& rng) {
        const SmallScene scene = anyObjectsOnAFloor(rng, 1);
        const View view = anyViewOf(rng, {}, 1, 64, 64);
        std::vector<Light> lights;
        for (int i = rng.integer(1, 4); i > 0; --i) lights.push_back(anyLightOn(rng, {}, 1));
        const std::string lookup = kLookups[std::size_t(rng.integer(0, int(kLookups.size()) - 1))];
        const auto technique = std::get<MapTechnique>(*parseTechnique(lookup));
        const FramePlan plan = planFor(scene, view, lights, {rng.integer(8, 60), rng.integer(8, 60)}, technique);
        TracedAtlas maps;
        for (int i = 0; i < plan.layers; ++i) {
            maps.emplace_back(plan.atlas.width, plan.atlas.height);
            for (float& depth : maps.back().data()) depth = rng.chance(0.2) ? 0.0f : float(rng.uniform(0, 1));
        }
        draw.writeAtlas(plan, maps);
        const PreparedMaps prepared = prepareMaps(plan, maps);
        const ViewSamples samples = anySamples(rng, rng.integer(0, 2000), 1.2);
        const std::vector<Visibility> shader = draw.lookUp(plan, samples);
        for (std::size_t light = 0; light < lights.size(); ++light) {
            const Visibility cpp = lookUp(plan, maps, prepared, samples, light);
            for (std::size_t i = 0; i < samples.size(); ++i) {
                ++all;
                unserved += cpp.unserved[i];
                // A texture unit has fewer digits of the areas.
                const double most = lookup == "hardware-pcf" ? 1.0 / 128 : 1e-6;
                const bool isDiffering = shader[light].unserved[i] != cpp.unserved[i] ||
                                         std::abs(shader[light].value[i] - cpp.value[i]) > most;
                differing += isDiffering;
                differingBy[lookup] += isDiffering;
            }
        }
    });
    std::printf("%zu of %zu differ, %zu unserved\n", differing, all, unserved);
    for (const auto& [lookup, count] : differingBy)
        if (count > 0) std::printf("  %zu by %s\n", count, lookup.c_str());
    EXPECT_LT(double(differing), 1e-4 * double(all));
    EXPECT_GT(unserved, 0u);
}

TEST_F(LookupTest, AnUnoccludedPlaneOrSphereIsLitAtAnySlopeAndScale)
{
    ShadowDrawer draw(device());
    std::size_t all = 0;
    forEachCase(60, [&](Rng& rng) {
        const double half = rng.logUniform(1e-3, 1e4);
        SmallScene scene;
        scene.originWorld = rng.chance(0.3) ? 1e5 * rng.onSphere() : Vec3d{};
        if (rng.chance(0.5)) scene.addSphere({}, half, rng.integer(4, 40));
        else {
            const Vec3d n = rng.onSphere(), a = half * anyPerpendicular(n), b = cross(n, a);
            scene.addQuad(toFloat(-a - b), toFloat(a - b), toFloat(a + b), toFloat(b - a));
        }
        const View view = anyViewOf(rng, scene.originWorld, half, 80, 60);
        const Light light = anyLightOn(rng, scene.originWorld, half, 1.2, 1e6);
        auto technique =
            std::get<MapTechnique>(*parseTechnique(kLookups[std::size_t(rng.integer(0, int(kLookups.size()) - 1))]));
        if (rng.chance(0.3)) technique.fit = UniformFit{};
        const int side = rng.integer(8, 512);
        const FramePlan plan = planFor(scene, view, {&light, 1}, {side, side}, technique);
        if (plan.lights[0].refused) return;
        const ViewSamples samples = traceViewSamples(TraceScene(scene.casters()), view);
        draw.drawAtlas(plan, scene.casters());
        const std::vector<Visibility> visibility = draw.lookUp(plan, samples);
        std::size_t dark = 0, unserved = 0;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (!isLightFacing(light, scene.originWorld, toDouble(samples.positionLocal[i]),
                               toDouble(samples.normal[i])))
                continue;
            ++all;
            dark += visibility[0].value[i] < 1 - 1e-6f; // areas of four lixels add up to one but for rounding
            unserved += visibility[0].unserved[i];
        }
        EXPECT_EQ(dark, 0u) << "half " << half << " light " << int(light.kind) << " lixels " << side << " of "
                            << samples.size();
        EXPECT_EQ(unserved, 0u);
    });
    EXPECT_GT(all, 10000u);
}

} // namespace
} // namespace lixel::test
