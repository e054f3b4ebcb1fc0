// SPDX-License-Identifier: MIT
// Tables of sample-distribution cascades under parallel light, made from what a view sees: one text for C++ and for GLSL. The
// rules are those of splitSdsm(), fitDesiredView() and place(), in floats.
#ifndef LIXEL_SHARED_SDSM_H
#define LIXEL_SHARED_SDSM_H
#include "lixel/shared/observe.h"
#include "lixel/shared/shadow_tables.h"

LX_SHARED_BEGIN

// What is known of one light's cascades before the view is drawn (std140). A row's value at a point is dot(xyz, point) + w.
struct SdsmSetup
{
    ShadingLight light;
    vec4 viewDepth;                  // row: how far along the line of sight
    vec4 lightX, lightY, lightDepth; // rows: where a point's light ray meets the light plane, and how far along it
    vec4 regions; // x: first, y: how many, at most 16; z: first of their half-spaces, one fewer; w: reach, lixels
    vec4 options; // x: 1 where splits are logarithmic, 0 where even; y: how many caster boxes
};

// One box of casters as the light sees it (std430).
struct SdsmCasters
{
    vec4 onPlane; // least x, y, greatest x, y
    vec4 depth;   // x: nearest
};

// What lies in one cascade, of samples that face the light.
struct SdsmBounds
{
    vec4 onPlane;         // least x, y, greatest x, y
    float farthest;       // along the light
    float termsX, termsY; // the greatest sum of what x and y are added up from, which is what floats round by
};

// Against a split's depth and the offset of depths: samples so near the split count in both cascades, since who is served where
// is decided in other floats.
const float LX_SDSM_OVERLAP = 1.0e-5f;
const float LX_SDSM_OFFSET_ROUNDING = 4.0e-7f;
// Half a side of a map is not less than this part of its terms: two thousand times what floats round by.
const float LX_SDSM_LEAST_HALF = 1.1920929e-4f;
// The part of half a side that samples may stray by rounding, and what of their terms rounding comes to: beyond, there is room.
const float LX_SDSM_UNROOMED = 3.90625e-4f;
const float LX_SDSM_ROUNDING = 3.5762787e-7f;
// Room at a map's near and far side for the rounding of depths to float. (At its borders the guard band of the lookup's reach has
// room for far more.)
const float LX_SDSM_ROOM = 2.0e-7f;

LX_FN float lxSdsmAt(vec4 row, vec3 positionLocal)
{
    LX_PRECISE float value = row.x * positionLocal.x + row.y * positionLocal.y + row.z * positionLocal.z + row.w;
    return value;
}

// Where cascade `i` begins and cascade i - 1 ends.
LX_FN float lxSdsmSplit(SdsmSetup setup, float nearest, float farthest, int i)
{
    float share = float(i) / setup.regions.y;
    if (i == 0) return nearest;
    if (float(i) == setup.regions.y) return farthest;
    if (setup.options.x > 0.0f && nearest > 0.0f) return nearest * pow(farthest / nearest, share);
    return nearest + (farthest - nearest) * share;
}

// Whether the map of cascade `i`, from `begin` to `end`, must hold a sample of this depth; nobody is before the first or behind
// the last.
LX_FN bool lxSdsmHolds(SdsmSetup setup, int i, float begin, float end, float depth)
{
    float slack = max(LX_SDSM_OVERLAP * abs(end), LX_SDSM_OFFSET_ROUNDING * abs(setup.viewDepth.w));
    return (i == 0 || depth >= begin - slack) && (float(i + 1) == setup.regions.y || depth <= end + slack);
}

// The half-space that a sample must be in to be served by cascade i, which is not the last.
LX_FN vec4 lxSdsmHalfSpace(SdsmSetup setup, float nearest, float farthest, int i)
{
    return vec4(-setup.viewDepth.x, -setup.viewDepth.y, -setup.viewDepth.z,
                lxSdsmSplit(setup, nearest, farthest, i + 1) - setup.viewDepth.w);
}

