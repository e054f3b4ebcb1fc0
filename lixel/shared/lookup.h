// SPDX-License-Identifier: MIT
// A receiver in the light image, and the depth of its plane where a lookup taps: one text for the CPU executor and for GLSL. What
// stored values then say of it is lookup/visibility.h.
//
// The includer provides the knots of warps (warp.h). Where no region has a warp, GLSL may define LIXEL_NO_WARP, and where none is on a
// paraboloid, LIXEL_NO_PARABOLOID: drivers that run both sides of a branch then spend nothing on it.
#ifndef LIXEL_SHARED_LOOKUP_H
#define LIXEL_SHARED_LOOKUP_H
#include "lixel/shared/light_clip.h"
#include "lixel/shared/paraboloid.h"
#include "lixel/shared/warp.h"

#if defined(LIXEL_NO_WARP) && !defined(LIXEL_NO_PARABOLOID)
#define LIXEL_NO_PARABOLOID // each of them has a warp
#endif

LX_SHARED_BEGIN

// A receiver in the light image.
struct LxReceiver
{
    vec2 lixel;         // continuous, warped: where it is in the map
    vec2 unwarped;      // the same before the warp
    vec2 at;            // continuous, unwarped lixel of `depth`: its own, but for what lies on the region's plane
    float depth;        // reversed: 1 near, 0 far
    vec2 depthPerLixel; // of the receiver's plane, which is linear in unwarped lixels, but on a paraboloid
    vec2 steepness;     // what its depth changes by over a lixel of the map, along x and along y; not below 0
    float margin;       // lixels of the map that a stored depth must be nearer by
    float isOnPlane;    // 1 on the plane that the region's lixels are the pixels of, else 0
    float slack;        // depth that rounding may have moved the receiver or the map by
    float slackBeside;  // further slack for taps of other lixels: what is called one plane may be a little rough
    float isInside;     // 1 where the region serves it and before its far side, else 0
    ShadowWarp warp;    // the region's
    // On a paraboloid, where the plane's depth is linear in rays: the receiver's own, depth by ray, and lixelFromNdc, by which a lixel's
    // ray is found. Elsewhere 0.
    vec3 ray;
    vec3 depthPerRay;
    vec4 lixelFromPlace;
};

// Rounding of one float product and sum, with room for the matrix, the point and the rasterizer's interpolation.
const float LX_ROUNDING = 6.0e-7f;
// Lixels by which a rasterizer moves vertices when it snaps them to its grid of 1/256, and as much for its own rounding.
const float LX_SNAP = 0.0078125f;
// Half a lixel: from a lixel's centre, where the stored depth was taken, to its border.
const float LX_HALF_LIXEL = 0.5f;

// Radians between normals of one plane.
const float LX_SAME_NORMAL = 1.0e-3f;
// Rounding of a height above a plane and of a depth on it, against their terms: of the numbers, three products and three sums.
const float LX_PLANE_ROUNDING = 2.4e-7f;

LX_FN vec3 lxAnyPerpendicular(vec3 n)
{
    vec3 other = abs(n.x) < 0.6f ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 1.0f, 0.0f);
    return normalize(cross(n, other));
}

// Whether the point is on the side of a half-space that belongs to a region; a region is where all of its own hold. On its border, but
// for what rounding may do, counts as inside: of two regions that share a border the first one serves it, and none loses it.
LX_FN bool lxHolds(vec4 halfSpace, vec3 positionLocal)
{
    float x = halfSpace.x * positionLocal.x;
    float y = halfSpace.y * positionLocal.y;
    float z = halfSpace.z * positionLocal.z;
    return x + y + z + halfSpace.w >= -LX_ROUNDING * (abs(x) + abs(y) + abs(z) + abs(halfSpace.w));
}

// Moves a receiver to its place in a warped map. Rounding: taps are taken back to unwarped lixels by floats.
LX_KNOTS_FN LxReceiver lxWarpedReceiver(LxReceiver r LX_KNOTS)
{
    LxWarped w = lxWarpedLixel(r.warp, r.lixel LX_PASS_KNOTS);
    float area = w.alongX.x * w.alongY.y - w.alongX.y * w.alongY.x;
    vec2 g = r.depthPerLixel;
    r.steepness =
        vec2(abs(g.x * w.alongY.y - g.y * w.alongX.y) / area, abs(g.y * w.alongX.x - g.x * w.alongY.x) / area);
    r.slack += LX_ROUNDING * (abs(g.x) * r.warp.square.z + abs(g.y) * r.warp.square.w);
    r.lixel = w.at;
    return r;
}

