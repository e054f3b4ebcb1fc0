// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/vec.h"

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

// OpenEXR, 32-bit floats, compressed without loss. Row 0 is the bottom here and the top in the file.
namespace lixel {

// Names as other programs group them into layers: position.X .Y .Z, normal.X .Y .Z, depth.Z, receiver.A, visibility.V
// (or visibility.LIGHT.V), exact.V, footprint.S, density.S.
struct ExrChannel
{
    std::string name;
    std::span<const float> values; // width * height
};

// Points are stored relative to `originWorld`, which stands in the file as the V3d attribute of that name.
// Written atomically; throws OutputError.
void writeExr(const std::filesystem::path& path, int width, int height, std::span<const ExrChannel> channels,
              Vec3d originWorld);

struct ExrPicture
{
    int width = 0, height = 0;
    Vec3d originWorld;
    std::map<std::string, std::vector<float>> channels;
};

// Throws std::runtime_error when it is no such file.
ExrPicture readExr(const std::filesystem::path& path);

} // namespace lixel