// Whether casters of this box can shadow something in the cascade's map.
LX_FN bool lxSdsmMeets(SdsmCasters box, SdsmBounds bounds)
{
    return box.onPlane.x <= bounds.onPlane.z && box.onPlane.z >= bounds.onPlane.x &&
           box.onPlane.y <= bounds.onPlane.w && box.onPlane.w >= bounds.onPlane.y;
}

// What a row's value at a point is added up from, but for its constant.
LX_FN float lxSdsmTerms(vec4 row, vec3 p) { return abs(row.x * p.x) + abs(row.y * p.y) + abs(row.z * p.z); }

// Half a side of the map. (Samples at the border of the narrowest maps count a little more than in rectangleAround(), which knows
// the middle when it adds up terms.)
LX_FN float lxSdsmHalf(float least, float greatest, float terms)
{
    float tight = 0.5f * (greatest - least);
    float all = terms + 0.5f * abs(greatest + least) + tight;
    float roomy = (1.0f - LX_SDSM_UNROOMED) * tight + LX_SDSM_ROUNDING * all;
    return max(max(max(tight, LX_SDSM_LEAST_HALF * all), roomy) * 1.000001f, 1.0e-9f);
}

// A cascade without samples: no point is inside.
LX_FN mat4 lxSdsmNowhere()
{
    mat4 m;
    m[0] = vec4(0.0f);
    m[1] = vec4(0.0f);
    m[2] = vec4(0.0f);
    m[3] = vec4(0.0f, 0.0f, 0.0f, -1.0f);
    return m;
}

// lightClipFromLocal of the map that holds the bounds, in the executors' convention, for its rectangle of the atlas.
LX_FN mat4 lxSdsmMatrix(SdsmSetup setup, SdsmBounds bounds, float nearestCaster, vec4 rectangle)
{
    float halfX = lxSdsmHalf(bounds.onPlane.x, bounds.onPlane.z, bounds.termsX);
    float halfY = lxSdsmHalf(bounds.onPlane.y, bounds.onPlane.w, bounds.termsY);
    vec4 centreX = vec4(0.0f, 0.0f, 0.0f, 0.5f * (bounds.onPlane.x + bounds.onPlane.z));
    vec4 centreY = vec4(0.0f, 0.0f, 0.0f, 0.5f * (bounds.onPlane.y + bounds.onPlane.w));
    vec4 x = (1.0f / halfX) * (setup.lightX - centreX);
    vec4 y = (1.0f / halfY) * (setup.lightY - centreY);

    // As place(): the longer side along the rectangle's, by a turn, and room for the lookup's reach.
    float width = rectangle.z - rectangle.x;
    float height = rectangle.w - rectangle.y;
    if ((width > height && halfX < halfY) || (width < height && halfX > halfY)) {
        vec4 turned = x;
        x = y;
        y = -1.0f * turned;
    }
    x = max(1.0f - 2.0f * setup.regions.w / width, 1.0f / width) * x;
    y = max(1.0f - 2.0f * setup.regions.w / height, 1.0f / height) * y;

    float nearest = min(nearestCaster, bounds.farthest);
    float room = max(1.0e-6f * (bounds.farthest - nearest), LX_SDSM_ROOM * (abs(bounds.farthest) + abs(nearest)));
    float begin = nearest - room;
    float end = bounds.farthest + room;
    vec4 z = (1.0f / max(end - begin, 1.0e-30f)) * (vec4(0.0f, 0.0f, 0.0f, end) - setup.lightDepth);
    mat4 m;
    m[0] = vec4(x.x, y.x, z.x, 0.0f);
    m[1] = vec4(x.y, y.y, z.y, 0.0f);
    m[2] = vec4(x.z, y.z, z.z, 0.0f);
    m[3] = vec4(x.w, y.w, z.w, 1.0f);
    return m;
}

LX_SHARED_END

#endif
