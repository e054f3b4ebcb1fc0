// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/image.h"
#include "lixel/base/surfaces.h"
#include "lixel/scene/input_file.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace lixel {

inline constexpr int kMostImageSide = 16384;

// The bytes of an image file, of at most 256 MiB; those of a large one only if it starts as an image. Throws InputError.
std::vector<std::byte> readImageBytes(InputBytes& bytes, const std::string& file, const std::string& place);

enum class RowOrder { FileFirst, FileLast }; // which row of the file becomes row 0

// A PNG, JPEG, BMP or TGA file as 8-bit RGBA. Throws InputError where it is none of them, broken, larger than 16384 a
// side, or claims far more pixels than its bytes can hold.
Image<Rgba8> decodeImage(std::span<const std::byte> bytes, RowOrder rows, const std::string& file,
                         const std::string& place);

} // namespace lixel
