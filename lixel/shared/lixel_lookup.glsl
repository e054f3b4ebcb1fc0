// SPDX-License-Identifier: MIT
// The shadow lookup for a host's shaders, behind its `#version` line (GLSL 4.50, GLSL for Vulkan, GLSL ES 3.20):
//
//   float visibility = lixelVisibility(light, positionLocal, normal, tapsPerSide);
//
// Installed as one file without #include. The host defines the five functions declared below, anywhere, from wherever it keeps
// the tables of FramePlan and the maps that it has drawn.
#include "lixel/shared/shadow_tables.h"

ShadowRegion lxRegionAt(int index);  // FramePlan::regionTable
vec4 lxHalfSpaceAt(int index);       // FramePlan::halfSpaceTable
ShadowLight lxLightAt(int index);    // FramePlan::lightTable
float lxWarpKnot(int index);         // FramePlan::warpTable; never called, and may give 0, where no technique has a warp

// The depth stored for lixel (x, y) of a layer of the atlas, as 1 at the near side and 0 at the far side and where nothing was
// drawn; y counts from the bottom. A host that stores 0 at the near side gives 1 - depth; one whose row 0 is at the top
// fetches row height - 1 - y; one that stores fixed-point depth takes a step of it off. See docs/hosts.md.
float lxStoredDepth(int x, int y, int layer);

#define LX_ONE_DEPTH
#include "lixel/shared/lookup/visibility.h"

// What stands for a point that no region of the light serves.
const float kLixelUnserved = -1.0;

// Of one light at a surface point: 1 lit, 0 in shadow, between where taps disagree, kLixelUnserved outside all of the light's
// maps (treat it as lit). `normal` is the surface's own, unit, either way round; not an interpolated or bumped one.
// `tapsPerSide` is LookupLayout::tapsPerSide. Surfaces that face away from the light are the caller's: they are dark anyway.
float lixelVisibility(int light, vec3 positionLocal, vec3 normal, int tapsPerSide)
{
    ShadowLight served = lxLightAt(light);
    int end = int(served.regions.x) + int(served.regions.y);
    for (int i = int(served.regions.x); i < end; ++i) {
        ShadowRegion region = lxRegionAt(i);
        bool isHeld = true;
        int endOfHalfSpaces = int(region.place.y) + int(region.place.z);
        for (int j = int(region.place.y); j < endOfHalfSpaces && isHeld; ++j)
            isHeld = lxHolds(lxHalfSpaceAt(j), positionLocal);
        if (!isHeld) continue;
        LxReceiver receiver = lxReceive(region, positionLocal, normal);
        if (receiver.isInside > 0.0)
            return lxVisibility(lxOneDepth(tapsPerSide), region, receiver, 0u);
    }
    return kLixelUnserved;
}
