// SPDX-License-Identifier: MIT
// What shadow volumes are made of: triangles as they were given, which side of each the light sees, and the light. A light far
// away is a point at infinity: w = 0 and the way towards it.
#include "lixel/gl/shaders/caster_triangles.glsl"

layout(location = 0) uniform vec4 lightLocal;

// Where a corner goes along its light ray, infinitely far.
vec4 farAway(vec3 cornerLocal) { return vec4(lightLocal.w * cornerLocal - lightLocal.xyz, 0.0); }
