// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// 8 bits a channel, RGB, row 0 at the bottom as OpenGL reads it.
struct Picture
{
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
};

// Throws std::runtime_error.
void writePng(const std::string& path, const Picture& picture);

// The share of pixels of which some channel differs by more than `most`.
double shareDiffering(const Picture& a, const Picture& b, int most);
