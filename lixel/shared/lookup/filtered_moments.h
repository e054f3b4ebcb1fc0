// SPDX-License-Identifier: MIT
// vsm, evsm2, evsm4, msm: what the stored moments around a receiver say of it. One text for the CPU executor and for GLSL.
#ifndef LIXEL_SHARED_LOOKUP_FILTERED_MOMENTS_H
#define LIXEL_SHARED_LOOKUP_FILTERED_MOMENTS_H
#include "lixel/shared/lookup.h"
#include "lixel/shared/lookup/kernel.h"
#include "lixel/shared/lookup/moments.h"

LX_SHARED_BEGIN

// Moments between the centres of lixels are linear, as depths of a plane are. Means are then no nearer than the plane; bounds that hold
// below the mean too (evsm4, msm) see the whole spread of the plane's depths, and the receiver is taken before all of them.
LX_MAP_FN float lxLitByMomentsAround(LxLookup how, ShadowRegion region, LxReceiver r LX_MAP)
{
    float x = r.lixel.x - 0.5f;
    float y = r.lixel.y - 0.5f;
    float right = x - floor(x);
    float above = y - floor(y);
    vec4 moments = vec4(0.0f, 0.0f, 0.0f, 0.0f);
    for (int i = 0; i < 4; ++i) {
        int column = i % 2;
        int row = i / 2;
        float areaX = column == 0 ? 1.0f - right : right;
        float areaY = row == 0 ? 1.0f - above : above;
        vec2 corner = lxCornerWithin(how, region, x + float(column), y + float(row));
        moments = moments + areaX * areaY * LX_STORED_MOMENTS(int(corner.x), int(corner.y), int(region.place.x));
    }
    float slope = r.steepness.x + r.steepness.y;
    float spread = how.store >= LX_STORE_EVSM4 ? 0.5f * float(how.blur) * slope : 0.0f;
    float depth = clamp(lxShadowingDepth(r, r.lixel LX_PASS_MAP_KNOTS) + spread, 0.0f, 1.0f);
    return lxLitByMoments(how, moments, lxEvenDepth(region.projection.z, depth));
}

LX_SHARED_END

#endif
