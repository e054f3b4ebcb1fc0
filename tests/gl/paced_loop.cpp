// SPDX-License-Identifier: MIT
#include "paced_loop.h"

#include "lixel/gl/device/draw_state.h"
#include "lixel/gl/device/program.h"

#include <epoxy/gl.h>

#include <array>
#include <cstdint>

namespace lixel::test {

using namespace gl;

void runPaced(int frames, const std::function<void(int frame)>& drawFrame)
{
    std::array<GLsync, 2> ends{};
    for (int frame = 0; frame < frames; ++frame) {
        GLsync& end = ends[std::size_t(frame) % ends.size()];
        if (end) {
            glClientWaitSync(end, GL_SYNC_FLUSH_COMMANDS_BIT, ~std::uint64_t(0));
            glDeleteSync(end);
        }
        drawFrame(frame);
        end = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
        glFlush(); // the image is shown
    }
    for (const GLsync end : ends)
        if (end) glDeleteSync(end);
}

DeviceDelay::DeviceDelay() : target_(GL_R32F, 64, 64), nothing_(makeVertexArray())
{
    const std::array<const Texture*, 1> colours{&target_};
    framebuffer_ = Framebuffer(colours, nullptr);
    const std::string vertex =
        "#version 450 core\n"
        "void main() { gl_Position = vec4(gl_VertexID % 2 * 4 - 1, gl_VertexID / 2 * 4 - 1, 0, 1); }\n";
    const std::string fragment = "#version 450 core\n"
                                 "layout(location = 0) uniform int rounds;\n"
                                 "layout(location = 0) out float result;\n"
                                 "void main() { float x = gl_FragCoord.x;\n"
                                 "  for (int i = 0; i < rounds; ++i) x = fract(sin(x) * 43758.5);\n"
                                 "  result = x; }\n";
    const std::array<ShaderName, 2> shaders{compileShader(GL_VERTEX_SHADER, {vertex, {}}),
                                            compileShader(GL_FRAGMENT_SHADER, {fragment, {}})};
    program_ = linkShaders(shaders, "delay");
}

void DeviceDelay::queue(int rounds) const
{
    apply(DrawState{});
    glDisable(GL_DEPTH_TEST);
    framebuffer_.bind();
    glViewport(0, 0, target_.width(), target_.height());
    glBindVertexArray(nothing_.get());
    glUseProgram(program_.get());
    glUniform1i(0, rounds);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace lixel::test
