// SPDX-License-Identifier: MIT
// Which depths a lixel keeps of its neighbours', one text for the CPU executor and for GLSL.
//
//   C. Pagot, J. Comba, M. Oliveira. Multiple-Depth Shadow Maps. SIBGRAPI 2004, section 4.3.
//
//   max, min, minmax   the farthest, the nearest or both of all q lixels around, its own among them; where lixels are alike, its own
//   sorted             all q in order, nearest first, in n groups as equal as whole numbers are, the middle of each (the nearer of
//                      two); in the group that has the lixel's own, its own
//
// The lixel's own depth is always kept. Neighbours end at the region's rectangle; where there are fewer than n, its own stands for the
// rest. Empty lixels are as far as can be.
#ifndef LIXEL_SHARED_SELECT_DEPTHS_H
#define LIXEL_SHARED_SELECT_DEPTHS_H
#include "lixel/shared/lookup/maps.h"

LX_SHARED_BEGIN

const int kLxPlaces = 25;

LX_FN bool lxOwns(vec4 rectangle, int x, int y)
{
    return x >= int(rectangle.x) && x < int(rectangle.z) && y >= int(rectangle.y) && y < int(rectangle.w);
}

// A depth of the map and its place.
struct LxPlaced
{
    float depth;
    int place;
};

// The farthest (sign 1) or nearest (sign -1) of a lixel and its neighbours.
LX_MAP_FN LxPlaced lxExtreme(LxLookup how, vec4 rectangle, int x, int y, int layer, float sign LX_MAP)
{
    LxPlaced best;
    best.depth = LX_STORED_DEPTH(x, y, layer);
    best.place = kLxOwnPlace;
    for (int dy = -how.around; dy <= how.around; ++dy) {
        for (int dx = -how.around; dx <= how.around; ++dx) {
            if (!lxOwns(rectangle, x + dx, y + dy)) continue;
            float depth = LX_STORED_DEPTH(x + dx, y + dy, layer);
            if (sign * depth < sign * best.depth) {
                best.depth = depth;
                best.place = lxPlaceOf(dx, dy);
            }
        }
    }
    return best;
}

// max, min and minmax.
LX_MAP_FN LxWords lxPackedExtremes(LxLookup how, vec4 rectangle, int x, int y, int layer LX_MAP)
{
    float own = LX_STORED_DEPTH(x, y, layer);
    LxWords lixel;
    lixel.words = uvec4(floatBitsToUint(own), 0u, 0u, 0u);
    lixel.more = 0u;
    if (how.selection != LX_SELECT_MIN) {
        LxPlaced farthest = lxExtreme(how, rectangle, x, y, layer, 1.0f LX_PASS_MAP);
        lixel.words.y = lxPackedDepth(farthest.depth, farthest.place);
    }
    if (how.selection == LX_SELECT_MAX) return lixel;
    LxPlaced nearest = lxExtreme(how, rectangle, x, y, layer, -1.0f LX_PASS_MAP);
    uint nearestPacked = lxPackedDepth(nearest.depth, nearest.place);
    if (how.selection == LX_SELECT_MIN) lixel.words.y = nearestPacked;
    else lixel.words.z = nearestPacked;
    return lixel;
}

// The map around a lixel, by places; `there` has a bit for each that the region owns and the neighbourhood reaches.
struct LxNeighbours
{
    float depth[25];
    uint there;
};

LX_MAP_FN LxNeighbours lxNeighbours(LxLookup how, vec4 rectangle, int x, int y, int layer LX_MAP)
{
    LxNeighbours n;
    n.there = 0u;
    for (int place = 0; place < kLxPlaces; ++place) n.depth[place] = 0.0f;
    for (int dy = -how.around; dy <= how.around; ++dy) {
        for (int dx = -how.around; dx <= how.around; ++dx) {
            if (!lxOwns(rectangle, x + dx, y + dy)) continue;
            int place = lxPlaceOf(dx, dy);
            n.depth[place] = LX_STORED_DEPTH(x + dx, y + dy, layer);
            n.there |= 1u << uint(place);
        }
    }
    return n;
}

