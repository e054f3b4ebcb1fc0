// SPDX-License-Identifier: MIT
// From a receiver to its visibility through one region: one text for the CPU executor and for GLSL.
#ifndef LIXEL_SHARED_LOOKUP_VISIBILITY_H
#define LIXEL_SHARED_LOOKUP_VISIBILITY_H
#include "lixel/shared/lookup/coverage.h"
#include "lixel/shared/lookup/kernel.h"
#include "lixel/shared/lookup/moments.h"

LX_SHARED_BEGIN

// The corner of the lixel at a place, of those that the region owns. Where a lixel holds its neighbours to the right and above too, the
// last one is one earlier.
LX_FN vec2 lxCornerWithin(LxLookup how, ShadowRegion region, float x, float y)
{
    float last = how.store == LX_STORE_DEPTHS8 ? 2.0f : 1.0f;
    return vec2(clamp(floor(x), region.rectangle.x, region.rectangle.z - last),
                clamp(floor(y), region.rectangle.y, region.rectangle.w - last));
}

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

#ifndef LX_ONE_DEPTH
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
#endif

// Visibility: 1 lit, 0 in shadow. Taps stop at the region's rectangle. `seed` is lxSeedOf the receiver.
LX_MAP_FN float lxVisibility(LxLookup how, ShadowRegion region, LxReceiver r, uint seed LX_MAP)
{
#ifndef LX_ONE_DEPTH
    if (lxHasMoments(how)) return lxLitByMomentsAround(how, region, r LX_PASS_MAP);
    if (how.kernel == LX_KERNEL_HARDWARE) return lxLitByHardware(region, r LX_PASS_MAP);
#endif
    if (how.kernel == LX_KERNEL_BILINEAR) return lxLitByAreas(how, region, r LX_PASS_MAP) >= 0.5f ? 1.0f : 0.0f;
    return lxLitByTaps(how, region, r, seed LX_PASS_MAP);
}

LX_SHARED_END

#endif
