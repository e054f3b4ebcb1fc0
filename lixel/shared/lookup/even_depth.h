// SPDX-License-Identifier: MIT
// Depths that are even in the distance from the light, for lookups that average them or keep few bits: one text for the CPU executor and
// for GLSL.
//
// Under a light at a point a map's own depth is one over the distance: of a spot's reach, nearly all lies in the last hundredth of it.
// That is right for one depth of 32 bits, which floats with 0 at the far side hold as exactly everywhere. Moments of it, and steps of
// 1/255, cannot tell most bodies from what they stand on. With d the depth, 1 near and 0 far, and D what it comes to at infinity,
//
//   even = d / (1 - bend + bend d),   bend = 1 / (1 - D)        (ShadowRegion::projection z)
//
// is linear in the distance along the ray, 1 near and 0 far. Under parallel rays bend is 0 and nothing changes. It grows with depth, so
// what is before what stays: any bend between 0 and 1 is right, and one serves the whole map.
#ifndef LIXEL_SHARED_LOOKUP_EVEN_DEPTH_H
#define LIXEL_SHARED_LOOKUP_EVEN_DEPTH_H
#include "lixel/shared/glsl.h"

LX_SHARED_BEGIN

LX_FN float lxEvenDepth(float bend, float depth) { return depth / (1.0f - bend + bend * depth); }

LX_FN float lxDepthOfEven(float bend, float even)
{
    float rest = (1.0f - bend) * even;
    return rest / (1.0f - even + rest);
}

LX_SHARED_END

#endif
