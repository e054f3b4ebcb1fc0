// SPDX-License-Identifier: MIT
#include "graphics.h"
#include "shadow_drawer.h"
#include "warped_plans.h"

#include "lixel/gl/caster_shader.h"
#include "lixel/gl/device/program.h"
#include "lixel/scene/builtin.h"
#include "lixel/scene/evaluate.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>

namespace lixel::test {
namespace {

class LightDepthTest : public GlTest
{
};

TEST_F(LightDepthTest, DrawnAndTracedMapsAgreeButAtEdges)
{
    ShadowDrawer draw(device());
    std::size_t lixels = 0, apart = 0;
    forEachCase(40, [&](Rng& rng) {
        const double half = rng.logUniform(1e-3, 1e4);
        SmallScene scene = rng.chance(0.5) ? anyObjectsOnAFloor(rng, half) : anyTriangleSoup(rng, 60, half);
        const View view = anyViewOf(rng, {}, half, 64, 64);
        const Light light = anyLightOn(rng, {}, half, 0.1, 1e4);
        const LixelSize size{rng.integer(1, 100), rng.integer(1, 100)};
        const FramePlan plan = planFor(scene, view, {&light, 1}, size);
        if (plan.lights[0].refused) return;
        const TracedAtlas drawn = draw.drawAtlas(plan, scene.casters());
        const TracedAtlas traced = traceAtlas(TraceScene(scene.casters()), plan);
        ASSERT_EQ(drawn.size(), traced.size());
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                ++lixels;
                apart += std::abs(double(drawn[0](x, y)) - double(traced[0](x, y))) > 1e-5;
            }
    });
    // A rasterizer moves edges by 1/256 of a lixel.
    std::printf("%zu of %zu lixels apart\n", apart, lixels);
    EXPECT_LT(double(apart), 5e-3 * double(lixels));
}

TEST_F(LightDepthTest, ManyLightsInFewCallsGiveEachTheMapItHasAlone)
{
    ShadowDrawer draw(device());
    Rng rng(7);
    const SmallScene scene = anyTriangleSoup(rng, 100, 1);
    const View view = anyViewOf(rng, {}, 1, 64, 64);
    std::vector<Light> lights;
    while (lights.size() < 32) {
        lights.push_back(anyLightOn(rng, {}, 1));
        if (planFor(scene, view, {&lights.back(), 1}, {40, 30}).lights[0].refused) lights.pop_back();
    }
    const FramePlan together = planFor(scene, view, lights, {40, 30});
    ASSERT_EQ(together.layers, 32);
    const TracedAtlas maps = draw.drawAtlas(together, scene.casters());
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const FramePlan alone = planFor(scene, view, {&lights[i], 1}, {40, 30});
        EXPECT_EQ(draw.drawAtlas(alone, scene.casters())[0].data(), maps[i].data()) << "light " << i;
    }
}

