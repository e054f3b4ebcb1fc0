// SPDX-License-Identifier: MIT
// caster_box.glsl for a map on a paraboloid: the box of a triangle's place there.
//
// Edges are arcs of great circles, and on the paraboloid arcs of circles with a radius of at least 1 (the map is stereographic): over
// a chord c they bulge by no more than 1 - sqrt(1 - c^2 / 4). That holds for arcs of less than half a circle, as all are between
// corners on the half sphere, and short ones beyond it.
#include "lixel/shared/paraboloid.h"

const float kNowhere = 3.0e38;
const float kRim = -1.0e-5;          // z of the half sphere's rays, at least
const float kBeyondRim = -0.5;       // of those further on, where short arcs are known
const float kShortChord = 0.5;
const float kLixelsAround = 0.5;     // more than floats stray

// The map's part of the paraboloid: least x, y, greatest x, y.
vec4 placesOfMap() { return (region.rectangle - region.lixelFromNdc.zwzw) / region.lixelFromNdc.xyxy; }

// z that no ray of the map is below.
float leastZOfMap(vec4 places)
{
    vec2 farthest = max(abs(places.xy), abs(places.zw));
    return min(lxParaboloidRay(farthest).z, 0.0);
}

// Cut to the map; least > greatest where nothing of it is there.
vec4 boxInMap(vec4 a, vec4 b, vec4 c)
{
    vec3 rayA = normalize(lxAwayFromLight(a)), rayB = normalize(lxAwayFromLight(b)), rayC = normalize(lxAwayFromLight(c));
    vec4 map = placesOfMap();
    float leastZ = min(rayA.z, min(rayB.z, rayC.z)), greatestZ = max(rayA.z, max(rayB.z, rayC.z));
    // Less than half a sphere behind the map is convex: what has its corners there lies there.
    if (greatestZ < leastZOfMap(map) - 1.0e-5) return vec4(kNowhere, kNowhere, -kNowhere, -kNowhere);
    vec2 atA = lxOnParaboloid(rayA), atB = lxOnParaboloid(rayB), atC = lxOnParaboloid(rayC);
    float chord = max(distance(atA, atB), max(distance(atB, atC), distance(atC, atA)));
    if (leastZ < kRim && (leastZ < kBeyondRim || chord > kShortChord)) return map;
    float bulge = 1.0 - sqrt(max(1.0 - 0.25 * chord * chord, 0.0));
    vec2 around = vec2(bulge) + kLixelsAround / region.lixelFromNdc.xy;
    vec2 least = min(atA, min(atB, atC)) - around, greatest = max(atA, max(atB, atC)) + around;
    return vec4(max(least, map.xy), min(greatest, map.zw));
}

// As the depths of rays are looked at one by one.
bool isBeyondFarSide(vec4 a, vec4 b, vec4 c) { return false; }
