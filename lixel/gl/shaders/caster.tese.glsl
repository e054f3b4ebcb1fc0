// SPDX-License-Identifier: MIT
// The pieces that caster.tesc.glsl cuts a caster into, each vertex moved by the warp.   MASKED   the surface has holes
#include "lixel/gl/shaders/place_caster.glsl"

layout(triangles, equal_spacing, ccw) in;

layout(location = 0) in vec2 patchUv[];
layout(location = 4) in vec3 patchPosition[];
layout(location = 5) in int patchView[];
layout(location = 0) out vec2 lixelUv;
#ifdef MASKED
layout(location = 1) in float patchAlpha[];
layout(location = 2) in uint patchFirstTriangle[];
layout(location = 1) out float vertexAlpha;
layout(location = 2) flat out uint firstTriangle;
#endif

void main()
{
    vec3 share = gl_TessCoord;
    // Two corners that make an edge give it the same points in either order.
    precise vec3 position = share.x * patchPosition[0] + share.y * patchPosition[1] + share.z * patchPosition[2];
    lixelUv = share.x * patchUv[0] + share.y * patchUv[1] + share.z * patchUv[2];
#ifdef MASKED
    vertexAlpha = share.x * patchAlpha[0] + share.y * patchAlpha[1] + share.z * patchAlpha[2];
    firstTriangle = patchFirstTriangle[0];
#endif
    lixelPlace(patchView[0], position);
}
