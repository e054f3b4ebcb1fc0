// SPDX-License-Identifier: MIT
// The slope of the surface that a lixel sees, from the map: one text for the CPU executor and for GLSL.
//
// A lixel's slope is taken from the map itself, so that it serves casters of any source and maps of any warp. Along each axis it is
// the step to one of the two neighbours: to the one from which the lixel after it is foretold better, for that is the side on which
// the surface goes on. Neighbours end at the region's rectangle; empty ones foretell nothing.
#ifndef LIXEL_SHARED_LOOKUP_GRADIENT_H
#define LIXEL_SHARED_LOOKUP_GRADIENT_H
#include "lixel/shared/lookup/maps.h"

LX_SHARED_BEGIN

// Slopes are kept as the upper halves of two floats, which round by as much of themselves.
const float LX_SLOPE_ROUNDING = 0.00390625f;

LX_FN uint lxPackedGradient(vec2 gradient)
{
    uint x = floatBitsToUint(gradient.x) + 32768u;
    uint y = floatBitsToUint(gradient.y) + 32768u;
    return (x >> 16u) | (y & 4294901760u);
}

LX_FN vec2 lxUnpackedGradient(uint word)
{
    return vec2(uintBitsToFloat(word << 16u), uintBitsToFloat(word & 4294901760u));
}

// A step from a lixel and how far off it is one lixel further; less than 0: nothing is known.
struct LxStep
{
    float slope;
    float error;
};

LX_FN LxStep lxStep(float here, float next, float afterNext)
{
    LxStep s;
    s.slope = next - here;
    s.error = next > 0.0f ? abs(afterNext - 2.0f * next + here) : -1.0f;
    return s;
}

// Of two steps, forward and backward.
LX_FN float lxSlope(LxStep forward, LxStep backward)
{
    if (forward.error < 0.0f && backward.error < 0.0f) return 0.0f;
    bool isForward = backward.error < 0.0f || (forward.error >= 0.0f && forward.error <= backward.error);
    return isForward ? forward.slope : -backward.slope;
}

LX_MAP_FN float lxDepthWithin(vec4 rectangle, int x, int y, int layer LX_MAP)
{
    bool isOwned = x >= int(rectangle.x) && x < int(rectangle.z) && y >= int(rectangle.y) && y < int(rectangle.w);
    return isOwned ? LX_STORED_DEPTH(x, y, layer) : 0.0f;
}

// Depth a lixel along x and y, at a lixel of a region with this rectangle.
LX_MAP_FN vec2 lxGradient(vec4 rectangle, int x, int y, int layer LX_MAP)
{
    float here = LX_STORED_DEPTH(x, y, layer);
    LxStep right = lxStep(here, lxDepthWithin(rectangle, x + 1, y, layer LX_PASS_MAP),
                          lxDepthWithin(rectangle, x + 2, y, layer LX_PASS_MAP));
    LxStep left = lxStep(here, lxDepthWithin(rectangle, x - 1, y, layer LX_PASS_MAP),
                         lxDepthWithin(rectangle, x - 2, y, layer LX_PASS_MAP));
    LxStep above = lxStep(here, lxDepthWithin(rectangle, x, y + 1, layer LX_PASS_MAP),
                          lxDepthWithin(rectangle, x, y + 2, layer LX_PASS_MAP));
    LxStep below = lxStep(here, lxDepthWithin(rectangle, x, y - 1, layer LX_PASS_MAP),
                          lxDepthWithin(rectangle, x, y - 2, layer LX_PASS_MAP));
    return vec2(lxSlope(right, left), lxSlope(above, below));
}

LX_SHARED_END

#endif
