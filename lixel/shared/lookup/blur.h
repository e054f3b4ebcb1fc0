// SPDX-License-Identifier: MIT
// Moments averaged over a square of lixels, in two passes: across, from the depths of the map, then along. One text for the CPU executor
// and for GLSL. Lixels beyond the region's rectangle are its last ones again.
#ifndef LIXEL_SHARED_LOOKUP_BLUR_H
#define LIXEL_SHARED_LOOKUP_BLUR_H
#include "lixel/shared/lookup/moments.h"

LX_SHARED_BEGIN

LX_MAP_FN vec4 lxMomentsAcross(LxLookup how, vec4 rectangle, float bend, int x, int y, int layer LX_MAP)
{
    vec4 sum = vec4(0.0f, 0.0f, 0.0f, 0.0f);
    for (int i = -(how.blur / 2); i <= how.blur / 2; ++i) {
        int at = max(min(x + i, int(rectangle.z) - 1), int(rectangle.x));
        sum = sum + lxMomentsOf(how, lxEvenDepth(bend, LX_STORED_DEPTH(at, y, layer)));
    }
    return (1.0f / float(how.blur)) * sum;
}

// LX_STORED_MOMENTS are those of the first pass.
LX_MAP_FN vec4 lxMomentsAlong(LxLookup how, vec4 rectangle, int x, int y, int layer LX_MAP)
{
    vec4 sum = vec4(0.0f, 0.0f, 0.0f, 0.0f);
    for (int i = -(how.blur / 2); i <= how.blur / 2; ++i) {
        int at = max(min(y + i, int(rectangle.w) - 1), int(rectangle.y));
        sum = sum + LX_STORED_MOMENTS(x, at, layer);
    }
    return (1.0f / float(how.blur)) * sum;
}

LX_SHARED_END

#endif
