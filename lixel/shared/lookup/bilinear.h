// SPDX-License-Identifier: MIT
// bilinear: the four lixels around a receiver, each tested, by their areas; visibility.h rounds it. One text for the CPU executor and for
// GLSL.
#ifndef LIXEL_SHARED_LOOKUP_BILINEAR_H
#define LIXEL_SHARED_LOOKUP_BILINEAR_H
#include "lixel/shared/lookup/coverage.h"
#include "lixel/shared/lookup/kernel.h"

LX_SHARED_BEGIN

// Of the four lixels whose centres are around the receiver, by the areas that a lixel-sized square around it has of them.
LX_MAP_FN float lxLitByAreas(LxLookup how, ShadowRegion region, LxReceiver r LX_MAP)
{
    float x = r.lixel.x - 0.5f;
    float y = r.lixel.y - 0.5f;
    float right = x - floor(x);
    float above = y - floor(y);
    float lit = 0.0f;
    for (int i = 0; i < 4; ++i) {
        int column = i % 2;
        int row = i / 2;
        float areaX = column == 0 ? 1.0f - right : right;
        float areaY = row == 0 ? 1.0f - above : above;
        vec2 corner = lxCornerWithin(how, region, x + float(column), y + float(row));
        lit += areaX * areaY * (1.0f - lxCoverage(how, region, r, corner LX_PASS_MAP));
    }
    return lit;
}

LX_SHARED_END

#endif