// Edge-on to the light the plane has any depth. Depths span 1, so half a lixel of such a slope clears everything; taps must
// not take that back by slopes that were cut, so the receiver is cleared outright.
const float LX_STEEPEST = 4.0f;

// Lengths of the terms that a row's value at a point (its absolute coordinates) is the sum of.
LX_FN float lxTerms(vec4 row, vec3 p) { return abs(row.x) * p.x + abs(row.y) * p.y + abs(row.z) * p.z + abs(row.w); }

LX_FN vec4 lxRowOf(mat4 m, int row)
{
    if (row == 0) return vec4(m[0].x, m[1].x, m[2].x, m[3].x);
    if (row == 1) return vec4(m[0].y, m[1].y, m[2].y, m[3].y);
    if (row == 2) return vec4(m[0].z, m[1].z, m[2].z, m[3].z);
    return vec4(m[0].w, m[1].w, m[2].w, m[3].w);
}

// What a receiver is wherever it stands, before its region's warp and but for the region's plane.
LX_FN LxReceiver lxBeforeWarp(LxReceiver r, ShadowRegion region, bool isInside)
{
    r.unwarped = r.lixel;
    r.at = r.lixel;
    r.warp = region.warp;
    r.margin = LX_HALF_LIXEL + LX_SNAP;
    r.isOnPlane = 0.0f;
    r.slackBeside = 0.0f;
    r.isInside = isInside ? 1.0f : 0.0f;
    return r;
}

#ifndef LIXEL_NO_PARABOLOID
// The same on a paraboloid. The plane n . p = h, as the light sees it, has depth near / h (n . q) at the ray q, but for a constant.
LX_KNOTS_FN LxReceiver lxReceiveOnParaboloid(ShadowRegion region, vec3 positionLocal, vec3 normal LX_KNOTS)
{
    LxReceiver r;
    mat4 m = region.lightClipFromLocal;
    vec4 clip = lxLightClip(region, positionLocal);
    vec3 away = lxAwayFromLight(clip);
    float distance = length(away);
    vec3 ndc = lxParaboloidNdc(region, clip);
    vec2 scale = vec2(region.lixelFromNdc.x, region.lixelFromNdc.y);
    r.ray = away / distance;
    r.lixel = vec2(ndc.x * scale.x + region.lixelFromNdc.z, ndc.y * scale.y + region.lixelFromNdc.w);
    r.depth = ndc.z;

    // Along a place's x the ray moves by (1 + z) ((1, 0, -x) - x q), along y likewise.
    vec3 n = lxAwayFromLight(m * vec4(normal, 0.0f));
    float facing = dot(n, r.ray);
    float reach = 1.0f + r.ray.z;
    vec3 alongX = (vec3(1.0f, 0.0f, -ndc.x) - ndc.x * r.ray) * reach;
    vec3 alongY = (vec3(0.0f, 1.0f, -ndc.y) - ndc.y * r.ray) * reach;
    float near = clip.z / distance;
    vec2 across = vec2(near * dot(n, alongX) / scale.x, near * dot(n, alongY) / scale.y);
    bool isEdgeOn = max(abs(across.x), abs(across.y)) >= LX_STEEPEST * abs(facing);
    float perFacing = isEdgeOn ? 0.0f : 1.0f / facing;
    r.depthPerRay = n * (near * perFacing);
    r.depthPerLixel = across * perFacing;
    r.steepness = vec2(abs(r.depthPerLixel.x), abs(r.depthPerLixel.y));

    // Rounding turns the ray by `turn` of it, at the receiver, and by one part at a tap.
    vec3 p = vec3(abs(positionLocal.x), abs(positionLocal.y), abs(positionLocal.z));
    float turn = 1.0f + (lxTerms(lxRowOf(m, 0), p) + lxTerms(lxRowOf(m, 1), p) + lxTerms(lxRowOf(m, 3), p)) / distance;
    float errorZ = near * turn + region.projection.y;
    float errorRay = turn * (abs(r.depthPerRay.x) + abs(r.depthPerRay.y) + abs(r.depthPerRay.z));
    bool inside = distance > 0.0f && r.ray.z > -0.999f && r.lixel.x >= region.serves.x &&
                  r.lixel.y >= region.serves.y && r.lixel.x < region.serves.z && r.lixel.y < region.serves.w &&
                  r.depth >= -LX_ROUNDING * errorZ;
    r.slack = isEdgeOn ? LX_STEEPEST : LX_ROUNDING * (errorZ + errorRay);
    r.lixelFromPlace = region.lixelFromNdc;
    return lxWarpedReceiver(lxBeforeWarp(r, region, inside) LX_PASS_KNOTS);
}
#endif

