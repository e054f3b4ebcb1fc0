// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/image.h"
#include "lixel/base/vec.h"

#include <cstdint>
#include <vector>

// What surfaces look like, as both executors read it.
namespace lixel {

struct Rgba8
{
    std::uint8_t r = 255, g = 255, b = 255, a = 255;
    friend constexpr bool operator==(const Rgba8&, const Rgba8&) = default;
};

enum class Wrap { Repeat, MirroredRepeat, ClampToEdge };

// One base level, no mips: alpha must not depend on the distance.
struct Texture
{
    Image<Rgba8> pixels; // sRGB colour, linear alpha; row 0 is v = 0
    Wrap wrapU = Wrap::Repeat, wrapV = Wrap::Repeat;
};

enum class AlphaMode { Opaque, Mask };

struct Material
{
    Vec4f baseColour{0.8f, 0.8f, 0.8f, 1}; // linear, times vertex colour, times texture
    int texture = -1;                      // into the materials' textures, -1: none
    AlphaMode alphaMode = AlphaMode::Opaque;
    float alphaCutoff = 0.5f; // Mask: kept where alpha >= cutoff. BLEND of files becomes Mask with 0.5
    bool doubleSided = false; // of the shading only: for eye, light and rays all triangles have two sides
    Vec3f emission{0, 0, 0};
};

} // namespace lixel
