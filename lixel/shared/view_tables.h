// SPDX-License-Identifier: MIT
// What the passes over a view read and write: surfaces, the view's rays and its samples. Read by C++ and by GLSL; scalars
// stand where they fill a vector up, so that std140 and std430 are C++'s layout.
#ifndef LIXEL_SHARED_VIEW_TABLES_H
#define LIXEL_SHARED_VIEW_TABLES_H
#include "lixel/shared/glsl.h"

LX_SHARED_BEGIN

#ifdef __cplusplus
struct alignas(32) dvec4
{
    double x = 0, y = 0, z = 0, w = 0;
};
#endif

// One material (std430).
struct SurfaceMaterial
{
    vec4 baseColour; // linear
    vec3 emission;
    float alphaCutoff; // 0 where opaque
};

// The rays through a view's pixel centres (std140). With NDC x, y of a centre, a point of the ray is
// rayOrigin[0] + x * rayOrigin[1] + y * rayOrigin[2], and its direction likewise: neither unit nor of a certain sign.
struct ViewRays
{
    dvec4 rayOrigin[3];
    dvec4 rayDirection[3];
    dvec4 clipW;    // the row of the matrix that gives w
    dvec4 eyeLocal; // a point (w = 1), or the direction towards the eye (w = 0)
};

// One view sample (std430). `pixel` is y * width + x; in a list with an entry a pixel, kNoPixel marks those without surface.
const uint kNoPixel = 0xffffffffu;
struct ViewPoint
{
    vec3 positionLocal;
    uint pixel;
    vec3 normal;   // geometric, unit, turned to the eye
    uint triangle; // of the casters as they were given, or 0xffffffff
};

LX_SHARED_END

#endif
