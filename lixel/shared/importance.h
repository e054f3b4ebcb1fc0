// SPDX-License-Identifier: MIT
// How much a sample counts when a warp shares out lixels: one text for C++ and for GLSL.
//
//   P. Rosen. Rectilinear Texture Warping for Fast Adaptive Shadow Mapping. 2012; T. Milet et al. 2015, sections 2.2 and 3.
//
//   Differs  the papers name their functions and show pictures of them; the formulas are ours. Each weight is within [0, 1], so
//            that they can be multiplied.
#ifndef LIXEL_SHARED_IMPORTANCE_H
#define LIXEL_SHARED_IMPORTANCE_H
#include "lixel/shared/glsl.h"

LX_SHARED_BEGIN

// Importance maps hold integers, which atomics add up to the same sum in any order: a sample of weight 1 counts as so many. In 32
// bits a lixel has room for 16 million samples.
const float LX_IMPORTANCE_UNIT = 256.0f;

// Samples away from what a weight looks for count for so much of those at it.
const float LX_AWAY_FROM_EDGES = 0.1f;
const float LX_AWAY_FROM_BOUNDARIES = 0.05f;
// Cosine of the angle between neighbours' normals from where on a surface has an edge between them.
const float LX_EDGE_COSINE = 0.9f;

// A piece of surface is seen in fewer pixels, along each axis, the farther away it is.
LX_FN float lxDistanceWeight(float nearest2, float distance2)
{
    return distance2 > nearest2 ? sqrt(nearest2 / distance2) : 1.0f;
}

// It is seen in more pixels the more it faces the eye, and lies in fewer lixels the less it faces the light.
LX_FN float lxNormalWeight(float cosineToEye, float cosineToLight)
{
    const float least = 0.125f; // beyond, its lixels are as wide as they get
    return least * clamp(cosineToEye, 0.0f, 1.0f) / clamp(cosineToLight, least, 1.0f);
}

// What a weight is in the map; every sample counts for something.
LX_FN float lxImportanceUnits(float weight)
{
    float units = floor(weight * LX_IMPORTANCE_UNIT + 0.5f);
    return units > 1.0f ? units : 1.0f; // also where a sample at the eye has no direction to it
}

LX_SHARED_END

#endif
