// SPDX-License-Identifier: MIT
// The holes of casters from buffers.
#include "lixel/gl/shaders/alpha.glsl"
#include "lixel/gl/shaders/materials.glsl"

layout(location = 0) in vec2 lixelUv;
layout(location = 1) in float vertexAlpha;
layout(location = 2) flat in uint firstTriangle; // of this draw

void main()
{
    SurfaceMaterial material = materials[triangleMaterial[firstTriangle + uint(gl_PrimitiveID)]];
    if (!isKept(material.baseColour.a, vertexAlpha, surfaceTextureAlpha(lixelUv), material.alphaCutoff)) discard;
}
