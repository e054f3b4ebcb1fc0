// SPDX-License-Identifier: MIT
#include "graphics.h"
#include "small_scenes.h"

#include "lixel/gl/device/program.h"
#include "lixel/gl/passes/surfaces.h"
#include "lixel/shared/gl_slots.h"
#include "lixel/trace/texture_lookup.h"

#include <epoxy/gl.h>

#include <array>
#include <cmath>
#include <vector>

namespace lixel::test {
namespace {

using namespace gl;

class AlphaTest : public GlTest
{
protected:
    // surfaceTextureAlpha() of alpha.glsl at many places.
    AlphaTest()
    {
        if (!graphics()) return;
        const std::string text = "#include \"lixel/gl/shaders/alpha.glsl\"\n"
                                 "layout(local_size_x = 64) in;\n"
                                 "layout(std430, binding = 0) readonly buffer In { vec2 uv[]; };\n"
                                 "layout(std430, binding = 1) writeonly buffer Out { float alpha[]; };\n"
                                 "void main() { uint i = gl_GlobalInvocationID.x;\n"
                                 "  if (i < uv.length()) alpha[i] = surfaceTextureAlpha(uv[i]); }\n";
        const ReadShaderFile read = [&](std::string_view path) {
            return path == "test.glsl" ? std::optional<std::string_view>(text) : readEmbeddedShader(path);
        };
        std::array<ShaderName, 1> shaders{compileShader(GL_COMPUTE_SHADER, assembleShader("test.glsl", {}, read))};
        program_ = linkShaders(shaders, "test");
    }

    std::vector<float> alphaOnDevice(const lixel::Texture& texture, const std::vector<Vec2f>& uv)
    {
        SmallScene scene;
        scene.addQuad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
        scene.textures.push_back(texture);
        scene.materials.push_back({});
        scene.materials[0].texture = 0;
        Surfaces surfaces(device());
        surfaces.update(scene.casters());
        const Surfaces::Wraps wraps = surfaces.bindTexture(surfaces.ranges()[0]);
        glProgramUniform2i(program_.get(), 8, wraps.u, wraps.v);
        Buffer in, out;
        in.assign(std::span<const Vec2f>(uv));
        out.reserve(uv.size() * sizeof(float));
        in.bindStorage(0);
        out.bindStorage(1);
        glUseProgram(program_.get());
        glDispatchCompute(GLuint((uv.size() + 63) / 64), 1, 1);
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        std::vector<float> alpha(uv.size());
        out.read(0, std::span<float>(alpha));
        return alpha;
    }

private:
    ProgramName program_;
};

TEST_F(AlphaTest, TheShadersAlphaIsThatOfRays)
{
    forEachCase(kCases, [&](Rng& rng) {
        const lixel::Texture texture = anyTexture(rng, rng.integer(1, 70));
        std::vector<Vec2f> uv;
        for (int i = 0; i < 300; ++i) {
            const double size = rng.logUniform(0.1, 1e4);
            uv.push_back({float(rng.uniform(-size, size)), float(rng.uniform(-size, size))});
            if (rng.chance(0.2)) uv.back().x = float(rng.integer(-4, 4)); // on the seams
            if (rng.chance(0.2)) uv.back().y = float(rng.integer(-8, 8)) / 2;
        }
        const std::vector<float> alpha = alphaOnDevice(texture, uv);
        for (std::size_t i = 0; i < uv.size(); ++i)
            EXPECT_NEAR(alpha[i], alphaOf(texture, uv[i]), 1e-6) << uv[i].x << ", " << uv[i].y;
    });
}

} // namespace
} // namespace lixel::test
