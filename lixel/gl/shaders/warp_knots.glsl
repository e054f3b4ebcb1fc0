// SPDX-License-Identifier: MIT
// The knots of all warps of a plan.
#include "lixel/shared/gl_slots.h"

layout(std430, binding = kStorageWarps) readonly buffer Warps { float warpKnots[]; };
float lxWarpKnot(int i) { return warpKnots[i]; }
#include "lixel/shared/warp.h"
