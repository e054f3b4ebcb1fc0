// SPDX-License-Identifier: MIT
// The visibility of one light at every view sample: region, light image, taps and test.
#include "lixel/shared/gl_slots.h"
#include "lixel/shared/view_tables.h"

layout(binding = kUnitAtlas) uniform sampler2DArray atlas;
float lxStoredDepth(int x, int y, int layer) { return texelFetch(atlas, ivec3(x, y, layer), 0).r; }
layout(std430, binding = kStorageWarps) readonly buffer Warps { float warpKnots[]; };
float lxWarpKnot(int i) { return warpKnots[i]; }
#include "lixel/shared/lookup.h"

layout(local_size_x = 64) in;

layout(std430, binding = kStoragePoints) readonly buffer Points { ViewPoint points[]; };
layout(std430, binding = kStorageRegions) readonly buffer Regions { ShadowRegion regions[]; };
layout(std430, binding = kStorageHalfSpaces) readonly buffer HalfSpaces { vec4 halfSpaces[]; };
layout(std430, binding = kStorageLights) readonly buffer Lights { ShadowLight lights[]; };
layout(std430, binding = kStorageVisibility) writeonly buffer Visibilities { float visibility[]; };

layout(location = 0) uniform uint pointCount;
layout(location = 1) uniform int light;
layout(location = 2) uniform int tapsPerSide;

// What stands for a sample that no region of the light holds.
const float kUnserved = -1.0;

bool holds(ShadowRegion region, vec3 positionLocal)
{
    int first = int(region.place.y), end = first + int(region.place.z);
    for (int i = first; i < end; ++i)
        if (!lxHolds(halfSpaces[i], positionLocal)) return false;
    return true;
}

float visibilityOf(vec3 positionLocal, vec3 normal)
{
    int first = int(lights[light].regions.x), end = first + int(lights[light].regions.y);
    for (int i = first; i < end; ++i) {
        if (!holds(regions[i], positionLocal)) continue;
        LxReceiver receiver = lxReceive(regions[i], positionLocal, normal);
        if (receiver.isInside > 0.0) return lxVisibility(regions[i], receiver, tapsPerSide);
    }
    return kUnserved;
}

void main()
{
    uint entry = gl_GlobalInvocationID.x;
    if (entry >= pointCount) return;
    ViewPoint point = points[entry];
    float value = point.pixel == kNoPixel ? kUnserved : visibilityOf(point.positionLocal, point.normal);
    visibility[uint(light) * pointCount + entry] = value;
}
