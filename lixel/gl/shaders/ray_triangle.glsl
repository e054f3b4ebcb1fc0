// SPDX-License-Identifier: MIT
// A triangle as the rays of a region meet it: which rays, given by NDC x, y, and at what depth.
//
// A corner q before the light is the pivot, at (X, Y, Z, W) in clip space; those of the others are counted from it and sheared, so
// that it becomes the origin: P = (dX - qx dW, dY - qy dW), D = dZ - qz dW. For a ray at s from the pivot's NDC the weights of the
// corners are, up to a common factor,
//
//   W0 cross(s, P2) / A,   W0 cross(P1, s) / A   and   1 - (W1 cross(s, P2) + W2 cross(P1, s)) / A,     A = cross(P1, P2),
//
// linear in s; the factor is such that w of the point met is W0, so where all three are positive it lies before the light, even if
// other corners do not. Its depth is that of the pivot + (D1 cross(s, P2) + D2 cross(P1, s)) / A. Nothing large cancels: edges and
// depths are relative to the triangle, wherever it lies.
#include "lixel/gl/shaders/warp_region.glsl"

#define Ray vec2

struct RayTriangle
{
    vec2 pivot;      // NDC
    vec2 first;      // weight of the next corner: dot(first, s)
    vec2 second;     // of the one after
    vec2 own;        // of the pivot: 1 - dot(own, s)
    vec3 slack;      // what rounding may take of the weights: own, first, second
    float depth;     // of the pivot
    vec2 depthPer;   // of s
    vec2 depthRange; // least and greatest of it
    int pivotCorner; // 0 to 2
};

// NDC by which floats may stray: a ray so near an edge meets both triangles that share it, and no gap is left.
const float kRayRounding = 5.0e-7;

vec2 rayOf(vec2 place) { return place; }

vec2 acrossIt(vec2 v) { return vec2(v.y, -v.x); }

// How far out the corner lies; corners that are not before the light are no pivots.
float farOut(vec4 clip) { return clip.w > 0.0 ? max(abs(clip.x), abs(clip.y)) / clip.w : 3.0e38; }

int pivotOf(vec4 a, vec4 b, vec4 c)
{
    float fromA = farOut(a), fromB = farOut(b), fromC = farOut(c);
    if (fromA <= fromB && fromA <= fromC) return 0;
    return fromB <= fromC ? 1 : 2;
}

// False where no ray meets it: it is seen edge-on, or lies nowhere before the light.
bool rayTriangle(vec3 a, vec3 b, vec3 c, out RayTriangle t)
{
    vec4 clipA = lxLightClip(region, a), clipB = lxLightClip(region, b), clipC = lxLightClip(region, c);
    t.pivotCorner = pivotOf(clipA, clipB, clipC);
    vec4 pivot = t.pivotCorner == 0 ? clipA : t.pivotCorner == 1 ? clipB : clipC;
    vec3 p0 = t.pivotCorner == 0 ? a : t.pivotCorner == 1 ? b : c;
    vec3 p1 = t.pivotCorner == 0 ? b : t.pivotCorner == 1 ? c : a;
    vec3 p2 = t.pivotCorner == 0 ? c : t.pivotCorner == 1 ? a : b;
    vec3 q = pivot.xyz / pivot.w;
    vec4 d1 = region.lightClipFromLocal * vec4(p1 - p0, 0.0);
    vec4 d2 = region.lightClipFromLocal * vec4(p2 - p0, 0.0);
    vec3 e1 = d1.xyz - q * d1.w, e2 = d2.xyz - q * d2.w;
    float area = e1.x * e2.y - e1.y * e2.x;
    if (pivot.w <= 0.0 || !(abs(area) > 0.0)) return false;
    vec2 k1 = acrossIt(e2.xy) / area, k2 = -acrossIt(e1.xy) / area;
    t.pivot = q.xy;
    t.first = pivot.w * k1;
    t.second = pivot.w * k2;
    t.own = (pivot.w + d1.w) * k1 + (pivot.w + d2.w) * k2;
    float rounding = kRayRounding * max(1.0, max(abs(q.x), abs(q.y)));
    t.slack = rounding * vec3(abs(t.own.x) + abs(t.own.y), abs(t.first.x) + abs(t.first.y), abs(t.second.x) + abs(t.second.y));
    t.depth = q.z;
    t.depthPer = e1.z * k1 + e2.z * k2;
    t.depthRange = vec2(0.0, 1.0);
    if (min(clipA.w, min(clipB.w, clipC.w)) > 0.0) {
        vec3 depths = vec3(clipA.z / clipA.w, clipB.z / clipB.w, clipC.z / clipC.w);
        t.depthRange = clamp(vec2(min(depths.x, min(depths.y, depths.z)), max(depths.x, max(depths.y, depths.z))), 0.0, 1.0);
    }
    return true;
}

// Of the corners: the pivot's and those after it.
vec3 weightsAt(RayTriangle t, vec2 s) { return vec3(1.0 - dot(t.own, s), dot(t.first, s), dot(t.second, s)); }

bool isMet(RayTriangle t, vec3 weights) { return all(greaterThanEqual(weights, -t.slack)); }

// Between the triangle's own depths: what a ray meets at its edge by rounding is no farther or nearer than the triangle is.
float depthAt(RayTriangle t, vec2 s) { return clamp(t.depth + dot(t.depthPer, s), t.depthRange.x, t.depthRange.y); }

// Whether no ray of this box meets it, by one of its edges.
bool missesBox(RayTriangle t, vec4 box)
{
    vec2 least = box.xy - t.pivot, greatest = box.zw - t.pivot;
    vec3 most = vec3(1.0 + dot(max(-t.own * least, -t.own * greatest), vec2(1.0)),
                     dot(max(t.first * least, t.first * greatest), vec2(1.0)),
                     dot(max(t.second * least, t.second * greatest), vec2(1.0)));
    return any(lessThan(most, -t.slack));
}
