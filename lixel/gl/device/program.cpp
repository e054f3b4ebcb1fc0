// SPDX-License-Identifier: MIT
#include "lixel/gl/device/program.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <array>
#include <vector>

namespace lixel::gl {
namespace {

const std::string kFolder = "lixel/gl/shaders/";

std::string withoutLastNewline(std::string text)
{
    while (!text.empty() && (text.back() == '\n' || text.back() == '\0')) text.pop_back();
    return text;
}

} // namespace

ShaderName compileShader(std::uint32_t stage, const ShaderSource& source)
{
    ShaderName shader(glCreateShader(stage));
    const GLchar* text = source.text.c_str();
    glShaderSource(shader.get(), 1, &text, nullptr);
    glCompileShader(shader.get());
    GLint isCompiled = 0, length = 0;
    glGetShaderiv(shader.get(), GL_COMPILE_STATUS, &isCompiled);
    if (isCompiled) return shader;
    glGetShaderiv(shader.get(), GL_INFO_LOG_LENGTH, &length);
    std::string log(std::size_t(length) + 1, '\0');
    glGetShaderInfoLog(shader.get(), GLsizei(log.size()), nullptr, log.data());
    throw ShaderError(translateLog(withoutLastNewline(log), source));
}

ProgramName linkShaders(std::span<const ShaderName> shaders, const std::string& what)
{
    ProgramName program(glCreateProgram());
    for (const ShaderName& shader : shaders) glAttachShader(program.get(), shader.get());
    glLinkProgram(program.get());
    for (const ShaderName& shader : shaders) glDetachShader(program.get(), shader.get());
    GLint isLinked = 0, length = 0;
    glGetProgramiv(program.get(), GL_LINK_STATUS, &isLinked);
    if (isLinked) return program;
    glGetProgramiv(program.get(), GL_INFO_LOG_LENGTH, &length);
    std::string log(std::size_t(length) + 1, '\0');
    glGetProgramInfoLog(program.get(), GLsizei(log.size()), nullptr, log.data());
    throw ShaderError(fmt::format("{}: {}", what, withoutLastNewline(log)));
}

Program Program::graphics(const Files& files, std::span<const std::string> defines)
{
    std::vector<ShaderName> shaders;
    const auto add = [&](std::uint32_t stage, const std::string& file) {
        if (!file.empty()) shaders.push_back(compileShader(stage, assembleShader(kFolder + file, defines)));
    };
    add(GL_VERTEX_SHADER, files.vertex);
    add(GL_TESS_CONTROL_SHADER, files.control);
    add(GL_TESS_EVALUATION_SHADER, files.evaluation);
    add(GL_FRAGMENT_SHADER, files.fragment);
    return Program(linkShaders(shaders, files.vertex + " and " + files.fragment));
}

Program Program::compute(const std::string& file, std::span<const std::string> defines)
{
    std::array<ShaderName, 1> shaders{compileShader(GL_COMPUTE_SHADER, assembleShader(kFolder + file, defines))};
    return Program(linkShaders(shaders, file));
}

const Program& ProgramSet::with(const std::vector<std::string>& defines)
{
    const auto found = programs_.find(defines);
    if (found != programs_.end()) return found->second;
    return programs_.emplace(defines, Program::compute(file_, defines)).first->second;
}

void Program::use() const { glUseProgram(name()); }
void Program::set(int location, int value) const { glProgramUniform1i(name(), location, value); }
void Program::set(int location, std::uint32_t value) const { glProgramUniform1ui(name(), location, value); }
void Program::set(int location, float value) const { glProgramUniform1f(name(), location, value); }
void Program::set(int location, int x, int y) const { glProgramUniform2i(name(), location, x, y); }

} // namespace lixel::gl
