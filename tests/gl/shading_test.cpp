// SPDX-License-Identifier: MIT
#include "graphics.h"
#include "shadow_drawer.h"

#include "lixel/gl/executor.h"
#include "lixel/plan/shading_light.h"
#include "lixel/trace/surface_colours.h"

#include <algorithm>
#include <cmath>

namespace lixel::test {
namespace {

class ShadingTest : public GlTest
{
};

shared::vec3 toShared(Vec3f v) { return {v.x, v.y, v.z}; }

int code(float displayed) { return int(std::lround(displayed * 255)); }

// What lixel/shared/shading.h says of a sample under lights that nothing blocks but `visibility`.
shared::vec3 displayed(const ViewSamples& samples, std::size_t i, const SurfaceColours& colours,
                       std::span<const Light> lights, std::span<const Visibility> visibility)
{
    const shared::vec3 normal = toShared(colours.shadingNormal[i]);
    shared::vec3 light = shared::lxAmbientLight(normal);
    for (std::size_t k = 0; k < lights.size(); ++k)
        light = light + visibility[k].value[i] * shared::lxDirectLight(shadingLight(lights[k], samples.originWorld),
                                                                       toShared(samples.positionLocal[i]),
                                                                       toShared(samples.normal[i]), normal);
    return shared::lxDisplayed(toShared(colours.baseColour[i]) * light + toShared(colours.emission[i]));
}

TEST_F(ShadingTest, ThePictureIsWhatTheSharedTextSays)
{
    GlExecutor executor;
    forEachCase(kCases, [&](Rng& rng) {
        SmallScene scene = anyObjectsOnAFloor(rng, 1);
        scene.materials.resize(3);
        for (Material& m : scene.materials) {
            m.baseColour = {float(rng.uniform(0, 1)), float(rng.uniform(0, 1)), float(rng.uniform(0, 1)), 1};
            if (rng.chance(0.3)) m.emission = {float(rng.uniform(0, 0.5)), 0, float(rng.uniform(0, 0.5))};
        }
        for (std::uint32_t& m : scene.material) m = std::uint32_t(rng.integer(0, 2));
        if (rng.chance(0.5)) // one normal a corner, any direction
            for (std::size_t i = 0; i < scene.positions.size(); ++i) scene.normals.push_back(toFloat(rng.onSphere()));
        const View view = anyViewOf(rng, {}, 1, 60, 40);
        std::vector<Light> lights;
        for (int i = rng.integer(0, 4); i > 0; --i) {
            lights.push_back(anyLightOn(rng, {}, 1));
            lights.back().colour = {rng.uniform(0, 1.5), rng.uniform(0, 1.5), rng.uniform(0, 1.5)};
            if (rng.chance(0.3)) lights.back().range = length(lights.back().positionWorld) * rng.uniform(0.8, 2);
        }
        const ViewSamples samples = executor.viewSamples(scene.casters(), view);
        std::vector<Visibility> visibility(lights.size());
        for (Visibility& v : visibility)
            for (std::size_t i = 0; i < samples.size(); ++i) v.value.push_back(float(rng.integer(0, 4)) / 4);
        const Image<Rgba8> picture = executor.shade(scene.casters(), view, lights, samples, visibility);
        const SurfaceColours colours = surfaceColours(TraceScene(scene.casters()), samples);
        std::size_t apart = 0;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const Rgba8 got = picture(int(samples.pixel[i].x), int(samples.pixel[i].y));
            const shared::vec3 wanted = displayed(samples, i, colours, lights, visibility);
            const int farthest = std::max(
                {std::abs(got.r - code(wanted.x)), std::abs(got.g - code(wanted.y)), std::abs(got.b - code(wanted.z))});
            apart += farthest > 3; // colour and normal are rounded on the way
        }
        // Where interpolated normals pass the triangle's plane they flip to either side.
        EXPECT_LE(double(apart), 0.01 * double(samples.size()));
    });
}

TEST_F(ShadingTest, ALightWithoutValuesIsLit)
{
    GlExecutor executor;
    Rng rng(1);
    const SmallScene scene = anyObjectsOnAFloor(rng, 1);
    const View view = anyViewOf(rng, {}, 1, 30, 20);
    const Light sun;
    const ViewSamples samples = executor.viewSamples(scene.casters(), view);
    const Visibility lit{std::vector<float>(samples.size(), 1.0f), {}}, none;
    const Image<Rgba8> a = executor.shade(scene.casters(), view, {&sun, 1}, samples, {&lit, 1});
    const Image<Rgba8> b = executor.shade(scene.casters(), view, {&sun, 1}, samples, {&none, 1});
    EXPECT_TRUE(std::ranges::equal(a.data(), b.data(),
                                   [](Rgba8 p, Rgba8 q) { return p.r == q.r && p.g == q.g && p.b == q.b; }));
}

} // namespace
} // namespace lixel::test
