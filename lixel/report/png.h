// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/image.h"
#include "lixel/base/surfaces.h"

#include <filesystem>
#include <string>
#include <string_view>

// PNG, 8 bits a channel. Row 0 of an Image is the bottom, of a file the top: both ways turn it.
namespace lixel {

// The bytes of a PNG file: as a palette (up to 256 colours), RGB or RGBA, whichever holds the picture exactly.
// The picture is not empty.
std::string encodePng(const Image<Rgba8>& picture);

void writePng(const std::filesystem::path& path, const Image<Rgba8>& picture); // atomically; throws OutputError

// Throws std::runtime_error, "NAME: not a PNG file that can be read: reason". `name` is only for that message.
Image<Rgba8> decodePng(std::string_view bytes, std::string_view name);
Image<Rgba8> readPng(const std::filesystem::path& path);

} // namespace lixel
