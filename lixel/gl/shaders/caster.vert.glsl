// SPDX-License-Identifier: MIT
// Casters from buffers.   MASKED   the surface has holes
#include "lixel/gl/shaders/lixel_caster.glsl"

layout(location = kAttributePosition) in vec3 inPositionLocal;
#ifdef MASKED
layout(location = kAttributeUv) in vec2 inUv;
layout(location = kAttributeColour) in vec4 inColour;
layout(location = 1) out float vertexAlpha;
#endif

void main()
{
#ifdef MASKED
    vertexAlpha = inColour.a;
    lixelCaster(inPositionLocal, inUv);
#else
    lixelCaster(inPositionLocal, vec2(0.0));
#endif
}