// A host's vertices, 16-bit positions between other things, and its own program. Its grid is a power of two, so that unpacking
// rounds nothing and maps can be equal bit for bit.
class HostRenderer
{
public:
    HostRenderer(const LocalTriangles& triangles, std::string_view keep)
    {
        Box box;
        for (const Vec3f& p : triangles.positionLocal) box.include(toDouble(p));
        const double extent = std::max(length(box.min), length(box.max));
        grid_ = float(std::exp2(std::ceil(std::log2(extent / 32767))));
        for (const std::uint32_t index : triangles.indices) {
            const Vec3f& p = triangles.positionLocal[index];
            const auto packed = [&](float v) { return std::int16_t(std::lround(v / grid_)); };
            vertices_.push_back({{0xdead, 0xbeef}, {packed(p.x), packed(p.y), packed(p.z)}, 0x7777, {0, 0}});
            if (!triangles.uv.empty()) vertices_.back().uv = triangles.uv[index];
        }
        buffer_.assign(std::span<const Vertex>(vertices_));
        const GLuint array = array_.get();
        glVertexArrayVertexBuffer(array, 5, buffer_.name(), 0, sizeof(Vertex));
        for (const GLuint attribute : {9u, 11u}) {
            glEnableVertexArrayAttrib(array, attribute);
            glVertexArrayAttribBinding(array, attribute, 5);
        }
        glVertexArrayAttribFormat(array, 9, 3, GL_SHORT, GL_FALSE, offsetof(Vertex, position));
        glVertexArrayAttribFormat(array, 11, 2, GL_FLOAT, GL_FALSE, offsetof(Vertex, uv));

        const std::string vertexText = "#version 450 core\n" + casterVertexText() +
                                       "layout(location = 9) in vec3 hostPosition;\n"
                                       "layout(location = 11) in vec2 hostUv;\n"
                                       "uniform float hostScale;\n"
                                       "void main() { lixelCaster(hostPosition * hostScale, hostUv); }\n";
        const std::array<gl::ShaderName, 2> shaders{
            gl::compileShader(GL_VERTEX_SHADER, {vertexText, {}}),
            gl::compileShader(GL_FRAGMENT_SHADER, {casterFragmentText(keep), {}})};
        program_ = gl::linkShaders(shaders, "host");
        glProgramUniform1f(program_.get(), glGetUniformLocation(program_.get(), "hostScale"), grid_);
    }

    // What the host's own vertices are, for the built-in way.
    SmallScene unpacked() const
    {
        SmallScene scene;
        for (const Vertex& vertex : vertices_) {
            const auto value = [&](int i) { return float(vertex.position[i]) * grid_; };
            scene.indices.push_back(std::uint32_t(scene.positions.size()));
            scene.positions.push_back({value(0), value(1), value(2)});
        }
        scene.material.assign(scene.indices.size() / 3, 0);
        return scene;
    }

    CasterCallback casters()
    {
        CasterCallback callback;
        callback.draw = [this](std::span<const CasterView> views) {
            ++calls;
            glUseProgram(program_.get());
            glProgramUniform1i(program_.get(), glGetUniformLocation(program_.get(), "lixelFirstView"),
                               GLint(views[0].index));
            glBindVertexArray(array_.get());
            glDrawArraysInstanced(GL_TRIANGLES, 0, GLsizei(vertices_.size()), GLsizei(views.size()));
        };
        return callback;
    }
    int calls = 0;

private:
    struct Vertex
    {
        std::uint16_t before[2];
        std::int16_t position[3];
        std::uint16_t after;
        Vec2f uv;
    };
    float grid_ = 1; // world units a step
    std::vector<Vertex> vertices_;
    gl::Buffer buffer_;
    gl::VertexArray array_ = gl::makeVertexArray();
    gl::ProgramName program_;
};

// As many lights as need two calls; with warps of their vertices, where asked for.
void expectSameMapsBothWays(ShadowDrawer& draw, Rng& rng, const LocalTriangles& triangles, bool isWarped = false)
{
    HostRenderer host(triangles, "");
    const SmallScene same = host.unpacked();
    const Box box = same.boxWorld();
    const View view = anyViewOf(rng, box.centre(), 0.5 * box.diagonal(), 64, 64);
    std::vector<Light> lights;
    for (int i = 0; i < 20; ++i) lights.push_back(anyLightOn(rng, box.centre(), 0.5 * box.diagonal()));
    FramePlan plan = planFor(same, view, lights, {64, 48});
    if (isWarped) warpRegions(plan, rng, WarpRaster::Vertices);
    const TracedAtlas throughBuffers = draw.drawAtlas(plan, same.casters());
    const TracedAtlas throughCallback = draw.drawAtlas(plan, host.casters());
    ASSERT_EQ(throughBuffers.size(), throughCallback.size());
    for (std::size_t i = 0; i < throughBuffers.size(); ++i)
        EXPECT_EQ(throughBuffers[i].data(), throughCallback[i].data()) << "layer " << i;
    EXPECT_EQ(host.calls, (plan.layers + 15) / 16);
}

