// SPDX-License-Identifier: MIT
// The test of a receiver against the plane of the surface that a lixel holds: one text for the CPU executor and for GLSL.
//
// Where a stored depth is nearer than the receiver's plane, the receiver is in shadow only if it lies behind the stored surface's plane,
// too. On a body that bends towards the light the two facets, its own and the stored one, do not both say so.
#ifndef LIXEL_SHARED_LOOKUP_DUAL_PLANE_H
#define LIXEL_SHARED_LOOKUP_DUAL_PLANE_H
#include "lixel/shared/lookup.h"
#include "lixel/shared/lookup/gradient.h"

LX_SHARED_BEGIN

// With a test against the stored plane too, either may be closer than it could be alone: lixels of the receiver's slope that a stored
// depth must be nearer by, and lixels of the stored slope that the receiver must lie behind the stored plane by.
const float LX_DUAL_RECEIVER = 0.109375f;
const float LX_DUAL_STORED = 0.35f;
// Whether a receiver of this depth at its own place lies behind the plane of the surface that is stored, with this slope, for the lixel with
// its centre at `centre`.
LX_FN bool lxIsBehindStored(LxReceiver r, float depth, vec2 centre, float stored, vec2 gradient)
{
    vec2 away = vec2(r.lixel.x - centre.x, r.lixel.y - centre.y);
    float storedHere = stored + gradient.x * away.x + gradient.y * away.y;
    float rounding = LX_SLOPE_ROUNDING * (abs(gradient.x * away.x) + abs(gradient.y * away.y));
    float margin = LX_DUAL_STORED * (abs(gradient.x) + abs(gradient.y));
    return storedHere > depth + margin + rounding + r.slack;
}

LX_SHARED_END

#endif
