// SPDX-License-Identifier: MIT
// Casters from buffers.   MASKED   the surface has holes   POSITION   where each lixel's surface is, is drawn too
#include "lixel/gl/shaders/lixel_caster.glsl"

layout(location = kAttributePosition) in vec3 inPositionLocal;
layout(location = kAttributeInstance) in uvec2 inInstance; // region, first triangle of the draw
#ifdef MASKED
layout(location = kAttributeUv) in vec2 inUv;
layout(location = kAttributeColour) in vec4 inColour;
layout(location = 1) out float vertexAlpha;
layout(location = 2) flat out uint firstTriangle;
#endif

#ifdef POSITION
layout(location = 3) out vec3 surfaceLocal;
#endif

void main()
{
#ifdef POSITION
    surfaceLocal = inPositionLocal;
#endif
#ifdef MASKED
    vertexAlpha = inColour.a;
    firstTriangle = inInstance.y;
    lixelCasterInto(int(inInstance.x), inPositionLocal, inUv);
#else
    lixelCasterInto(int(inInstance.x), inPositionLocal, vec2(0.0));
#endif
}
