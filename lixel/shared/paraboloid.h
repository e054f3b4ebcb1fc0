// SPDX-License-Identifier: MIT
// Maps of half of all rays from a light, and more, on a paraboloid: one text for the CPU executor and for GLSL.
//
//   S. Brabec, T. Annen, H.-P. Seidel. Shadow Mapping for Hemispherical and Omnidirectional Light Sources. CGI 2002.
//
// The region's matrix takes a point to the light's own axes: x, y across the map, w along its axis, lengths kept. The unit ray q
// through it lies at q.xy / (1 + q.w) on the paraboloid, the axis at 0 and the rim of the half sphere at distance 1; the places go on
// beyond the rim, and end nowhere but at the ray straight behind. Depth goes with one over the distance from the light, which on a
// plane is linear in q, as depths of perspective maps are in NDC: where a ray meets a plane or a triangle is known without a root.
#ifndef LIXEL_SHARED_PARABOLOID_H
#define LIXEL_SHARED_PARABOLOID_H
#include "lixel/shared/shadow_tables.h"

LX_SHARED_BEGIN

LX_FN bool lxIsOnParaboloid(ShadowRegion region) { return region.projection.x == LX_PROJECTION_PARABOLOID; }

// From the light to a point, in the map's axes.
LX_FN vec3 lxAwayFromLight(vec4 clip) { return vec3(clip.x, clip.y, clip.w); }

// Where a unit ray lies on the paraboloid. Straight behind, where there is no place: very far out.
LX_FN vec2 lxOnParaboloid(vec3 ray)
{
    float perZ = 1.0f / max(1.0f + ray.z, 1.0e-9f);
    return vec2(ray.x * perZ, ray.y * perZ);
}

// The unit ray at a place.
LX_FN vec3 lxParaboloidRay(vec2 at)
{
    float squared = at.x * at.x + at.y * at.y;
    float per = 1.0f / (1.0f + squared);
    return vec3(2.0f * at.x * per, 2.0f * at.y * per, (1.0f - squared) * per);
}

// Its place and reversed depth: what NDC is to a matrix. Lixels are counted from it by lixelFromNdc.
LX_FN vec3 lxParaboloidNdc(ShadowRegion region, vec4 clip)
{
    vec3 away = lxAwayFromLight(clip);
    float perDistance = 1.0f / length(away);
    vec2 at = lxOnParaboloid(away * perDistance);
    return vec3(at.x, at.y, clip.z * perDistance - region.projection.y);
}

LX_SHARED_END

#endif