// On the plane whose pixels the lixels are, the stored depth was taken at the sample itself, and without a caster it is the
// sample's: the plan knows that depth better than the sample's floats do, and nothing bends within the lixel.
LX_FN LxReceiver lxOnPlaneOfRegion(LxReceiver r, ShadowRegion region, vec3 positionLocal, vec3 normal, float perW)
{
    vec3 p = vec3(abs(positionLocal.x), abs(positionLocal.y), abs(positionLocal.z));
    vec3 planeNormal = vec3(region.plane.x, region.plane.y, region.plane.z);
    vec3 apart = cross(planeNormal, normal);
    float height = planeNormal.x * positionLocal.x + planeNormal.y * positionLocal.y + planeNormal.z * positionLocal.z +
                   region.plane.w;
    float roughness = LX_ROUNDING * (p.x + p.y + p.z);
    if (region.planeDepth.w > 0.0f && abs(height) <= roughness && dot(apart, apart) < LX_SAME_NORMAL * LX_SAME_NORMAL) {
        float depthPerHeight = region.planeDepth.w * perW;
        float terms =
            abs(planeNormal.x) * p.x + abs(planeNormal.y) * p.y + abs(planeNormal.z) * p.z + abs(region.plane.w);
        r.at = vec2(region.lixelFromNdc.z, region.lixelFromNdc.w);
        r.depth = region.planeDepth.x + depthPerHeight * height;
        r.depthPerLixel = vec2(region.planeDepth.y, region.planeDepth.z);
        r.steepness = vec2(abs(region.planeDepth.y), abs(region.planeDepth.z));
        float depths = abs(region.planeDepth.x) + abs(region.planeDepth.y) * region.lixelFromNdc.x +
                       abs(region.planeDepth.z) * region.lixelFromNdc.y;
        r.slack = LX_PLANE_ROUNDING * (depths + depthPerHeight * terms);
        r.slackBeside = 2.0f * depthPerHeight * roughness;
        r.margin = LX_SNAP;
        r.isOnPlane = 1.0f;
    }
    return r;
}

