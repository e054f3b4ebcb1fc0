// SPDX-License-Identifier: MIT
// hardware-pcf: the 2x2 comparison of texture units. One text for the CPU executor and for GLSL.
#ifndef LIXEL_SHARED_LOOKUP_HARDWARE_PCF_H
#define LIXEL_SHARED_LOOKUP_HARDWARE_PCF_H
#include "lixel/shared/lookup.h"
#include "lixel/shared/lookup/maps.h"

LX_SHARED_BEGIN

// As texture units filter: all four lixels against one depth. It is nearer than the receiver's plane by what that changes over a lixel,
// so that a plane alone is lit, and by the margin of every lookup. In a warped map the plane may change by more towards one of the four.
LX_MAP_FN float lxLitByHardware(ShadowRegion region, LxReceiver r LX_MAP)
{
    float slope = r.steepness.x + r.steepness.y;
    float planeDepth = lxPlaneDepth(r, r.lixel LX_PASS_MAP_KNOTS) + slope;
#ifndef LIXEL_NO_WARP
    for (int i = 0; i < 4 && r.warp.kind.x != LX_WARP_NONE; ++i) {
        int row = i / 2;
        vec2 centre = vec2(floor(r.lixel.x - 0.5f) + 0.5f + float(i % 2), floor(r.lixel.y - 0.5f) + 0.5f + float(row));
        planeDepth = max(planeDepth, lxPlaneDepth(r, centre LX_PASS_MAP_KNOTS));
    }
#endif
    float depth = max(planeDepth + r.margin * slope + r.slack + r.slackBeside, 0.0f);
    vec2 lixel = vec2(clamp(r.lixel.x, region.rectangle.x + 0.5f, region.rectangle.z - 0.5f),
                      clamp(r.lixel.y, region.rectangle.y + 0.5f, region.rectangle.w - 0.5f));
    return LX_HARDWARE_LIT(lixel, int(region.place.x), depth);
}

LX_SHARED_END

#endif
