// SPDX-License-Identifier: MIT
// pcf(k): the mean of taps that are tested each, of one depth or of several. One text for the CPU executor and for GLSL.
//
//   W. Reeves, D. Salesin, R. Cook. Rendering Antialiased Shadows with Depth Maps. SIGGRAPH 1987.
#ifndef LIXEL_SHARED_LOOKUP_PCF_H
#define LIXEL_SHARED_LOOKUP_PCF_H
#include "lixel/shared/lookup/coverage.h"
#include "lixel/shared/lookup/kernel.h"

LX_SHARED_BEGIN

// The share of taps' depths that do not shadow.
LX_MAP_FN float lxLitByTaps(LxLookup how, ShadowRegion region, LxReceiver r, uint seed LX_MAP)
{
    float lit = 0.0f;
    float shift = how.store == LX_STORE_DEPTHS8 ? -0.5f : 0.0f; // its four lixels lie around the tap
    for (int j = 0; j < how.side; ++j) {
        for (int i = 0; i < how.side; ++i) {
            vec2 tap = lxTap(how, i, j, seed);
            vec2 corner = lxCornerWithin(how, region, r.lixel.x + tap.x + shift, r.lixel.y + tap.y + shift);
            lit += 1.0f - lxCoverage(how, region, r, corner LX_PASS_MAP);
        }
    }
    return lit / float(how.side * how.side);
}

LX_SHARED_END

#endif
