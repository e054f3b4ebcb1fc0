// SPDX-License-Identifier: MIT
// What one tapped lixel says of a receiver: the share of its depths that shadow it. One text for the CPU executor and for GLSL.
//
//   C. Pagot, J. Comba, M. Oliveira. Multiple-Depth Shadow Maps. SIBGRAPI 2004, section 4.2.
//
// The n-shadow test: s/n, s the number of stored depths before the receiver. (The paper's own words, with its order of the depths, make
// whatever is behind the nearest one fully dark; its Figure 4 does not.) Each depth is compared with the receiver's plane at the
// lixel that it came from, and not with one depth for all: then a plane alone is lit at any slope. What order gives in the paper is
// kept towards the lixel's own depth: where that shadows, so does every nearer one, and where it does not, no farther one. So
// `max` never darkens what the own depth calls lit, and the order in which depths are stored is nothing.
#ifndef LIXEL_SHARED_LOOKUP_COVERAGE_H
#define LIXEL_SHARED_LOOKUP_COVERAGE_H
#include "lixel/shared/lookup/dual_plane.h"

LX_SHARED_BEGIN

// Whether a depth that was stored for the lixel with this corner shadows the receiver.
LX_MAP_FN bool lxShadows(LxLookup how, ShadowRegion region, LxReceiver r, vec2 corner, float stored LX_MAP)
{
    vec2 centre = vec2(corner.x + 0.5f, corner.y + 0.5f);
    if (how.isDualPlane != 0) r.margin = min(r.margin, LX_DUAL_RECEIVER);
    if (!(stored > lxShadowingDepth(r, centre LX_PASS_MAP_KNOTS))) return false;
#ifndef LX_ONE_DEPTH
    if (how.isDualPlane != 0) {
        uint gradient = LX_STORED_GRADIENT(int(corner.x), int(corner.y), int(region.place.x));
        float depth = lxPlaneDepth(r, r.lixel LX_PASS_MAP_KNOTS);
        return lxIsBehindStored(r, depth, centre, stored, lxUnpackedGradient(gradient));
    }
#endif
    return true;
}

#ifndef LX_ONE_DEPTH

// Several depths of the lixel with this corner.
LX_MAP_FN float lxCoverageOfDepths(LxLookup how, ShadowRegion region, LxReceiver r, vec2 corner LX_MAP)
{
    LxWords lixel = LX_STORED_WORDS(int(corner.x), int(corner.y), int(region.place.x));
    LxStored own = lxStoredAt(how, region.projection.z, lixel, 0, 0u);
    bool isOwn = lxShadows(how, region, r, corner, own.depth LX_PASS_MAP);
    float shadowing = isOwn ? 1.0f : 0.0f;
    bool isOrdered = how.store != LX_STORE_DEPTHS8;
    uint left = lxPlacesOf(how, lixel);
    for (int i = 1; i < how.depths; ++i) {
        LxStored other = lxStoredAt(how, region.projection.z, lixel, i, left);
        left &= left - 1u;
        bool isSameAsOwn = isOrdered && (other.place == kLxOwnPlace || (other.depth >= own.depth) == isOwn);
        bool isShadowing = isOwn;
        if (!isSameAsOwn) {
            vec2 offset = lxOffsetOfPlace(other.place);
            vec2 from = vec2(corner.x + offset.x, corner.y + offset.y);
            isShadowing = lxShadows(how, region, r, from, other.depth LX_PASS_MAP);
        }
        shadowing += isShadowing ? 1.0f : 0.0f;
    }
    return shadowing / float(how.depths);
}
#endif

LX_MAP_FN float lxCoverage(LxLookup how, ShadowRegion region, LxReceiver r, vec2 corner LX_MAP)
{
#ifndef LX_ONE_DEPTH
    if (how.store != LX_STORE_DEPTH) return lxCoverageOfDepths(how, region, r, corner LX_PASS_MAP);
#endif
    float stored = LX_STORED_DEPTH(int(corner.x), int(corner.y), int(region.place.x));
    return lxShadows(how, region, r, corner, stored LX_PASS_MAP) ? 1.0f : 0.0f;
}

LX_SHARED_END

#endif
