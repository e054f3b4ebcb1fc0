// SPDX-License-Identifier: MIT
// Draws triangles into a warped map, lixel by lixel: each has the depth at which its ray meets the triangle.
//   MASKED   the surface has holes   PARABOLOID   the region is on one
#include "lixel/gl/shaders/caster_triangles.glsl"
#ifdef PARABOLOID
#include "lixel/gl/shaders/paraboloid_triangle.glsl"
#include "lixel/gl/shaders/paraboloid_box.glsl"
#else
#include "lixel/gl/shaders/ray_triangle.glsl"
#include "lixel/gl/shaders/caster_box.glsl"
#endif
#include "lixel/gl/shaders/warp_columns.glsl"
#ifdef MASKED
#include "lixel/gl/shaders/alpha.glsl"
#include "lixel/gl/shaders/materials.glsl"

layout(std430, binding = kStorageUv) readonly buffer Uv { float uvOfVertices[]; };
layout(std430, binding = kStorageColours) readonly buffer Colours { float colours[]; };
layout(location = 0) uniform ivec2 strides; // of the two, a vertex; 0: one value for all
#endif

layout(std430, binding = kStorageWarpRays) readonly buffer Rays { vec2 rays[]; };  // places before the warp, column by column
layout(std430, binding = kStorageWarpDepths) buffer Depths { uint depths[]; };    // as bits, which grow with the depth; row by row

#ifdef MASKED
// What decides about holes, of the pivot and the corners after it: u, v, alpha.
struct Mask
{
    vec3 own, first, second;
    float factor, cutoff;
};

vec3 maskOfVertex(uint vertex)
{
    int uv = int(vertex) * strides.x;
    return vec3(uvOfVertices[uv], uvOfVertices[uv + 1], colours[int(vertex) * strides.y + 3]);
}

Mask maskOf(uint triangle, int pivotCorner)
{
    uint at = 3u * triangle, corner = uint(pivotCorner);
    SurfaceMaterial material = materials[triangleMaterial[triangle]];
    return Mask(maskOfVertex(indices[at + corner]), maskOfVertex(indices[at + (corner + 1u) % 3u]),
                maskOfVertex(indices[at + (corner + 2u) % 3u]), material.baseColour.a, material.alphaCutoff);
}

bool keeps(Mask mask, vec3 weights)
{
    vec3 there = (weights.x * mask.own + weights.y * mask.first + weights.z * mask.second) / dot(weights, vec3(1.0));
    return isKept(mask.factor, there.z, surfaceTextureAlpha(there.xy), mask.cutoff);
}
#endif

struct Drawn
{
    RayTriangle triangle;
    vec2 y; // its range, of the square
#ifdef MASKED
    Mask mask;
#endif
};

bool drawnTriangle(uint triangle, out Drawn drawn)
{
    vec3 a = cornerAt(indices[3u * triangle]), b = cornerAt(indices[3u * triangle + 1u]),
         c = cornerAt(indices[3u * triangle + 2u]);
    bool isThere = rayTriangle(a, b, c, drawn.triangle);
    drawn.y = squareFromNdc(boxInMap(lxLightClip(region, a), lxLightClip(region, b), lxLightClip(region, c))).yw;
#ifdef MASKED
    drawn.mask = maskOf(triangle, drawn.triangle.pivotCorner);
#endif
    return isThere;
}

// Lixels [first, last] of a column. Those whose ray misses are passed over first, so that invocations side by side come together
// where there is something to draw.
void drawLixels(Drawn drawn, int column, int first, int last)
{
    ivec2 size = mapSize();
    int y = first;
    while (y <= last) {
        Ray s;
        vec3 weights;
        bool isHit = false;
        while (y <= last && !isHit) {
            s = rayOf(rays[column * size.y + y]) - drawn.triangle.pivot;
            weights = weightsAt(drawn.triangle, s);
            isHit = isMet(drawn.triangle, weights);
            ++y;
        }
        if (isHit) {
            uint depth = floatBitsToUint(depthAt(drawn.triangle, s));
            int at = (y - 1) * size.x + column;
#ifdef MASKED
            if (depth > depths[at] && keeps(drawn.mask, weights)) atomicMax(depths[at], depth);
#else
            if (depth > depths[at]) atomicMax(depths[at], depth);
#endif
        }
    }
}
