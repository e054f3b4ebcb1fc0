// SPDX-License-Identifier: MIT
// Importance maps of a light's regions, by integer atomics: the twin of weighSamples() and countSamples() (lixel/plan/warp/importance.h).
//   without MOVED   every sample is weighed, finds its region, and counts in the lixel where it falls; row by row
//   MOVED           with the weights kept, where the functions of its row take it; column by column
#include "lixel/gl/shaders/importance_points.glsl"
#include "lixel/shared/importance.h"
#include "lixel/shared/observe.h"
#ifdef MOVED
#include "lixel/gl/shaders/warp_knots.glsl"
#endif

layout(local_size_x = 64) in;

layout(std430, binding = kStorageHalfSpaces) readonly buffer HalfSpaces { vec4 halfSpaces[]; };
layout(std430, binding = kStorageNearest) readonly buffer Nearest { uint nearest2; };
layout(std430, binding = kStorageWeights) buffer Weights { uint weights[]; }; // units, and from bit 16 on the region, from 1 on; 0: none
layout(std430, binding = kStorageImportance) buffer Importance { uint importance[]; }; // of one region after the other

// Bits of SampleWeight.
const int kDistanceWeight = 1;
const int kNormalWeight = 2;
const int kEdgesWeight = 4;

void count(uint cell, uint units)
{
    if (setup.importance.z > 0.0) atomicAdd(importance[cell], units);
    else atomicMax(importance[cell], units);
}

void countAt(ShadowWarp warp, uint firstCell, vec2 place, uint units)
{
    ivec2 grid = ivec2(warp.grid.yz);
    ivec2 cell = min(ivec2(place * vec2(grid)), grid - 1);
#ifdef MOVED
    count(firstCell + uint(cell.x * grid.y + cell.y), units);
#else
    count(firstCell + uint(cell.y * grid.x + cell.x), units);
#endif
}

#ifdef MOVED
void main()
{
    uint entry = gl_GlobalInvocationID.x;
    if (entry >= pointCount || weights[entry] == 0u) return;
    int own = int(weights[entry] >> 16u) - 1, first = int(setup.regions.x);
    uint firstCell = 0u;
    for (int i = first; i < first + own; ++i) firstCell += uint(regions[i].warp.grid.y * regions[i].warp.grid.z);
    ShadowRegion region = regions[first + own];
    bool isServed;
    vec2 place = placeInSquare(region.warp, lixelBefore(region, points[entry].positionLocal, isServed));
    LxAlongLine x = lxAlongLine(lxRowLines(region.warp, place.y), int(region.warp.grid.y), place.x);
    countAt(region.warp, firstCell, vec2(x.value, place.y), weights[entry] & 0xffffu);
}
#else
bool isSmooth(ViewPoint a, ViewPoint b)
{
    return dot(a.normal, b.normal) >= LX_EDGE_COSINE && !lxIsDepthJump(a.positionLocal, a.normal, b.positionLocal, b.normal);
}

bool isEdgeTo(ViewPoint own, int pixel, ivec2 way)
{
    ivec2 size = ivec2(setup.picture.xy);
    ivec2 at = ivec2(pixel % size.x, pixel / size.x) + way;
    if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, size))) return false;
    ViewPoint other = points[at.y * size.x + at.x];
    return other.pixel == kNoPixel || !isSmooth(own, other);
}

float edgesWeight(ViewPoint point)
{
    int pixel = int(point.pixel);
    bool isAtEdge = isEdgeTo(point, pixel, ivec2(1, 0)) || isEdgeTo(point, pixel, ivec2(-1, 0)) ||
                    isEdgeTo(point, pixel, ivec2(0, 1)) || isEdgeTo(point, pixel, ivec2(0, -1));
    return isAtEdge ? 1.0 : LX_AWAY_FROM_EDGES;
}

float normalWeight(ViewPoint point)
{
    vec3 toEye = normalize(setup.eye.xyz - setup.eye.w * point.positionLocal);
    vec3 toLight = normalize(setup.light.place.xyz - setup.light.place.w * point.positionLocal);
    return lxNormalWeight(abs(dot(point.normal, toEye)), dot(point.normal, toLight));
}

uint unitsOf(ViewPoint point)
{
    int factors = int(setup.importance.x), greatestOf = int(setup.importance.y), all = factors | greatestOf;
    float weight = 1.0, greatest = 0.0;
    for (int one = kDistanceWeight; one <= kEdgesWeight; one *= 2) {
        if ((all & one) == 0) continue;
        float value = 1.0;
        if (one == kDistanceWeight) value = lxDistanceWeight(uintBitsToFloat(nearest2), distance2ToEye(point.positionLocal));
        else if (one == kNormalWeight) value = normalWeight(point);
        else value = edgesWeight(point);
        if ((factors & one) != 0) weight *= value;
        if ((greatestOf & one) != 0) greatest = max(greatest, value);
    }
    return uint(lxImportanceUnits(greatestOf != 0 ? weight * greatest : weight));
}

bool isHeld(ShadowRegion region, vec3 positionLocal)
{
    int begin = int(region.place.y), end = begin + int(region.place.z);
    for (int i = begin; i < end; ++i)
        if (dot(halfSpaces[i].xyz, positionLocal) + halfSpaces[i].w < 0.0) return false;
    return true;
}

void main()
{
    uint entry = gl_GlobalInvocationID.x;
    if (entry >= pointCount) return;
    weights[entry] = 0u;
    ViewPoint point = points[entry];
    if (point.pixel == kNoPixel || !lxFaces(setup.light, point.positionLocal, point.normal)) return;
    int first = int(setup.regions.x), count = int(setup.regions.y);
    uint firstCell = 0u;
    for (int i = 0; i < count; ++i) {
        ShadowRegion region = regions[first + i];
        bool isServed;
        vec2 lixel = lixelBefore(region, point.positionLocal, isServed);
        if (isServed && isHeld(region, point.positionLocal)) {
            vec2 place = placeInSquare(region.warp, lixel);
            bool isInside = all(greaterThanEqual(place, vec2(0.0))) && all(lessThan(place, vec2(1.0)));
            if (region.warp.kind.x == LX_WARP_NONE || !isInside) return;
            uint units = unitsOf(point);
            weights[entry] = units | uint(i + 1) << 16u;
            countAt(region.warp, firstCell, place, units);
            return;
        }
        firstCell += uint(region.warp.grid.y * region.warp.grid.z);
    }
}
#endif
