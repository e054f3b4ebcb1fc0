// SPDX-License-Identifier: MIT
// ray_triangle.glsl for a map on a paraboloid: a triangle as unit rays meet it, wherever around the light it lies.
//
// A corner A is the pivot, E1 and E2 lead from it to the others, n = cross(E1, E2), and a ray is q = A / |A| + s. The weights of the
// corners are, up to a common factor,
//
//   |A| s . cross(E2, A) / D,   |A| s . cross(A, E1) / D   and   1 + |A| s . n / D - both,     D = A . n,
//
// linear in s; the factor is |A| over the distance of the point met, so where all three are positive it lies on the ray and not
// behind the light. One over that distance is (1 + |A| s . n / D) / |A|. As with matrices, nothing large cancels.
#include "lixel/gl/shaders/warp_region.glsl"
#include "lixel/shared/paraboloid.h"

#define Ray vec3

struct RayTriangle
{
    vec3 pivot;      // unit ray
    vec3 first;      // weight of the next corner: dot(first, s)
    vec3 second;     // of the one after
    vec3 own;        // of the pivot: 1 - dot(own, s)
    vec3 slack;      // what rounding may take of the weights: own, first, second
    float depth;     // of the pivot
    vec3 depthPer;   // of s
    vec2 depthRange; // least and greatest of it
    int pivotCorner; // 0 to 2
};

// As of ray_triangle.glsl.
const float kRayRounding = 5.0e-7;
// No point of a triangle is farther from its nearest corner than this part of its longest edge, one over the square root of 3.
const float kFromCorner = 0.57735;

vec3 rayOf(vec2 place) { return lxParaboloidRay(place); }

// The farthest one, whose direction is known best.
int pivotOf(vec3 a, vec3 b, vec3 c)
{
    float fromA = dot(a, a), fromB = dot(b, b), fromC = dot(c, c);
    if (fromA >= fromB && fromA >= fromC) return 0;
    return fromB >= fromC ? 1 : 2;
}

float sizeOf(vec3 v) { return abs(v.x) + abs(v.y) + abs(v.z); }

vec3 turned(vec3 local) { return lxAwayFromLight(region.lightClipFromLocal * vec4(local, 0.0)); }

// Least and greatest depth of the triangle. One over the distance is least at a corner, but greatest anywhere: no nearer than its
// plane, or than a corner by what it is away from that.
vec2 depthRangeOf(vec3 lengths, float planeDistance, float longestEdge, float near)
{
    float farthest = max(lengths.x, max(lengths.y, lengths.z)), nearest = min(lengths.x, min(lengths.y, lengths.z));
    float least = max(planeDistance, nearest - kFromCorner * longestEdge);
    vec2 range = vec2(near / farthest, least > 0.0 ? near / least : 3.0e38) - region.projection.y;
    return clamp(range, 0.0, 1.0);
}

// False where no ray meets it: it is seen edge-on.
bool rayTriangle(vec3 a, vec3 b, vec3 c, out RayTriangle t)
{
    vec4 clipA = lxLightClip(region, a), clipB = lxLightClip(region, b), clipC = lxLightClip(region, c);
    vec3 awayA = lxAwayFromLight(clipA), awayB = lxAwayFromLight(clipB), awayC = lxAwayFromLight(clipC);
    t.pivotCorner = pivotOf(awayA, awayB, awayC);
    vec3 pivot = t.pivotCorner == 0 ? awayA : t.pivotCorner == 1 ? awayB : awayC;
    vec3 p0 = t.pivotCorner == 0 ? a : t.pivotCorner == 1 ? b : c;
    vec3 p1 = t.pivotCorner == 0 ? b : t.pivotCorner == 1 ? c : a;
    vec3 p2 = t.pivotCorner == 0 ? c : t.pivotCorner == 1 ? a : b;
    vec3 e1 = turned(p1 - p0), e2 = turned(p2 - p0), n = cross(e1, e2);
    float away = length(pivot), volume = dot(pivot, n), near = clipA.z;
    if (!(abs(volume) > 0.0)) return false;
    t.pivot = pivot / away;
    t.first = cross(e2, pivot) * (away / volume);
    t.second = cross(pivot, e1) * (away / volume);
    vec3 perDistance = n / volume;
    t.own = t.first + t.second - away * perDistance;
    t.slack = kRayRounding * vec3(sizeOf(t.own), sizeOf(t.first), sizeOf(t.second));
    t.depth = near / away - region.projection.y;
    t.depthPer = near * perDistance;
    float longestEdge = sqrt(max(dot(e1, e1), max(dot(e2, e2), dot(e2 - e1, e2 - e1))));
    t.depthRange = depthRangeOf(vec3(length(awayA), length(awayB), length(awayC)), abs(volume) / length(n), longestEdge, near);
    return true;
}

// Of the corners: the pivot's and those after it.
vec3 weightsAt(RayTriangle t, vec3 s) { return vec3(1.0 - dot(t.own, s), dot(t.first, s), dot(t.second, s)); }

bool isMet(RayTriangle t, vec3 weights) { return all(greaterThanEqual(weights, -t.slack)); }

float depthAt(RayTriangle t, vec3 s) { return clamp(t.depth + dot(t.depthPer, s), t.depthRange.x, t.depthRange.y); }

// Whether no ray of this box of places meets it, by one of its edges. Rays are no further apart than twice their places.
bool missesBox(RayTriangle t, vec4 box)
{
    vec3 weights = weightsAt(t, rayOf(0.5 * (box.xy + box.zw)) - t.pivot);
    float around = distance(box.xy, box.zw);
    vec3 most = weights + around * vec3(length(t.own), length(t.first), length(t.second));
    return any(lessThan(most, -t.slack));
}