// How many come before it, nearest first.
LX_FN int lxRank(LxNeighbours n, int place)
{
    int before = 0;
    for (int other = 0; other < kLxPlaces; ++other) {
        bool isThere = (n.there >> uint(other) & 1u) != 0u;
        bool isBefore = n.depth[other] > n.depth[place] || (n.depth[other] == n.depth[place] && other < place);
        before += isThere && isBefore ? 1 : 0;
    }
    return before;
}

// The places that `sorted` takes, but for its own.
LX_FN uint lxSortedPlaces(LxNeighbours n, int depths)
{
    int all = bitCount(n.there);
    int groups = min(depths, all);
    int ownGroup = ((lxRank(n, kLxOwnPlace) + 1) * groups - 1) / all;
    uint taken = 0u;
    for (int place = 0; place < kLxPlaces; ++place) {
        if ((n.there >> uint(place) & 1u) == 0u) continue;
        int rank = lxRank(n, place);
        int group = ((rank + 1) * groups - 1) / all;
        int middle = (group * all / groups + (group + 1) * all / groups - 1) / 2;
        if (group != ownGroup && rank == middle) taken |= 1u << uint(place);
    }
    return taken;
}

LX_FN LxWords lxPacked32(LxLookup how, LxNeighbours n)
{
    LxWords lixel;
    uint rest = lxPackedDepth(n.depth[kLxOwnPlace], kLxOwnPlace);
    lixel.words = uvec4(floatBitsToUint(n.depth[kLxOwnPlace]), rest, rest, rest);
    lixel.more = 0u;
    uint left = lxSortedPlaces(n, how.depths);
    for (int i = 1; i < how.depths && left != 0u; ++i) {
        int place = findLSB(left);
        left &= left - 1u;
        lixel.words[i] = lxPackedDepth(n.depth[place], place);
    }
    return lixel;
}

LX_FN LxWords lxPacked16(LxLookup how, float bend, LxNeighbours n)
{
    LxWords lixel;
    uint places = lxSortedPlaces(n, how.depths);
    uint left = places;
    lixel.words = uvec4(lxFixedDepth(bend, n.depth[kLxOwnPlace], 65535.0f), 0u, 0u, 0u);
    for (int i = 1; i < how.depths && left != 0u; ++i) {
        uint depth = lxFixedDepth(bend, n.depth[findLSB(left)], 65535.0f);
        left &= left - 1u;
        lixel.words[i / 2] |= i % 2 == 0 ? depth : depth << 16u;
    }
    lixel.more = places;
    if (how.depths <= 6) lixel.words.w = places;
    return lixel;
}

// Of Brabec and Seidel: at the border of the rectangle the last lixels again.
LX_MAP_FN LxWords lxPacked8(vec4 rectangle, float bend, int x, int y, int layer LX_MAP)
{
    LxWords lixel;
    lixel.words = uvec4(0u, 0u, 0u, 0u);
    lixel.more = 0u;
    for (int i = 0; i < 4; ++i) {
        int tapX = min(x + i % 2, int(rectangle.z) - 1);
        int tapY = min(y + i / 2, int(rectangle.w) - 1);
        lixel.words.x |= lxFixedDepth(bend, LX_STORED_DEPTH(tapX, tapY, layer), 255.0f) << uint(8 * i);
    }
    return lixel;
}

// What lixel (x, y) of a region with this rectangle and bend of depths holds, from the map.
LX_MAP_FN LxWords lxPackedDepths(LxLookup how, vec4 rectangle, float bend, int x, int y, int layer LX_MAP)
{
    if (how.store == LX_STORE_DEPTHS8) return lxPacked8(rectangle, bend, x, y, layer LX_PASS_MAP);
    if (how.selection != LX_SELECT_SORTED) return lxPackedExtremes(how, rectangle, x, y, layer LX_PASS_MAP);
    LxNeighbours n = lxNeighbours(how, rectangle, x, y, layer LX_PASS_MAP);
    if (how.store == LX_STORE_DEPTHS16) return lxPacked16(how, bend, n);
    return lxPacked32(how, n);
}

LX_SHARED_END

#endif
