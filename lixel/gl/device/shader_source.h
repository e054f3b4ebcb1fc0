// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/gl/graphics_error.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// GLSL text put together by us: OpenGL knows no #include, and a driver's log knows no files.
namespace lixel::gl {

// A shader that does not compile or link: the driver's log with our file and line ("file:line: message").
class ShaderError : public GraphicsError
{
public:
    using GraphicsError::GraphicsError;
};

struct ShaderSource
{
    std::string text;
    std::vector<std::string> files; // number n in `text` (#line ... n) is files[n]
};

// The text of a file by its path from the root of the sources ("lixel/gl/shaders/..."), nothing where there is none.
using ReadShaderFile = std::function<std::optional<std::string_view>(std::string_view path)>;

// Files compiled into this library: lixel/gl/shaders/*.glsl and lixel/shared/*.h.
std::optional<std::string_view> readEmbeddedShader(std::string_view path);

// The file with each `#include "path"` replaced by that file, behind `#version 450 core` and one `#define` an entry of
// `defines` ("NAME" or "NAME value"). Every file counts once, as if it had `#pragma once`; that line and `#include <...>`
// belong to C++ and are left out. Throws ShaderError at a file that is not there.
ShaderSource assembleShader(const std::string& path, std::span<const std::string> defines,
                            const ReadShaderFile& read = readEmbeddedShader);

// The driver's log with "<number>:<line>", "<number>(<line>)" and the like turned into "<file>:<line>", as far as they name
// a file of `source`.
std::string translateLog(const std::string& log, const ShaderSource& source);

} // namespace lixel::gl
