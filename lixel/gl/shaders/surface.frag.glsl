// SPDX-License-Identifier: MIT
// What is seen through a pixel's centre: the triangle, its base colour and its shading normal. Positions are not
// interpolated: gather.comp.glsl takes them from the triangle itself.
//   MASKED   the surface has holes
#include "lixel/gl/shaders/materials.glsl"
#include "lixel/gl/shaders/octahedron.glsl"
#ifdef MASKED
#include "lixel/gl/shaders/alpha.glsl"
#else
layout(binding = kUnitSurface) uniform sampler2D surfaceTexture;
#endif

layout(location = 1) uniform uint firstTriangle; // of this draw

layout(location = 0) in vec2 uv;
layout(location = 1) in vec4 colour;
layout(location = 2) in vec3 normal;

layout(location = 0) out uint outTriangle;
layout(location = 1) out vec4 outBaseColour; // linear here, sRGB in the texture
layout(location = 2) out vec2 outNormal;

void main()
{
    uint triangle = firstTriangle + uint(gl_PrimitiveID);
    SurfaceMaterial material = materials[triangleMaterial[triangle]];
    vec3 textureColour = texture(surfaceTexture, uv).rgb;
#ifdef MASKED
    if (!isKept(material.baseColour.a, colour.a, surfaceTextureAlpha(uv), material.alphaCutoff)) discard;
#endif
    outTriangle = triangle;
    outBaseColour = vec4(material.baseColour.rgb * colour.rgb * textureColour, 1.0);
    outNormal = dot(normal, normal) > 0.0 ? octahedronFromDirection(normal) : vec2(0.0);
}
