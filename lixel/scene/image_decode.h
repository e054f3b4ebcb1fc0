// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/image.h"
#include "lixel/base/surfaces.h"

#include <cstddef>
#include <span>
#include <string>

namespace lixel {

inline constexpr int kMostImageSide = 16384;

enum class RowOrder { FileFirst, FileLast }; // which row of the file becomes row 0

// A PNG, JPEG, BMP or TGA file as 8-bit RGBA. Throws InputError where it is none of them, broken, larger than 16384 a
// side, or claims far more pixels than its bytes can hold.
Image<Rgba8> decodeImage(std::span<const std::byte> bytes, RowOrder rows, const std::string& file,
                         const std::string& place);

} // namespace lixel
