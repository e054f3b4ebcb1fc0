// SPDX-License-Identifier: MIT
// View samples, one a pixel, and the regions of one light that serve them before any warp (lixel/plan/warp/region_warps.h).
#include "lixel/shared/gl_slots.h"
#include "lixel/shared/light_clip.h"
#include "lixel/shared/paraboloid.h"
#include "lixel/shared/view_tables.h"
#include "lixel/shared/warp_fill.h"

layout(std140, binding = kUniformWarpFill) uniform Setup { WarpFillSetup setup; };
layout(std430, binding = kStoragePoints) readonly buffer Points { ViewPoint points[]; };
layout(std430, binding = kStorageRegions) readonly buffer Regions { ShadowRegion regions[]; };

layout(location = 0) uniform uint pointCount; // in this part of the list

float distance2ToEye(vec3 positionLocal)
{
    vec3 to = positionLocal - setup.eye.xyz;
    return setup.eye.w == 0.0 ? 1.0 : dot(to, to);
}

// Continuous lixel before the warp; `isServed` tells whether the region serves it, its half-spaces apart.
vec2 lixelBefore(ShadowRegion region, vec3 positionLocal, out bool isServed)
{
    vec4 clip = lxLightClip(region, positionLocal);
    bool isOnParaboloid = lxIsOnParaboloid(region);
    vec3 ndc = isOnParaboloid ? lxParaboloidNdc(region, clip) : clip.xyz / clip.w;
    vec2 at = ndc.xy * region.lixelFromNdc.xy + region.lixelFromNdc.zw;
    isServed = (isOnParaboloid || clip.w > 0.0) && ndc.z >= 0.0 && all(greaterThanEqual(at, region.serves.xy)) &&
               all(lessThan(at, region.serves.zw));
    return at;
}

vec2 placeInSquare(ShadowWarp warp, vec2 lixel) { return (lixel - warp.square.xy) / (warp.square.zw - warp.square.xy); }
