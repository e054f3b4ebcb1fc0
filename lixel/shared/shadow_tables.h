// SPDX-License-Identifier: MIT
// The tables of a frame's plan, read by C++ and by GLSL. mat4, vec4 and arrays of them only, so that std430 is C++'s layout.
#ifndef LIXEL_SHARED_SHADOW_TABLES_H
#define LIXEL_SHARED_SHADOW_TABLES_H
#include "lixel/shared/glsl.h"

LX_SHARED_BEGIN

// How a texture warp's functions stand in the table of knots (lixel/shared/warp.h).
const float LX_WARP_NONE = 0.0f;
const float LX_WARP_RECTILINEAR = 1.0f;  // one function for all rows, one for all columns
const float LX_WARP_NEAREST = 2.0f;      // one a row and one a column; a point takes those of its row and its column
const float LX_WARP_INTERPOLATED = 3.0f; // it takes those between the middles of the nearest two
struct ShadowWarp
{
    vec4 kind; // x: one of these; yzw: 0
    vec4 grid; // x: first knot of the rows' functions; y: columns; z: rows; w: first knot of the columns' functions
    vec4
        square; // least and greatest x, y, in lixels of the layer, of the square that is warped: the rectangle without guard bands
};

// What follows on a region's matrix: division by w, or a paraboloid (lixel/shared/paraboloid.h).
const float LX_PROJECTION_MATRIX = 0.0f;
const float LX_PROJECTION_PARABOLOID = 1.0f;

// One region's way from Local space into its rectangle of the atlas.
struct ShadowRegion
{
    mat4
        lightClipFromLocal; // NDC x, y in [-1, +1]; depth reversed, 1 at the near side, 0 at the far; inside where w > 0
    mat4 lightClipLow;      // what rounding to float took from it: the sum has the digits of a double
    vec4 lixelFromNdc;      // lixel = xy * ndc + zw: continuous, counted in its layer of the atlas, centres at + 1/2
    vec4 rectangle;         // first lixel x, y and end x, y (not included) that the region owns in its layer
    vec4 serves; // the part of it where receivers are served: the guard band is the next region's, where one follows
    vec4
        place; // x: layer; y, z: first and count of its half-spaces; w: 1 where points are to be taken through the matrix in double
    // (lxLightClip in light_clip.h), else 0
    // Of a map whose lixels are the pixels of a plane; else 0. Local, unit normal towards the light. At the height h above it, depth is
    // planeDepth.x + planeDepth.y (lixel x - lixelFromNdc.z) + planeDepth.z (lixel y - lixelFromNdc.w) + planeDepth.w h / w
    // with the w of lightClipFromLocal.
    vec4 plane;
    vec4 planeDepth;
    vec4
        projection; // x: one of the two; y: of a paraboloid, what is taken off depths; z: bend of depths (lookup/even_depth.h); w: 0
    ShadowWarp warp; // after that; lixelFromNdc counts unwarped lixels. Every paraboloid has one, if only the identity
};

// One light: which regions serve it, in their order.
struct ShadowLight
{
    vec4 regions; // x, y: first and count; z: 1 where the light has a map, 0 where its plan was refused; w: 0
};

LX_SHARED_END

#endif
