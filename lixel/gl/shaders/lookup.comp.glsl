// SPDX-License-Identifier: MIT
// The visibility of one light at every view sample: region, light image, taps and test.
#include "lixel/shared/gl_slots.h"
#include "lixel/shared/view_tables.h"

layout(binding = kUnitAtlas) uniform sampler2DArray atlas;
float lxStoredDepth(int x, int y, int layer) { return texelFetch(atlas, ivec3(x, y, layer), 0).r; }
layout(std430, binding = kStorageWarps) readonly buffer Warps { float warpKnots[]; };
float lxWarpKnot(int i) { return warpKnots[i]; }

// LOOKUP says how, in terms of tapsPerSide; without it there is one depth a lixel and a regular grid of taps.
layout(location = 2) uniform int tapsPerSide;
#ifdef LOOKUP
#include "lixel/shared/lookup/stored_depths.h"
layout(binding = kUnitHardware) uniform sampler2DArrayShadow comparing;
layout(binding = kUnitWords) uniform usampler2DArray words;
layout(binding = kUnitMoreWords) uniform usampler2DArray moreWords;
layout(binding = kUnitGradients) uniform usampler2DArray gradients;
layout(binding = kUnitMoments) uniform sampler2DArray moments;
LxWords lxStoredWords(int x, int y, int layer)
{
    uint more = (LOOKUP).depths > 6 ? texelFetch(moreWords, ivec3(x, y, layer), 0).r : 0u;
    return LxWords(texelFetch(words, ivec3(x, y, layer), 0), more);
}
uint lxStoredGradient(int x, int y, int layer) { return texelFetch(gradients, ivec3(x, y, layer), 0).r; }
vec4 lxStoredMoments(int x, int y, int layer) { return texelFetch(moments, ivec3(x, y, layer), 0); }
float lxHardwareLit(vec2 lixel, int layer, float depth)
{
    return texture(comparing, vec4(lixel / vec2(textureSize(comparing, 0).xy), float(layer), depth));
}
#else
#define LX_ONE_DEPTH
#define LOOKUP lxOneDepth(tapsPerSide)
#endif
#include "lixel/shared/lookup/visibility.h"

layout(local_size_x = 64) in;

layout(std430, binding = kStoragePoints) readonly buffer Points { ViewPoint points[]; };
layout(std430, binding = kStorageRegions) readonly buffer Regions { ShadowRegion regions[]; };
layout(std430, binding = kStorageHalfSpaces) readonly buffer HalfSpaces { vec4 halfSpaces[]; };
layout(std430, binding = kStorageLights) readonly buffer Lights { ShadowLight lights[]; };
layout(std430, binding = kStorageVisibility) writeonly buffer Visibilities { float visibility[]; };

layout(location = 0) uniform uint pointCount;
layout(location = 1) uniform int light;

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
        if (receiver.isInside > 0.0) return lxVisibility(LOOKUP, regions[i], receiver, lxSeedOf(positionLocal));
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
