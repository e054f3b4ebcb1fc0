// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/clip_convention.h"
#include "lixel/plan/shadow_plan.h"

namespace lixel {

// A region of a plan as a host draws and reads it.
struct HostRegion
{
    Mat4d clipFromLocal;     // casters are drawn with it, Local = World - FramePlan::originWorld ...
    LixelRectangle viewport; // ... into these texels of a layer, rows counted as the host's textures count them
    Mat4d textureFromLocal; // and read with it: after division by w, (u, v) in [0, 1] of the whole layer, and the depth
    // that a depth buffer of range 0..1 holds there; inside where w > 0 and (u, v) in `viewport`
};

// Needs a region that a matrix serves: on a paraboloid hosts draw and look up through lixel's GLSL. So they do where a warp moves
// lixels, which is left out here: both matrices are those before it.
// `atlas` is the size of the host's texture, FramePlan::atlas or larger. Casters between the light and the near side are to be
// clamped to it, not clipped (depth clamp, or DepthClipEnable = false).
HostRegion toHost(const PlannedRegion& region, LixelSize atlas, const ClipConvention& host, TextureOrigin origin);

// A continuous place in a layer, lixels from the bottom, as the host counts its texels. Its own inverse.
Vec2d toHost(Vec2d lixel, LixelSize atlas, TextureOrigin origin);

} // namespace lixel
