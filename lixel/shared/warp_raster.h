// SPDX-License-Identifier: MIT
// Tables by which triangles are drawn exactly into one region's warped map (lixel/gl/passes/exact_warp.h). Read by C++ and by GLSL.
#ifndef LIXEL_SHARED_WARP_RASTER_H
#define LIXEL_SHARED_WARP_RASTER_H
#include "lixel/shared/glsl.h"

LX_SHARED_BEGIN

// Bounds of a warp's functions of x stand in levels: a block of level 0 holds so many lines, one of the next level four blocks.
const int LX_BOUND_LINES = 8;
const int LX_BOUND_BLOCKS = 4;
const int LX_BOUND_LEVELS = 8;

// Lixels of a column that are looked at, or passed over, at once.
const int LX_WARP_RUN = 16;

// Sizes of the region's tables (std140).
struct WarpRasterSetup
{
    vec4 size;      // x, y: lixels of its rectangle; z: runs of a column
    vec4 levels[8]; // x: first pair of a level's bounds, y: its blocks of lines
};

LX_SHARED_END

#endif
