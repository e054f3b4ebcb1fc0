// SPDX-License-Identifier: MIT
#include "lixel/trace/surface_colours.h"

#include "lixel/trace/texture_lookup.h"
#include "lixel/trace/trace_view_samples.h"
#include "trace/shapes.h"

#include <gtest/gtest.h>

namespace lixel {
namespace {

using namespace lixel::test;

TEST(SurfaceColours, AreTheProductOfFactorVertexColourAndTexture)
{
    Texture texture;
    texture.pixels = Image<Rgba8>(1, 1, {188, 255, 0, 255});
    Material material;
    material.baseColour = {0.5f, 0.25f, 1, 1}, material.texture = 0, material.emission = {1, 2, 3};
    LocalTriangles casters = triangles(gridPlane(1, 1));
    casters.uv.assign(4, {0, 0});
    for (const Vec3f& p : casters.positionLocal) casters.colour.push_back({0.5f + 0.5f * p.x, 1, 1, 1});
    const TraceScene scene(casters, std::span(&material, 1), std::span(&texture, 1));
    const View view = orthographicView({0, 5, 0}, {0, 0, 0}, {0, 0, -1}, 2, 1, 9, 20, 20);
    const ViewSamples samples = traceViewSamples(scene, view);
    const SurfaceColours colours = surfaceColours(scene, samples);
    ASSERT_EQ(samples.size(), 400u);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const float across = samples.pixel[i].x / 20;
        EXPECT_NEAR(colours.baseColour[i].x, 0.5f * across * linearFromSrgb(188), 1e-6);
        EXPECT_NEAR(colours.baseColour[i].y, 0.25f, 1e-6);
        EXPECT_EQ(colours.baseColour[i].z, 0);
        EXPECT_EQ(colours.emission[i], (Vec3f{1, 2, 3}));
        EXPECT_EQ(colours.shadingNormal[i], samples.normal[i]); // the casters have none
    }
}

TEST(SurfaceColours, ShadingNormalsOfASphereAreRadialAndTurnedToTheEye)
{
    LocalTriangles casters = triangles(sphere(40, 20, 1));
    for (const Vec3f& p : casters.positionLocal)
        casters.normal.push_back(toFloat(-normalized(toDouble(p)))); // turned inwards
    const TraceScene scene(casters, {}, {});
    const ViewSamples samples =
        traceViewSamples(scene, perspectiveView({0, 2, 3}, {0, 0, 0}, {0, 1, 0}, 0.6, 0.1, 9, 64, 64));
    const SurfaceColours colours = surfaceColours(scene, samples);
    EXPECT_GT(samples.size(), 500u);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Vec3d radial = normalized(toDouble(samples.positionLocal[i]));
        EXPECT_GT(dot(toDouble(colours.shadingNormal[i]), radial), 0.999);
    }
}

TEST(SurfaceColours, SamplesWithoutATriangleHaveTheDefaultMaterial)
{
    const TraceScene scene(triangles(gridPlane(1, 1)), {}, {});
    ViewSamples samples;
    samples.pixel = {{0, 0}}, samples.positionLocal = {{0, 0, 0}}, samples.normal = {{0, 1, 0}},
    samples.triangle = {kNoTriangle};
    const SurfaceColours colours = surfaceColours(scene, samples);
    EXPECT_EQ(colours.baseColour[0], (Vec3f{0.8f, 0.8f, 0.8f}));
    EXPECT_EQ(colours.shadingNormal[0], (Vec3f{0, 1, 0}));
}

} // namespace
} // namespace lixel
