// SPDX-License-Identifier: MIT
#include "shaders.h"

#include <epoxy/gl.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace {

std::string textOf(const std::string& path)
{
    std::ifstream file(path);
    if (!file) throw std::runtime_error(path + ": cannot be read");
    return {std::istreambuf_iterator<char>(file), {}};
}

GLuint compiled(GLenum stage, const std::string& text)
{
    const GLuint shader = glCreateShader(stage);
    const char* begin = text.c_str();
    glShaderSource(shader, 1, &begin, nullptr);
    glCompileShader(shader);
    GLint isGood = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &isGood);
    if (isGood) return shader;
    std::string log(4096, '\0');
    glGetShaderInfoLog(shader, GLsizei(log.size()), nullptr, log.data());
    throw std::runtime_error("a shader does not compile: " + log);
}

} // namespace

std::string hostShader(const std::string& name) { return textOf(std::string(HOST_FOLDER "/shaders/") + name); }

std::string lixelShader(const std::string& name) { return textOf(std::string(LIXEL_GLSL_FOLDER "/") + name); }

unsigned makeProgram(const std::string& vertexText, const std::string& fragmentText)
{
    const GLuint program = glCreateProgram();
    for (const GLuint shader : {compiled(GL_VERTEX_SHADER, vertexText), compiled(GL_FRAGMENT_SHADER, fragmentText)}) {
        glAttachShader(program, shader);
        glDeleteShader(shader); // goes with the program
    }
    glLinkProgram(program);
    GLint isGood = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &isGood);
    if (isGood) return program;
    std::string log(4096, '\0');
    glGetProgramInfoLog(program, GLsizei(log.size()), nullptr, log.data());
    throw std::runtime_error("a program does not link: " + log);
}
