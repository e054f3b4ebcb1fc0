// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/gl/device/device.h"
#include "lixel/gl/device/objects.h"

namespace lixel::gl {

// What the view pass writes, one texel a pixel.
struct ViewTargets
{
    Texture triangles;  // R32UI: in drawing order; 0xffffffff where nothing is seen
    Texture baseColour; // sRGB
    Texture normal;     // of shading: octahedral, (0, 0) where the surface has none of its own; see octahedron.glsl
    Texture depth;      // 32F, 1 near, 0 far
    Framebuffer framebuffer;

    // Throws GraphicsError, by name, at a picture larger than the device's textures.
    void resize(const Device& device, int width, int height);
};

} // namespace lixel::gl
