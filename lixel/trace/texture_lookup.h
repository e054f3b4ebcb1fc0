// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/surfaces.h"

namespace lixel {

// A texture's base level at a point, bilinear, by the arithmetic of lixel/shared/alpha.h. Needs at least one pixel.
float alphaOf(const Texture& texture, Vec2f uv);

// Linear colour: texels are decoded from sRGB, then blended.
Vec3f linearColourOf(const Texture& texture, Vec2f uv);

// IEC 61966-2-1, one of 256 codes to [0, 1].
float linearFromSrgb(std::uint8_t code);

} // namespace lixel
