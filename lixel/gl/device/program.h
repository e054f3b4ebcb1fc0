// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/gl/device/objects.h"
#include "lixel/gl/device/shader_source.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace lixel::gl {

// A linked program from our embedded shaders; its uniforms have explicit locations. Throws ShaderError.
class Program
{
public:
    struct Files
    {
        std::string vertex, fragment;              // of lixel/gl/shaders, by name ("scene.vert.glsl")
        std::string control = {}, evaluation = {}; // of tessellation, both or none
    };

    Program() = default;
    static Program graphics(const Files& files, std::span<const std::string> defines = {});
    static Program compute(const std::string& file, std::span<const std::string> defines = {});

    void use() const;
    std::uint32_t name() const { return name_.get(); }

    void set(int location, int value) const;
    void set(int location, std::uint32_t value) const;
    void set(int location, float value) const;
    void set(int location, int x, int y) const;

private:
    explicit Program(ProgramName name) : name_(std::move(name)) {}
    ProgramName name_;
};

// The programs of one compute shader by their defines, each made when it is first asked for.
class ProgramSet
{
public:
    explicit ProgramSet(std::string file) : file_(std::move(file)) {}
    const Program& with(const std::vector<std::string>& defines);

private:
    std::string file_;
    std::map<std::vector<std::string>, Program> programs_;
};

// One stage compiled; `stage` is OpenGL's enumerant. Also what compiles a host's text, whose log is mapped likewise.
ShaderName compileShader(std::uint32_t stage, const ShaderSource& source);
ProgramName linkShaders(std::span<const ShaderName> shaders, const std::string& what);

} // namespace lixel::gl
