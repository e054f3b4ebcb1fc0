// SPDX-License-Identifier: MIT
// How lookups reach what lixels hold. The includer provides it: in GLSL these functions before any file of this folder, as far as its
// lookup asks them; in C++ an object with members of the names on the right, the template argument Map.
//
//   float   lxStoredDepth(int x, int y, int layer)             depth      of the map itself: 1 near, 0 far and empty
//   LxWords lxStoredWords(int x, int y, int layer)             words      several depths (stored_depths.h)
//   uint    lxStoredGradient(int x, int y, int layer)          gradient   slope of the surface stored there (gradient.h)
//   vec4    lxStoredMoments(int x, int y, int layer)           moments    (moments.h)
//   float   lxHardwareLit(vec2 lixel, int layer, float depth)  hardwareLit the four lixels around, by their areas: the share of those
//                                                              whose depth is not above `depth`
//   float   lxWarpKnot(int i)                                  knots       a callable: knots of warps (warp.h)
//
// GLSL that has one depth a lixel and nothing else defines LX_ONE_DEPTH, and only the first is asked.
#ifndef LIXEL_SHARED_LOOKUP_MAPS_H
#define LIXEL_SHARED_LOOKUP_MAPS_H
#include "lixel/shared/lookup/stored_depths.h"

#ifdef __cplusplus
#define LX_MAP_FN template <typename Map>
#define LX_MAP , const Map& lxMap
#define LX_PASS_MAP , lxMap
#define LX_STORED_DEPTH lxMap.depth
#define LX_STORED_WORDS lxMap.words
#define LX_STORED_GRADIENT lxMap.gradient
#define LX_STORED_MOMENTS lxMap.moments
#define LX_HARDWARE_LIT lxMap.hardwareLit
#define LX_PASS_MAP_KNOTS , lxMap.knots
#else
#define LX_MAP_FN
#define LX_MAP
#define LX_PASS_MAP
#define LX_STORED_DEPTH lxStoredDepth
#define LX_STORED_WORDS lxStoredWords
#define LX_STORED_GRADIENT lxStoredGradient
#define LX_STORED_MOMENTS lxStoredMoments
#define LX_HARDWARE_LIT lxHardwareLit
#define LX_PASS_MAP_KNOTS
#endif

#endif
