// SPDX-License-Identifier: MIT
// Surfaces as the eye sees them.
#include "lixel/shared/gl_slots.h"

layout(location = kAttributePosition) in vec3 inPositionLocal;
layout(location = kAttributeUv) in vec2 inUv;
layout(location = kAttributeColour) in vec4 inColour;
layout(location = kAttributeNormal) in vec3 inNormal;

layout(location = 0) uniform mat4 clipFromLocal; // depth reversed: 1 near, 0 far

layout(location = 0) out vec2 uv;
layout(location = 1) out vec4 colour;
layout(location = 2) out vec3 normal;

void main()
{
    uv = inUv;
    colour = inColour;
    normal = inNormal;
    gl_Position = clipFromLocal * vec4(inPositionLocal, 1.0);
}
