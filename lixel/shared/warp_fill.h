// SPDX-License-Identifier: MIT
// What the device makes the warps of a light's regions from, besides what is seen. Read by C++ and by GLSL.
#ifndef LIXEL_SHARED_WARP_FILL_H
#define LIXEL_SHARED_WARP_FILL_H
#include "lixel/shared/shading.h"

LX_SHARED_BEGIN

// (std140)
struct WarpFillSetup
{
    ShadingLight light;
    vec4 eye;     // Local xyz of the eye (w = 1), or the direction towards it (w = 0)
    vec4 picture; // x, y: pixels
    vec4 regions; // x: first, y: how many
    vec4
        importance; // x: weights that are multiplied, y: those of which the greatest is taken, bits as in SampleWeight; z: 1 where
                    // samples are summed up, 0 where the greatest counts
};

LX_SHARED_END

#endif
