// SPDX-License-Identifier: MIT
// The picture, from what the view sees and which lights reach it.
#include "lixel/shared/gl_slots.h"
#include "lixel/shared/shading.h"
#include "lixel/shared/view_tables.h"
#include "lixel/gl/shaders/materials.glsl"
#include "lixel/gl/shaders/octahedron.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = kStoragePoints) readonly buffer Points { ViewPoint points[]; };
layout(std430, binding = kStorageVisibility) readonly buffer Visibilities { float visibility[]; };
layout(std430, binding = kStorageShadingLights) readonly buffer Lights { ShadingLight lights[]; };
layout(binding = kUnitTriangles) uniform usampler2D triangleImage;
layout(binding = kUnitBaseColour) uniform sampler2D baseColourImage;
layout(binding = kUnitNormal) uniform sampler2D normalImage;
layout(binding = kImagePicture, rgba8) uniform writeonly image2D picture;

layout(location = 0) uniform uint firstPoint; // of this part of the list
layout(location = 1) uniform uint pointCount; // in it
layout(location = 2) uniform int lightCount;

// The surface's own normal, on the side of its triangle that is seen.
vec3 shadingNormal(ivec2 pixel, vec3 geometricNormal)
{
    vec2 stored = texelFetch(normalImage, pixel, 0).xy;
    if (isNoDirection(stored)) return geometricNormal;
    vec3 n = directionFromOctahedron(stored);
    return dot(n, geometricNormal) < 0.0 ? -n : n;
}

vec3 shaded(ViewPoint point, uint entry, ivec2 pixel)
{
    vec3 normal = shadingNormal(pixel, point.normal);
    vec3 light = lxAmbientLight(normal);
    for (int i = 0; i < lightCount; ++i) {
        float share = visibility[uint(i) * pointCount + entry];
        if (share < 0.0) share = 1.0;
        light += share * lxDirectLight(lights[i], point.positionLocal, point.normal, normal);
    }
    uint triangle = texelFetch(triangleImage, pixel, 0).r;
    return texelFetch(baseColourImage, pixel, 0).rgb * light + materials[triangleMaterial[triangle]].emission;
}

void main()
{
    uint entry = gl_GlobalInvocationID.x;
    if (entry >= pointCount) return;
    ivec2 size = imageSize(picture);
    uint index = firstPoint + entry;
    ivec2 pixel = ivec2(index % uint(size.x), index / uint(size.x));
    ViewPoint point = points[entry];
    vec3 linear = point.pixel == kNoPixel ? lxBackground((float(pixel.y) + 0.5) / float(size.y))
                                          : shaded(point, entry, pixel);
    imageStore(picture, pixel, vec4(lxDisplayed(linear), 1.0));
}
