// SPDX-License-Identifier: MIT
// Least and greatest of each knot of a warp over blocks of its lines, one level: a pair a block and knot. Between two knots every
// line of the block lies between the straight lines through the two pairs.
#include "lixel/gl/shaders/warp_knots.glsl"
#include "lixel/shared/warp_raster.h"

layout(local_size_x = 64) in;

layout(std430, binding = kStorageWarpBounds) buffer Bounds { vec2 bounds[]; };

layout(location = 0) uniform int firstPair;   // of this level
layout(location = 1) uniform int blocks;      // of it
layout(location = 2) uniform int knots;       // of a line
layout(location = 3) uniform int firstBefore; // of level 0: of the lines' own knots; else of the pairs of the level before
layout(location = 4) uniform int before;      // lines, or blocks of the level before
layout(location = 5) uniform int isLevel0;

void main()
{
    int index = int(gl_GlobalInvocationID.x);
    if (index >= blocks * knots) return;
    int block = index / knots, knot = index % knots;
    int each = isLevel0 != 0 ? LX_BOUND_LINES : LX_BOUND_BLOCKS;
    vec2 bound = vec2(1.0, 0.0);
    for (int line = block * each; line < min((block + 1) * each, before); ++line) {
        int at = firstBefore + line * knots + knot;
        vec2 own = isLevel0 != 0 ? vec2(lxWarpKnot(at)) : bounds[at];
        bound = vec2(min(bound.x, own.x), max(bound.y, own.y));
    }
    bounds[firstPair + index] = bound;
}
