// SPDX-License-Identifier: MIT
// Where a vertex of a caster comes to in the atlas: its place in the region's map, the viewport and the layer.
//   LIXEL_NO_WARP   no region of any plan has a warp, and none is on a paraboloid
#extension GL_ARB_shader_viewport_layer_array : require
#include "lixel/gl/shaders/caster_tables.glsl"

layout(std140, binding = kUniformBatch) uniform LixelBatch { vec4 lixelBatch; }; // x: the region that has viewport 0

#ifndef LIXEL_NO_WARP
// By how much a warp moves a point of clip space (Milet et al. 2015, algorithm 1). What is not before the light has no lixel, and
// stays.
vec2 lixelWarpOffset(ShadowRegion region, vec4 clip)
{
    if (region.warp.kind.x == LX_WARP_NONE || clip.w <= 0.0) return vec2(0.0);
    vec2 lixel = clip.xy / clip.w * region.lixelFromNdc.xy + region.lixelFromNdc.zw;
    return (lxWarpedLixel(region.warp, lixel).at - lixel) / region.lixelFromNdc.xy * clip.w;
}

// On a paraboloid, where the vertex shader does all: there is nothing left to divide by.
vec4 lixelOnParaboloid(ShadowRegion region, vec4 clip)
{
    vec3 place = lxParaboloidNdc(region, clip);
    vec2 lixel = lxWarpedLixel(region.warp, place.xy * region.lixelFromNdc.xy + region.lixelFromNdc.zw).at;
    vec2 share = (lixel - region.rectangle.xy) / (region.rectangle.zw - region.rectangle.xy);
    return vec4(2.0 * share - 1.0, place.z, 1.0);
}

// Triangles are clipped where they go further beyond the rim of the half sphere than the corners of its square: z of their ray.
const float kLixelBeyondCorners = -0.4;
#endif

void lixelPlace(int view, vec3 positionLocal)
{
    gl_ViewportIndex = view - int(lixelBatch.x);
    gl_Layer = int(lixelRegions[view].place.x);
    gl_Position = lxLightClip(lixelRegions[view], positionLocal);
#ifndef LIXEL_NO_WARP
    gl_ClipDistance[0] = 1.0;
    if (lxIsOnParaboloid(lixelRegions[view])) {
        vec3 away = lxAwayFromLight(gl_Position);
        gl_ClipDistance[0] = away.z / length(away) - kLixelBeyondCorners;
        gl_Position = lixelOnParaboloid(lixelRegions[view], gl_Position);
    } else {
        gl_Position.xy += lixelWarpOffset(lixelRegions[view], gl_Position);
    }
#endif
}