TEST_F(LightDepthTest, AHostsOwnShaderAndVertexFormatGiveTheMapThatBuffersGive)
{
    ShadowDrawer draw(device());
    forEachCase(10,
                [&](Rng& rng) { expectSameMapsBothWays(draw, rng, flatten(anyObjectsOnAFloor(rng, 1).casters())); });
}

TEST_F(LightDepthTest, AHostsVerticesAreMovedByWarpsAsThoseOfBuffersAre)
{
    ShadowDrawer draw(device());
    forEachCase(
        10, [&](Rng& rng) { expectSameMapsBothWays(draw, rng, flatten(anyObjectsOnAFloor(rng, 1).casters()), true); });
}

TEST_F(LightDepthTest, AHostsCastersAreRefusedByNameWhereMapsAreExactUnderAWarp)
{
    ShadowDrawer draw(device());
    Rng rng(5);
    const SmallScene scene = anyObjectsOnAFloor(rng, 1);
    HostRenderer host(flatten(scene.casters()), "");
    const View view = perspectiveView({0, 2, 2}, {0, 0, 0}, {0, 1, 0}, 1, 0.1, 10, 64, 64);
    const Light sun;
    FramePlan plan = planFor(scene, view, {&sun, 1}, {64, 64});
    plan.lights[0].regions[0].warp = smoothWarp(plan.lights[0].regions[0].rectangle, 16, 2, rng);
    rebuildWarps(plan);
    try {
        draw.drawAtlas(plan, host.casters());
        FAIL() << "they were drawn";
    } catch (const gl::GraphicsError& error) {
        EXPECT_NE(std::string(error.what()).find("raster=vertices"), std::string::npos) << error.what();
    }
}

TEST_F(LightDepthTest, BunniesThroughTheCallbackAreTheBunniesOfTheBuffers)
{
    ShadowDrawer draw(device());
    Rng rng(1);
    const auto bunnies = std::make_shared<const Scene>(buildBuiltin("bunnies(count=2)").value());
    expectSameMapsBothWays(draw, rng, evaluate(bunnies, {}, {}).triangles);
}

TEST_F(LightDepthTest, AHostsHolesAreHoles)
{
    ShadowDrawer draw(device());
    Rng rng(3);
    SmallScene scene;
    scene.addQuad({-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1});
    scene.uv = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
    const LocalTriangles quad = flatten(scene.casters());
    HostRenderer whole(quad, ""), half(quad, "bool lixelKeep(vec2 uv) { return uv.x < 0.5; }");
    const View view = perspectiveView({0, 2, 2}, {0, 0, 0}, {0, 1, 0}, 1, 0.1, 10, 64, 64);
    const Light sun;
    const FramePlan plan = planFor(scene, view, {&sun, 1}, {64, 64});
    const auto drawn = [&](HostRenderer& host) {
        const TracedAtlas maps = draw.drawAtlas(plan, host.casters());
        return double(std::ranges::count_if(maps[0].data(), [](float d) { return d > 0; }));
    };
    EXPECT_NEAR(drawn(half) / drawn(whole), 0.5, 0.03);
}

TEST_F(LightDepthTest, ACasterOutsideOfTheVolumeGivenToTheHostDarkensNothing)
{
    forEachCase(kCases, [&](Rng& rng) {
        const SmallScene scene = anyObjectsOnAFloor(rng, 1);
        const View view = anyViewOf(rng, {}, 1, 64, 64);
        const Light light = anyLightOn(rng, {}, 1);
        const FramePlan plan = planFor(scene, view, {&light, 1}, {64, 64});
        if (plan.lights[0].refused) return;
        const LightImage image(plan.lights[0].regions[0].lightClipFromLocal, plan.lights[0].regions[0].rectangle);
        const std::vector<Plane> volume = gl::casterVolume(plan.lights[0].regions[0].lightClipFromLocal);
        EXPECT_GE(volume.size(), 4u);
        for (int i = 0; i < 20; ++i) {
            const Vec3d pointLocal = rng.inBox(3);
            const std::optional<Vec3d> lixel = image.lixelAt(pointLocal);
            if (!lixel || lixel->z > 1) continue;
            for (const Plane& plane : volume) EXPECT_GE(plane.signedDistance(pointLocal), -1e-9);
        }
    });
}

