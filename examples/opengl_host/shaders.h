// SPDX-License-Identifier: MIT
#pragma once

#include <string>

// The text of a file: of this example's shaders/, or of lixel's installed GLSL. Throws std::runtime_error.
std::string hostShader(const std::string& name);
std::string lixelShader(const std::string& name);

// Compiles and links; throws std::runtime_error with the driver's log.
unsigned makeProgram(const std::string& vertexText, const std::string& fragmentText);
