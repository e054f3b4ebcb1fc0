// SPDX-License-Identifier: MIT
// The one region that a warped map is drawn for, its warp and the sizes of its tables.
#include "lixel/shared/gl_slots.h"
#include "lixel/shared/light_clip.h"
#include "lixel/shared/warp_raster.h"

layout(std140, binding = kUniformRegion) uniform Region { ShadowRegion region; };
layout(std140, binding = kUniformWarpRaster) uniform Setup { WarpRasterSetup setup; };

ivec2 mapSize() { return ivec2(setup.size.xy); }
