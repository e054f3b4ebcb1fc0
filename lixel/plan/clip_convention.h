// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/mat4.h"

// Inside lixel there is one clip convention: NDC x, y, z in [-1, +1], y up, depth growing away from the eye or light,
// inside where w > 0. Hosts have others; matrices enter and leave through here, and nothing else knows of them.
namespace lixel {

enum class ClipDepth {
    MinusOneToOne, // OpenGL's default
    ZeroToOne,     // Direct3D, Vulkan, Metal, WebGPU
    OneToZero,     // reversed: 1 at the near side
};

struct ClipConvention
{
    ClipDepth depth = ClipDepth::MinusOneToOne;
    bool yDown = false; // Vulkan without a negative viewport
    friend bool operator==(const ClipConvention&, const ClipConvention&) = default;
};

// Where row 0 of the host's textures lies. Said of the picture that a map is, in lixel's y up: `Bottom` where NDC y = -1 of
// lixel's convention is drawn into row 0. OpenGL draws so, and so does Vulkan with matrices that are not turned (yDown false,
// the light image then lies as in OpenGL); Direct3D, Metal and WebGPU draw NDC y = +1 into row 0, hence `Top`.
enum class TextureOrigin { Bottom, Top };

// What lixel's own executors draw and store: y up, depth reversed in 0..1, so that floats keep relative precision far away.
inline constexpr ClipConvention kExecutorConvention{ClipDepth::OneToZero, false};

// The same projection in the host's convention. Infinite far planes stay infinite.
Mat4d toHost(const Mat4d& clipFromSource, const ClipConvention& host);

// The inverse of toHost.
Mat4d fromHost(const Mat4d& hostClipFromSource, const ClipConvention& host);

} // namespace lixel