// Both ways of drawing, and the shares of triangles that culling left out.
struct CullingComparison
{
    explicit CullingComparison(gl::Device& device) : culled(device), whole(device, gl::LightDepthPass::Culling::Off) {}

    void expectSameMaps(const FramePlan& plan, const CasterBuffers& casters)
    {
        const TracedAtlas a = culled.drawAtlas(plan, casters), b = whole.drawAtlas(plan, casters);
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].data(), b[i].data()) << "layer " << i;
        EXPECT_EQ(whole.depthPass.trianglesCulled(), 0u);
        EXPECT_EQ(culled.depthPass.trianglesDrawn() + culled.depthPass.trianglesCulled(),
                  whole.depthPass.trianglesDrawn());
        all += whole.depthPass.trianglesDrawn();
        left += culled.depthPass.trianglesCulled();
    }

    ShadowDrawer culled, whole;
    std::uint64_t all = 0, left = 0;
};

TEST_F(LightDepthTest, CastersCulledPerRegionLeaveEveryLixelAsItWas)
{
    CullingComparison comparison(device());
    forEachCase(kCases, [&](Rng& rng) {
        const double half = rng.logUniform(1e-3, 1e4);
        SmallScene scene = rng.chance(0.5) ? anyObjectsOnAFloor(rng, half) : anyTriangleSoup(rng, 600, half);
        scene.originWorld = rng.chance(0.3) ? 1e5 * rng.onSphere() : Vec3d{};
        const View view = anyViewOf(rng, scene.originWorld, half, 64, 64);
        const Light light = anyLightOn(rng, scene.originWorld, half, 0.1, 1e5);
        const std::optional<FramePlan> plan =
            planOfQuarters(scene.boxWorld(), view, light, scene.originWorld, {rng.integer(1, 90), rng.integer(1, 90)});
        if (plan) comparison.expectSameMaps(*plan, scene.casters());
    });
    std::printf("%llu of %llu triangles left out\n", static_cast<unsigned long long>(comparison.left),
                static_cast<unsigned long long>(comparison.all));
    EXPECT_GT(comparison.left, comparison.all / 20);
}

TEST_F(LightDepthTest, CullingLeavesTheMapsOfAWholeSceneAsTheyWere)
{
    for (const char* name : {"objects", "city", "fence"}) {
        const auto scene = std::make_shared<const Scene>(buildBuiltin(name).value());
        CullingComparison comparison(device());
        Rng rng(4);
        const SceneBuffers buffers = evaluate(scene, {}, {});
        const Box box = buffers.bounds.total();
        std::optional<FramePlan> plan;
        while (!plan) {
            const View view = anyViewOf(rng, box.centre(), 0.3 * box.diagonal(), 64, 64);
            const Light light = anyLightOn(rng, box.centre(), 0.5 * box.diagonal());
            plan = planOfQuarters(box, view, light, {}, {256, 256});
        }
        comparison.expectSameMaps(*plan, buffers.casters());
        EXPECT_GT(comparison.left, 0u) << name;
    }
}

// A batch takes as many regions as there are viewports; a region beyond 32 is still drawn.
TEST_F(LightDepthTest, InstancesFindTheirRegionInEveryBatch)
{
    CullingComparison comparison(device());
    Rng rng(12);
    const SmallScene scene = anyTriangleSoup(rng, 500, 1);
    const View view = anyViewOf(rng, {}, 1, 64, 64);
    std::vector<Light> lights;
    for (int i = 0; i < 40; ++i) lights.push_back(anyLightOn(rng, {}, 1));
    comparison.expectSameMaps(planFor(scene, view, lights, {24, 24}), scene.casters());
}

} // namespace
} // namespace lixel::test
