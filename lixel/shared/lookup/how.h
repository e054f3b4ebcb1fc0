// SPDX-License-Identifier: MIT
// How a lookup decides: what lixels hold, where it taps and how it tests. Read by C++ and by GLSL.
#ifndef LIXEL_SHARED_LOOKUP_HOW_H
#define LIXEL_SHARED_LOOKUP_HOW_H
#include "lixel/shared/glsl.h"

LX_SHARED_BEGIN

// What a lixel holds.
const int LX_STORE_DEPTH = 0;    // the map's own depth
const int LX_STORE_DEPTHS32 = 1; // up to 4 depths of 32 bits, of the lixel and its neighbours (stored_depths.h)
const int LX_STORE_DEPTHS16 = 2; // up to 8 of 16 bits
const int LX_STORE_DEPTHS8 = 3;  // 4 of 8 bits: the lixel's, and those right, above and both
const int LX_STORE_VSM = 4;      // moments (moments.h)
const int LX_STORE_EVSM2 = 5;
const int LX_STORE_EVSM4 = 6;
const int LX_STORE_MSM = 7;

// Which neighbours' depths are kept beside the lixel's own.
const int LX_SELECT_MAX = 0; // the farthest
const int LX_SELECT_MIN = 1; // the nearest
const int LX_SELECT_MINMAX = 2;
const int LX_SELECT_SORTED = 3; // of all in order, in groups of equal number, the middle of each

// Where taps lie.
const int LX_KERNEL_GRID = 0; // a square grid, one lixel apart
const int LX_KERNEL_ROTATED = 1;
const int LX_KERNEL_JITTERED = 2;
const int LX_KERNEL_BILINEAR = 3; // the four lixels around, by their areas, then rounded
const int LX_KERNEL_HARDWARE = 4; // the same not rounded, all four against one depth, as texture units do it

struct LxLookup
{
    int store;
    int depths;    // of a lixel
    int selection; // where there are neighbours'
    int around;    // neighbours are so many lixels away at most: 1 or 2
    int kernel;
    int side;        // taps of a side of the grid
    int isDualPlane; // 1: only what lies behind the stored lixel's own plane is in shadow
    int blur;        // of moments: lixels of a side, odd
};

// Of one depth a lixel and a regular grid of taps.
LX_FN LxLookup lxOneDepth(int side)
{
    LxLookup how;
    how.store = LX_STORE_DEPTH;
    how.depths = 1;
    how.selection = LX_SELECT_MAX;
    how.around = 1;
    how.kernel = LX_KERNEL_GRID;
    how.side = side;
    how.isDualPlane = 0;
    how.blur = 1;
    return how;
}

LX_FN bool lxHasMoments(LxLookup how) { return how.store >= LX_STORE_VSM; }

LX_SHARED_END

#endif
