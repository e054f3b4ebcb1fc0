// SPDX-License-Identifier: MIT
// Several depths in one lixel, each with the neighbour that it came from: how they are packed and read, one text for the CPU
// executor and for GLSL.
//
//   C. Pagot, J. Comba, M. Oliveira. Multiple-Depth Shadow Maps. SIBGRAPI 2004, sections 4.2 to 4.4.
//
// A neighbour's depth must be compared with the receiver's plane at that neighbour, or every slope is darkened. So depths keep their
// place: a number from 0 to 24, row by row over the 5x5 lixels around, kLxOwnPlace in their middle.
//
//   32 bits   a word a depth, the place in its last 5 bits: a depth is so moved away from the light by less than 2^-18 of
//             itself. The lixel's own depth comes first and is kept whole.
//   16 bits   two a word, the lixel's own first, then the others by their places, which are the bits of the last word (the
//             fourth; a fifth word where there are more than six depths). Steps of 1/65535 of even depth (even_depth.h), rounded away
//             from the light by at most one.
//   8 bits    four in one word (S. Brabec, H.-P. Seidel. Hardware-accelerated Rendering of Antialiased Shadows with Shadow Maps. CGI
//             2001): the lixel's own, and those to the right, above and both. As that, of 1/255.
//
// Depths are reversed: 1 near, 0 far and empty. Rounding away from the light can only take a shadow away.
#ifndef LIXEL_SHARED_STORED_DEPTHS_H
#define LIXEL_SHARED_STORED_DEPTHS_H
#include "lixel/shared/lookup/even_depth.h"
#include "lixel/shared/lookup/how.h"

LX_SHARED_BEGIN

const int kLxMostDepths = 8;
const int kLxOwnPlace = 12;
const uint kLxPlaceBits = 31u;

// What one lixel holds, as the textures do.
struct LxWords
{
    uvec4 words;
    uint more; // of 16 bits and more than six depths
};

// Steps of unsigned fixed-point even depth, never nearer than it is; a fiftieth of a step is for what rounds on the way.
LX_FN uint lxFixedDepth(float bend, float depth, float steps)
{
    return uint(clamp(lxEvenDepth(bend, depth) * steps - 0.02f, 0.0f, steps));
}
LX_FN float lxDepthOfFixed(float bend, uint fixedDepth, float steps)
{
    return lxDepthOfEven(bend, float(fixedDepth) / steps);
}

LX_FN int lxPlaceOf(int dx, int dy) { return (dy + 2) * 5 + dx + 2; }
LX_FN vec2 lxOffsetOfPlace(int place)
{
    int row = place / 5;
    return vec2(float(place - 5 * row - 2), float(row - 2));
}

// A neighbour's depth of 32 bits with its place.
LX_FN uint lxPackedDepth(float depth, int place) { return (floatBitsToUint(depth) & ~kLxPlaceBits) | uint(place); }

// One of the depths of a lixel.
struct LxStored
{
    float depth;
    int place;
};

// Number `i` of them; its own is number 0. Of 16 bits the others are read in turn, and `left` are the places of those that have not
// been read: where there are none left, the rest is the own depth again.
LX_FN LxStored lxStoredAt(LxLookup how, float bend, LxWords lixel, int i, uint left)
{
    LxStored stored;
    stored.place = kLxOwnPlace;
    if (how.store == LX_STORE_DEPTHS16) {
        uint pair = lixel.words[i / 2];
        stored.depth = lxDepthOfFixed(bend, (i % 2 == 0 ? pair : pair >> 16u) & 65535u, 65535.0f);
        if (i > 0 && left != 0u) stored.place = findLSB(left);
    } else if (how.store == LX_STORE_DEPTHS8) {
        stored.depth = lxDepthOfFixed(bend, (lixel.words.x >> uint(8 * i)) & 255u, 255.0f);
        stored.place = lxPlaceOf(i % 2, i / 2);
    } else {
        uint bits = lixel.words[i];
        stored.depth = uintBitsToFloat(i == 0 ? bits : bits & ~kLxPlaceBits);
        if (i > 0) stored.place = int(bits & kLxPlaceBits);
    }
    return stored;
}

// The places of a lixel's depths of 16 bits, its own not among them.
LX_FN uint lxPlacesOf(LxLookup how, LxWords lixel) { return how.depths > 6 ? lixel.more : lixel.words.w; }

LX_SHARED_END

#endif
