// SPDX-License-Identifier: MIT
#include "lixel/scene/evaluate.h"
#include "lixel/scene/framing.h"
#include "lixel/scene/load.h"
#include "lixel/shared/alpha.h"
#include "lixel/trace/exact_visibility.h"
#include "lixel/trace/texture_lookup.h"
#include "lixel/trace/trace_view_samples.h"

#include "support/random_cases.h"
#include "support/scene_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace lixel {
namespace {

using test::Rng;

Texture anyTexture(Rng& rng, Wrap wrapU, Wrap wrapV)
{
    Texture texture;
    texture.pixels = Image<Rgba8>(rng.integer(1, 9), rng.integer(1, 9));
    for (Rgba8& texel : texture.pixels.data())
        texel = {std::uint8_t(rng.integer(0, 255)), std::uint8_t(rng.integer(0, 255)),
                 std::uint8_t(rng.integer(0, 255)), std::uint8_t(rng.integer(0, 255))};
    texture.wrapU = wrapU, texture.wrapV = wrapV;
    return texture;
}

Wrap anyWrap(Rng& rng) { return Wrap(rng.integer(0, 2)); }

// The texel index that OpenGL 4.5 (table 8.20) gives for any index.
int wrapped(int i, int size, Wrap wrap)
{
    const auto modulo = [](int a, int n) { return ((a % n) + n) % n; };
    if (wrap == Wrap::Repeat) return modulo(i, size);
    if (wrap == Wrap::ClampToEdge) return std::clamp(i, 0, size - 1);
    const int m = modulo(i, 2 * size);
    return m < size ? m : 2 * size - 1 - m;
}

double alphaByTheTable(const Texture& texture, double u, double v)
{
    const int width = texture.pixels.width(), height = texture.pixels.height();
    const double x = u * width - 0.5, y = v * height - 0.5;
    const int i = int(std::floor(x)), j = int(std::floor(y));
    const double a = x - i, b = y - j;
    const auto texel = [&](int di, int dj) {
        return texture.pixels(wrapped(i + di, width, texture.wrapU), wrapped(j + dj, height, texture.wrapV)).a / 255.0;
    };
    return (1 - b) * ((1 - a) * texel(0, 0) + a * texel(1, 0)) + b * ((1 - a) * texel(0, 1) + a * texel(1, 1));
}

TEST(Alpha, AtATexelsCentreIsTheTexel)
{
    test::forEachCase(test::kCases, [](Rng& rng) {
        const Texture texture = anyTexture(rng, anyWrap(rng), anyWrap(rng));
        const int x = rng.integer(0, texture.pixels.width() - 1), y = rng.integer(0, texture.pixels.height() - 1);
        const Vec2f centre{(float(x) + 0.5f) / float(texture.pixels.width()),
                           (float(y) + 0.5f) / float(texture.pixels.height())};
        EXPECT_NEAR(alphaOf(texture, centre), texture.pixels(x, y).a / 255.0, 2e-6);
    });
}

TEST(Alpha, HalfwayBetweenTexelsIsTheirMean)
{
    Texture texture;
    texture.pixels = Image<Rgba8>(2, 1);
    texture.pixels(0, 0).a = 10, texture.pixels(1, 0).a = 110;
    EXPECT_FLOAT_EQ(alphaOf(texture, {0.5f, 0.5f}), 60.0f / 255.0f);
    texture.wrapU = Wrap::Repeat; // across the seam
    EXPECT_FLOAT_EQ(alphaOf(texture, {0.0f, 0.5f}), 60.0f / 255.0f);
    texture.wrapU = Wrap::ClampToEdge;
    EXPECT_FLOAT_EQ(alphaOf(texture, {0.0f, 0.5f}), 10.0f / 255.0f);
    texture.wrapU = Wrap::MirroredRepeat;
    EXPECT_FLOAT_EQ(alphaOf(texture, {0.0f, 0.5f}), 10.0f / 255.0f);
    EXPECT_FLOAT_EQ(alphaOf(texture, {1.25f, 0.5f}), 110.0f / 255.0f);
}

TEST(Alpha, FoldingTheCoordinateFirstGivesWhatOpenGLsWrapTableGives)
{
    test::forEachCase(test::kCases, [](Rng& rng) {
        const Texture texture = anyTexture(rng, anyWrap(rng), anyWrap(rng));
        const auto u = float(rng.uniform(-5, 5)), v = float(rng.uniform(-5, 5));
        EXPECT_NEAR(alphaOf(texture, {u, v}), alphaByTheTable(texture, u, v), 3e-5); // float steps at 5 times 9 texels
    });
}

TEST(Alpha, CoordinatesOfAnySizeStayInTheImage)
{
    test::forEachCase(test::kCases, [](Rng& rng) {
        const Texture texture = anyTexture(rng, anyWrap(rng), anyWrap(rng));
        const float infinity = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
        const auto size = float(rng.logUniform(1, 3e38));
        for (const float u : {size, -size, infinity, -infinity, nan, 1.0f, 0.0f, -0.0f, 0.99999994f, -1e-30f, 2.0f}) {
            const float alpha = alphaOf(texture, {u, u});
            EXPECT_TRUE(alpha >= 0 && alpha <= 1.000001f) << u;
        }
    });
}

TEST(Alpha, AMaskedTriangleStopsRaysExactlyWhereItsAlphaReachesTheCutoff)
{
    test::forEachCase(test::kCases, [](Rng& rng) {
        // A masked square at height 1 over a floor, uv 0..1 along x and z, light from straight above.
        const Texture texture = anyTexture(rng, Wrap::ClampToEdge, Wrap::ClampToEdge);
        LocalTriangles casters;
        for (const float y : {0.0f, 1.0f}) {
            for (const Vec2f corner : {Vec2f{0, 0}, Vec2f{1, 0}, Vec2f{1, 1}, Vec2f{0, 1}}) {
                casters.positionLocal.push_back({corner.x, y, corner.y});
                casters.uv.push_back(corner);
                casters.colour.push_back({1, 1, 1, 0.9f});
            }
        }
        casters.indices = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
        casters.material = {0, 0, 1, 1};
        Material mask;
        mask.alphaMode = AlphaMode::Mask, mask.texture = 0, mask.alphaCutoff = float(rng.uniform(0.1, 0.8));
        mask.baseColour.w = 0.8f;
        const TraceScene scene(casters, std::vector<Material>{Material{}, mask}, std::span(&texture, 1));
        for (int i = 0; i < 20; ++i) {
            const auto x = float(rng.uniform(0.01, 0.99)), z = float(rng.uniform(0.01, 0.99));
            ViewSamples samples;
            samples.pixel = {{0, 0}}, samples.positionLocal = {{x, 0, z}}, samples.normal = {{0, 1, 0}};
            samples.triangle = {z > x ? 1u : 0u};
            const double alpha = 0.8 * 0.9 * alphaByTheTable(texture, x, z);
            if (std::abs(alpha - double(mask.alphaCutoff)) < 1e-5) continue;
            EXPECT_EQ(exactVisibility(scene, samples, Light{})[0], alpha >= double(mask.alphaCutoff) ? 0 : 1);
        }
    });
}

// Blended surfaces of a file with alpha 0.3 and 0.6.
TEST(Alpha, ABlendedSurfaceIsDrawnFromHalfOpaqueOn)
{
    const auto blended = std::make_shared<const Scene>(loadScene((test::dataFolder() / "blend.glb").string()));
    const SceneBuffers buffers = evaluate(blended, {}, {});
    const TraceScene scene(buffers.casters());
    Camera camera;
    camera.eyeWorld = {1.5, 0.5, 4}, camera.targetWorld = {1.5, 0.5, 0};
    const ViewSamples samples = traceViewSamples(scene, makeView(camera, 64, 64, sceneBounds(*blended, {})));
    EXPECT_GT(samples.size(), 20u);
    for (const Vec3f& p : samples.positionLocal) EXPECT_GE(p.x, 2) << "the thinner one ends at 1";
}

TEST(Alpha, AnOpaqueMaterialKeepsEverythingWhateverItsTexture)
{
    Texture texture;
    texture.pixels = Image<Rgba8>(1, 1, {255, 255, 255, 0});
    LocalTriangles casters;
    casters.positionLocal = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    casters.uv = {{0, 0}, {1, 0}, {0, 1}};
    casters.indices = {0, 1, 2};
    casters.material = {0};
    Material opaque;
    opaque.texture = 0;
    const TraceScene scene(casters, std::span(&opaque, 1), std::span(&texture, 1));
    EXPECT_TRUE(scene.keeps(0, 0.2f, 0.2f));
}

TEST(SrgbDecoding, MeetsItsFixedPointsAndRises)
{
    EXPECT_EQ(linearFromSrgb(0), 0);
    EXPECT_EQ(linearFromSrgb(255), 1);
    EXPECT_NEAR(linearFromSrgb(188), 0.5029, 1e-4);
    for (int code = 1; code < 256; ++code)
        EXPECT_GT(linearFromSrgb(std::uint8_t(code)), linearFromSrgb(std::uint8_t(code - 1)));
}

} // namespace
} // namespace lixel
