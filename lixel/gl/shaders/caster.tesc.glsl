// SPDX-License-Identifier: MIT
// How finely a caster is cut up before its warp (Milet et al. 2015, section 4.1): by how its edges bend, each by itself, so that
// neighbours cut a shared edge alike and no crack opens.
//   MASKED   the surface has holes
#include "lixel/gl/shaders/caster_tables.glsl"

layout(vertices = 3) out;

layout(location = 0) in vec2 lixelUv[];
layout(location = 4) in vec3 lixelPosition[];
layout(location = 5) in int lixelView[];
layout(location = 0) out vec2 patchUv[];
layout(location = 4) out vec3 patchPosition[];
layout(location = 5) out int patchView[];
#ifdef MASKED
layout(location = 1) in float vertexAlpha[];
layout(location = 2) flat in uint firstTriangle[];
layout(location = 1) out float patchAlpha[];
layout(location = 2) out uint patchFirstTriangle[];
#endif

const float kBend = 0.25;     // lixels that an edge's pieces may be beside their place: half the pieces bend a quarter
const int kPlaces = 8;        // where the bend is looked at: between as many pieces of the edge
const float kMostPieces = 64.0;

vec2 lixelOf(ShadowRegion region, vec4 clip) { return clip.xy / clip.w * region.lixelFromNdc.xy + region.lixelFromNdc.zw; }

bool isBefore(vec3 a, vec3 b)
{
    if (a.x != b.x) return a.x < b.x;
    if (a.y != b.y) return a.y < b.y;
    return a.z < b.z;
}

// On a paraboloid edges bend without a warp, too: their points are projected one by one.
vec2 lixelOnParaboloid(ShadowRegion region, vec3 position)
{
    vec2 lixel = lxParaboloidNdc(region, lxLightClip(region, position)).xy * region.lixelFromNdc.xy + region.lixelFromNdc.zw;
    return lxWarpedLixel(region.warp, lixel).at;
}

// Of a place beside a straight edge.
float besideEdge(vec2 at, vec2 from, vec2 to)
{
    vec2 along = to - from;
    float lengthAlong = length(along);
    return lengthAlong > 0.0 ? abs(along.x * (at.y - from.y) - along.y * (at.x - from.x)) / lengthAlong : distance(at, from);
}

float piecesOnParaboloid(ShadowRegion region, vec3 a, vec3 b)
{
    vec2 from = lixelOnParaboloid(region, a), to = lixelOnParaboloid(region, b);
    float bend = 0.0;
    for (int i = 1; i < kPlaces; ++i)
        bend = max(bend, besideEdge(lixelOnParaboloid(region, mix(a, b, float(i) / float(kPlaces))), from, to));
    return clamp(ceil(sqrt(bend / kBend)), 1.0, kMostPieces);
}

// In the same order, whichever triangle asks.
float piecesOf(ShadowRegion region, vec3 p, vec3 q)
{
    vec3 a = isBefore(p, q) ? p : q, b = isBefore(p, q) ? q : p;
    if (lxIsOnParaboloid(region)) return piecesOnParaboloid(region, a, b);
    vec4 clipA = lxLightClip(region, a), clipB = lxLightClip(region, b);
    if (clipA.w <= 0.0 || clipB.w <= 0.0) return 1.0;
    vec2 fromA = lixelOf(region, clipA), fromB = lixelOf(region, clipB);
    vec2 toA = lxWarpedLixel(region.warp, fromA).at, toB = lxWarpedLixel(region.warp, fromB).at;
    float bend = 0.0;
    for (int i = 1; i <= kPlaces; ++i) {
        float share = float(i) / float(kPlaces);
        vec2 to = lxWarpedLixel(region.warp, mix(fromA, fromB, share)).at;
        bend = max(bend, distance(to, mix(toA, toB, share)));
    }
    return clamp(ceil(sqrt(bend / kBend)), 1.0, kMostPieces);
}

// Beside the map on one side of it; nothing of it is cut then, or drawn.
bool isOutside(vec4 a, vec4 b, vec4 c)
{
    return (a.x > a.w && b.x > b.w && c.x > c.w) || (a.x < -a.w && b.x < -b.w && c.x < -c.w) ||
           (a.y > a.w && b.y > b.w && c.y > c.w) || (a.y < -a.w && b.y < -b.w && c.y < -c.w);
}

void main()
{
    patchUv[gl_InvocationID] = lixelUv[gl_InvocationID];
    patchPosition[gl_InvocationID] = lixelPosition[gl_InvocationID];
    patchView[gl_InvocationID] = lixelView[gl_InvocationID];
#ifdef MASKED
    patchAlpha[gl_InvocationID] = vertexAlpha[gl_InvocationID];
    patchFirstTriangle[gl_InvocationID] = firstTriangle[gl_InvocationID];
#endif
    if (gl_InvocationID != 0) return;
    ShadowRegion region = lixelRegions[lixelView[0]];
    vec3 a = lixelPosition[0], b = lixelPosition[1], c = lixelPosition[2];
    vec3 pieces = vec3(1.0);
    if (!lxIsOnParaboloid(region) && isOutside(lxLightClip(region, a), lxLightClip(region, b), lxLightClip(region, c))) pieces = vec3(0.0);
    else if (region.warp.kind.x != LX_WARP_NONE)
        pieces = vec3(piecesOf(region, b, c), piecesOf(region, c, a), piecesOf(region, a, b));
    gl_TessLevelOuter[0] = pieces.x; // the edge opposite to corner 0
    gl_TessLevelOuter[1] = pieces.y;
    gl_TessLevelOuter[2] = pieces.z;
    gl_TessLevelInner[0] = max(pieces.x, max(pieces.y, pieces.z));
}
