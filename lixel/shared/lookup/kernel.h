// SPDX-License-Identifier: MIT
// Where the taps of a lookup lie around a receiver: one text for the CPU executor and for GLSL.
#ifndef LIXEL_SHARED_LOOKUP_KERNEL_H
#define LIXEL_SHARED_LOOKUP_KERNEL_H
#include "lixel/shared/lookup/how.h"
#include "lixel/shared/shadow_tables.h"

LX_SHARED_BEGIN

// A number that belongs to a word: PCG-RXS-M-XS (M. O'Neill. PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms
// for Random Number Generation. 2014), as a hash.
LX_FN uint lxDiced(uint word)
{
    uint state = word * 747796405u + 2891336453u;
    uint mixed = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (mixed >> 22u) ^ mixed;
}

// Of a surface point. Its position is the same to the bit in every executor, which its place in the light image is not.
LX_FN uint lxSeedOf(vec3 positionLocal)
{
    uint seed = lxDiced(floatBitsToUint(positionLocal.x));
    seed = lxDiced(seed ^ floatBitsToUint(positionLocal.y));
    return lxDiced(seed ^ floatBitsToUint(positionLocal.z));
}

// In [0, 1).
LX_FN float lxUnit(uint word) { return float(word >> 8u) * 5.9604645e-8f; }

// A place in lixels from the receiver, turned about it by an angle of the receiver's, which is less than a right one, since that maps
// a square onto itself; t is the tangent of half of it.
LX_FN vec2 lxTurned(vec2 place, uint seed)
{
    float t = lxUnit(seed);
    float perT = 1.0f / (1.0f + t * t);
    float cosine = (1.0f - t * t) * perT;
    float sine = 2.0f * t * perT;
    return vec2(cosine * place.x - sine * place.y, sine * place.x + cosine * place.y);
}

// Tap (i, j) of a grid of `side` by `side`, in lixels from the receiver. Rotated: the whole grid is turned. Jittered: each tap anywhere in
// its own square.
LX_FN vec2 lxTap(LxLookup how, int i, int j, uint seed)
{
    float first = -0.5f * float(how.side - 1);
    float x = first + float(i);
    float y = first + float(j);
    if (how.kernel == LX_KERNEL_ROTATED) return lxTurned(vec2(x, y), seed);
    if (how.kernel == LX_KERNEL_JITTERED) {
        uint one = lxDiced(seed + uint(j * how.side + i));
        return vec2(x + lxUnit(one) - 0.5f, y + lxUnit(lxDiced(one)) - 0.5f);
    }
    return vec2(x, y);
}

// The corner of the lixel at a place, of those that the region owns. Where a lixel holds its neighbours to the right and above too, the
// last one is one earlier.
LX_FN vec2 lxCornerWithin(LxLookup how, ShadowRegion region, float x, float y)
{
    float last = how.store == LX_STORE_DEPTHS8 ? 2.0f : 1.0f;
    return vec2(clamp(floor(x), region.rectangle.x, region.rectangle.z - last),
                clamp(floor(y), region.rectangle.y, region.rectangle.w - last));
}

LX_SHARED_END

#endif
