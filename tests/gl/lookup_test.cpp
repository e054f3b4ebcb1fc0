// SPDX-License-Identifier: MIT
#include "graphics.h"
#include "shadow_drawer.h"
#include "warped_plans.h"

#include "lixel/trace/trace_view_samples.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
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

// Of a texel, as the driver has it; 0 of no texture.
int bytesOf(const gl::Texture& texture)
{
    if (!texture.name()) return 0;
    int bits = 0;
    for (const GLenum size : {GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE, GL_TEXTURE_ALPHA_SIZE,
                              GL_TEXTURE_DEPTH_SIZE, GL_TEXTURE_STENCIL_SIZE}) {
        GLint one = 0;
        glGetTextureLevelParameteriv(texture.name(), 0, size, &one);
        bits += one;
    }
    return bits / 8;
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
                              "depths(8,q=25)+pcf(9)+dual-plane",
                              "depths(2,min,q=25)+pcf(16,rotated)",
                              "depths(3)+bilinear",
                              "depths(4)+pcf(25,jittered)",
                              "depths(4,bits=16)+dual-plane",
                              "fast-pcf+pcf(9)"};

constexpr std::array kMoments{"vsm", "evsm2", "evsm4(5)", "msm", "vsm(1)", "msm(5)"};

// What two ways of looking up say, over many maps.
class Comparison
{
public:
    explicit Comparison(gl::Device& device) : draw_(device) {}

    // Of any lights, samples and maps; the maps are noise, as hard for a lookup as can be, or what the light sees.
    void add(Rng& rng, const std::string& lookup, bool isWarped, bool isNoise)
    {
        const SmallScene scene = anyObjectsOnAFloor(rng, 1);
        const View view = anyViewOf(rng, {}, 1, 64, 64);
        std::vector<Light> lights;
        for (int i = rng.integer(1, 4); i > 0; --i) lights.push_back(anyLightOn(rng, {}, 1));
        const auto technique = std::get<MapTechnique>(*parseTechnique(lookup));
        FramePlan plan = planFor(scene, view, lights, {rng.integer(8, 60), rng.integer(8, 60)}, technique);
        if (isWarped) warpRegions(plan, rng, WarpRaster::Exact, int(std::ceil(plan.lookup.reach)));
        TracedAtlas maps = traceAtlas(TraceScene(scene.casters()), plan);
        for (Image<float>& map : maps)
            for (float& depth : map.data())
                if (isNoise) depth = rng.chance(0.2) ? 0.0f : float(rng.uniform(0, 1));
        draw_.writeAtlas(plan, maps);
        const PreparedMaps prepared = prepareMaps(plan, maps);
        const ViewSamples samples = anySamples(rng, rng.integer(0, 2000), 1.2);
        const std::vector<Visibility> shader = draw_.lookUp(plan, samples);
        for (std::size_t light = 0; light < lights.size(); ++light)
            add(lookup, shader[light], lookUp(plan, maps, prepared, samples, light));
    }

    void add(const std::string& lookup, const Visibility& shader, const Visibility& cpp)
    {
        // A texture unit has fewer digits of the areas; exponentials are a few units in the last place apart, and bounds by moments are
        // quotients of small differences.
        double most = 1e-6;
        if (lookup == "hardware-pcf") most = 1.0 / 128;
        if (lookup.find("sm") != std::string::npos) most = 2e-3;
        for (std::size_t i = 0; i < cpp.value.size(); ++i) {
            ++all;
            unserved += cpp.unserved[i];
            partial += cpp.value[i] > 0.02f && cpp.value[i] < 0.98f;
            const double off = std::abs(shader.value[i] - cpp.value[i]);
            const bool isDiffering = shader.unserved[i] != cpp.unserved[i] || off > most;
            differing += isDiffering;
            differingBy_[lookup] += isDiffering;
        }
    }

    void print() const
    {
        std::printf("%zu of %zu differ, %zu unserved, %zu partial\n", differing, all, unserved, partial);
        for (const auto& [lookup, count] : differingBy_)
            if (count > 0) std::printf("  %zu by %s\n", count, lookup.c_str());
    }

    std::size_t all = 0, differing = 0, unserved = 0, partial = 0;

private:
    ShadowDrawer draw_;
    std::map<std::string, std::size_t> differingBy_;
};

template <std::size_t N>
std::string anyOf(const std::array<const char*, N>& lookups, Rng& rng)
{
    return lookups[std::size_t(rng.integer(0, int(N) - 1))];
}

TEST_F(LookupTest, ShaderAndCppAgreeOnAnyMap)
{
    Comparison comparison(device());
    forEachCase(200, [&](Rng& rng) { comparison.add(rng, anyOf(kLookups, rng), false, true); });
    comparison.print();
    EXPECT_LT(double(comparison.differing), 1e-4 * double(comparison.all));
    EXPECT_GT(comparison.unserved, 0u);
}

TEST_F(LookupTest, ShaderAndCppAgreeOnAnyWarpedMap)
{
    Comparison comparison(device());
    forEachCase(100, [&](Rng& rng) { comparison.add(rng, anyOf(kLookups, rng), true, true); });
    comparison.print();
    EXPECT_LT(double(comparison.differing), 1e-4 * double(comparison.all));
}

TEST_F(LookupTest, ShaderAndCppMakeTheSameBoundsOfMomentsOfAnyMap)
{
    Comparison comparison(device());
    forEachCase(200, [&](Rng& rng) { comparison.add(rng, anyOf(kMoments, rng), rng.chance(0.5), rng.chance(0.5)); });
    comparison.print();
    EXPECT_LT(double(comparison.differing), 1e-4 * double(comparison.all));
    EXPECT_GT(comparison.partial, comparison.all / 20);
}

// What the plan says of bytes is what the driver has made room for.
TEST_F(LookupTest, BytesAreThoseOfTheTextures)
{
    Rng rng(1);
    const SmallScene scene = anyObjectsOnAFloor(rng, 1);
    const View view = anyViewOf(rng, {}, 1, 64, 64);
    const Light light = anyLightOn(rng, {}, 1);
    for (const char* lookup : {"pcf(1)", "pcf(25)", "hardware-pcf", "dual-plane", "fast-pcf", "depths(2)", "depths(3)",
                               "depths(4)", "depths(4,bits=16)", "depths(5)", "depths(6)+dual-plane", "depths(7)",
                               "depths(8)", "vsm", "evsm2", "evsm4", "msm"}) {
        const auto technique = std::get<MapTechnique>(*parseTechnique(lookup));
        const FramePlan plan = planFor(scene, view, {&light, 1}, {16, 16}, technique);
        gl::ShadowAtlas atlas;
        gl::PreparedMaps prepared;
        atlas.resize(device(), plan);
        prepared.resize(plan);
        const int read = bytesOf(prepared.words) + bytesOf(prepared.moreWords) + bytesOf(prepared.moments);
        const int gradients = bytesOf(prepared.gradients), map = bytesOf(atlas.depth);
        EXPECT_EQ(plan.lookup.bytesPerLixel, map + read + gradients + bytesOf(prepared.across)) << lookup;
        EXPECT_EQ(plan.lookup.bytesReadPerLixel, (read > 0 ? read : map) + gradients) << lookup;
    }
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
