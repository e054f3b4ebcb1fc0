// SPDX-License-Identifier: MIT
#include "graphics.h"
#include "shadow_drawer.h"

#include "lixel/trace/trace_view_samples.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

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

TEST_F(LookupTest, ShaderAndCppAgreeOnAnyMap)
{
    ShadowDrawer draw(device());
    std::size_t all = 0, differing = 0, unserved = 0;
    forEachCase(100, [&](Rng& rng) {
        const SmallScene scene = anyObjectsOnAFloor(rng, 1);
        const View view = anyViewOf(rng, {}, 1, 64, 64);
        std::vector<Light> lights;
        for (int i = rng.integer(1, 4); i > 0; --i) lights.push_back(anyLightOn(rng, {}, 1));
        const std::array<int, 5> kernels{1, 4, 9, 16, 25};
        MapTechnique technique;
        technique.kernel = PcfKernel{kernels[std::size_t(rng.integer(0, 4))]};
        const FramePlan plan = planFor(scene, view, lights, {rng.integer(8, 60), rng.integer(8, 60)}, technique);
        TracedAtlas maps;
        for (int i = 0; i < plan.layers; ++i) {
            maps.emplace_back(plan.atlas.width, plan.atlas.height);
            for (float& depth : maps.back().data()) depth = rng.chance(0.2) ? 0.0f : float(rng.uniform(0, 1));
        }
        draw.writeAtlas(plan, maps);
        const ViewSamples samples = anySamples(rng, rng.integer(0, 2000), 1.2);
        const std::vector<Visibility> shader = draw.lookUp(plan, samples);
        for (std::size_t light = 0; light < lights.size(); ++light) {
            const Visibility cpp = lookUp(plan, maps, samples, light);
            for (std::size_t i = 0; i < samples.size(); ++i) {
                ++all;
                unserved += cpp.unserved[i];
                differing += shader[light].unserved[i] != cpp.unserved[i] ||
                             std::abs(shader[light].value[i] - cpp.value[i]) > 1e-6;
            }
        }
    });
    std::printf("%zu of %zu differ, %zu unserved\n", differing, all, unserved);
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
        MapTechnique technique;
        if (rng.chance(0.3)) technique.fit = UniformFit{};
        if (rng.chance(0.3)) technique.kernel = PcfKernel{9};
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
            dark += visibility[0].value[i] < 1;
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