LX_KNOTS_FN LxReceiver lxReceive(ShadowRegion region, vec3 positionLocal, vec3 normal LX_KNOTS)
{
#ifndef LIXEL_NO_PARABOLOID
    if (lxIsOnParaboloid(region)) return lxReceiveOnParaboloid(region, positionLocal, normal LX_PASS_KNOTS);
#endif
    LxReceiver r;
    mat4 m = region.lightClipFromLocal;
    vec4 clip = lxLightClip(region, positionLocal);
    float perW = 1.0f / clip.w;
    vec3 ndc = vec3(clip.x * perW, clip.y * perW, clip.z * perW);
    r.lixel = vec2(ndc.x * region.lixelFromNdc.x + region.lixelFromNdc.z,
                   ndc.y * region.lixelFromNdc.y + region.lixelFromNdc.w);
    r.depth = ndc.z;

    // The receiver's plane in (lixel x, lixel y, depth): the light image along two tangents, d(clip / w) = (d clip - ndc d w) / w.
    vec3 t1 = lxAnyPerpendicular(normal);
    vec3 t2 = cross(normal, t1);
    vec4 c1 = m * vec4(t1, 0.0f);
    vec4 c2 = m * vec4(t2, 0.0f);
    vec3 a = vec3((c1.x - ndc.x * c1.w) * region.lixelFromNdc.x, (c1.y - ndc.y * c1.w) * region.lixelFromNdc.y,
                  c1.z - ndc.z * c1.w) *
             perW;
    vec3 b = vec3((c2.x - ndc.x * c2.w) * region.lixelFromNdc.x, (c2.y - ndc.y * c2.w) * region.lixelFromNdc.y,
                  c2.z - ndc.z * c2.w) *
             perW;
    vec3 across = cross(a, b);
    bool isEdgeOn = max(abs(across.x), abs(across.y)) >= LX_STEEPEST * abs(across.z);
    float gx = isEdgeOn ? 0.0f : across.x / across.z;
    float gy = isEdgeOn ? 0.0f : across.y / across.z;
    r.depthPerLixel = vec2(-gx, -gy);
    r.steepness = vec2(abs(gx), abs(gy));

    // What rounding may do: terms of each row against its sum.
    vec3 p = vec3(abs(positionLocal.x), abs(positionLocal.y), abs(positionLocal.z));
    float sumX = lxTerms(lxRowOf(m, 0), p);
    float sumY = lxTerms(lxRowOf(m, 1), p);
    float sumZ = lxTerms(lxRowOf(m, 2), p);
    float sumW = lxTerms(lxRowOf(m, 3), p);
    float errorX = (sumX + abs(ndc.x) * sumW) * abs(perW) * region.lixelFromNdc.x;
    float errorY = (sumY + abs(ndc.y) * sumW) * abs(perW) * region.lixelFromNdc.y;
    float errorZ = (sumZ + abs(ndc.z) * sumW) * abs(perW);
    // Beyond the far side nothing is drawn: what lies there would lose its shadows, and is the next region's.
    bool inside = clip.w > 0.0f && r.lixel.x >= region.serves.x && r.lixel.y >= region.serves.y &&
                  r.lixel.x < region.serves.z && r.lixel.y < region.serves.w && r.depth >= -LX_ROUNDING * errorZ;
    r.slack = isEdgeOn ? LX_STEEPEST : LX_ROUNDING * (errorZ + abs(gx) * errorX + abs(gy) * errorY);
    r.ray = vec3(0.0f, 0.0f, 0.0f);
    r.depthPerRay = r.ray;
    r.lixelFromPlace = vec4(0.0f, 0.0f, 0.0f, 0.0f);
    r = lxOnPlaneOfRegion(lxBeforeWarp(r, region, inside), region, positionLocal, normal, perW);
#ifndef LIXEL_NO_WARP
    if (region.warp.kind.x != LX_WARP_NONE) return lxWarpedReceiver(r LX_PASS_KNOTS);
#endif
    return r;
}

// The depth of the receiver's plane at a place in the map; of a warped map, on the ray that a lixel there was drawn with.
LX_KNOTS_FN float lxPlaneDepth(LxReceiver r, vec2 place LX_KNOTS)
{
    vec2 ray = place;
#ifndef LIXEL_NO_WARP
    if (r.warp.kind.x != LX_WARP_NONE) ray = lxUnwarpedLixelNear(r.warp, place, r.unwarped LX_PASS_KNOTS);
#endif
#ifndef LIXEL_NO_PARABOLOID
    if (r.lixelFromPlace.x > 0.0f) {
        vec2 at =
            vec2((ray.x - r.lixelFromPlace.z) / r.lixelFromPlace.x, (ray.y - r.lixelFromPlace.w) / r.lixelFromPlace.y);
        return r.depth + dot(r.depthPerRay, lxParaboloidRay(at) - r.ray);
    }
#endif
    return r.depth + r.depthPerLixel.x * (ray.x - r.at.x) + r.depthPerLixel.y * (ray.y - r.at.y);
}

// The depth that a stored depth must exceed (be nearer than) to shadow the receiver, for the tap whose lixel has its centre at
// `centre`: the receiver's plane there, nearer by what it changes over half a lixel. The plane alone keeps planes and convex
// bodies free of shadows of their own; the half lixel covers bodies that curve towards the light within one, and is not needed
// on a plane that the map is made for. Not below 0, which is what an empty lixel holds.
LX_KNOTS_FN float lxShadowingDepth(LxReceiver r, vec2 centre LX_KNOTS)
{
    float margin = (r.steepness.x + r.steepness.y) * r.margin;
    bool isBeside = max(abs(centre.x - r.lixel.x), abs(centre.y - r.lixel.y)) > LX_HALF_LIXEL;
    float slack = isBeside ? r.slack + r.slackBeside : r.slack;
    return max(lxPlaneDepth(r, centre LX_PASS_KNOTS) + margin + slack, 0.0f);
}

LX_SHARED_END

#endif
