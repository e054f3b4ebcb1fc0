// SPDX-License-Identifier: MIT
#include "lixel/gl/caster_shader.h"

#include "lixel/gl/device/shader_source.h"

namespace lixel {
namespace {

// Without the #version line, which is the host's or comes before its text.
std::string behindVersion(const std::string& text) { return text.substr(text.find('\n') + 1); }

} // namespace

std::string casterVertexText()
{
    return behindVersion(gl::assembleShader("lixel/gl/shaders/lixel_caster.glsl", {}).text) + "#line 1\n";
}

std::string casterFragmentText(std::string_view keep)
{
    const std::string stage = behindVersion(gl::assembleShader("lixel/gl/shaders/host_caster.frag.glsl", {}).text);
    if (keep.empty()) return "#version 450 core\n" + stage;
    return "#version 450 core\n#define LIXEL_KEEP\n#line 1\n" + std::string(keep) + "\n" + stage;
}

} // namespace lixel
