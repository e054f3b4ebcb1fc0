// SPDX-License-Identifier: MIT
// What stages that draw casters know of the plan: its regions and their warps.   LIXEL_NO_WARP   no region of any plan has a warp, and none
// is on a paraboloid
#include "lixel/shared/gl_slots.h"
#include "lixel/shared/light_clip.h"

layout(std430, binding = kStorageRegions) readonly buffer LixelRegions { ShadowRegion lixelRegions[]; };

#ifndef LIXEL_NO_WARP
layout(std430, binding = kStorageWarps) readonly buffer LixelWarps { float lixelWarps[]; };
float lxWarpKnot(int i) { return lixelWarps[i]; }
#include "lixel/shared/paraboloid.h"
#include "lixel/shared/warp.h"
#endif
