// SPDX-License-Identifier: MIT
// The list of view samples, one entry a pixel: where the ray through the pixel's centre meets the triangle that the
// rasterizer found there, in double precision, and that triangle's normal turned to the eye.
#include "lixel/shared/gl_slots.h"
#include "lixel/shared/view_tables.h"

layout(local_size_x = 64) in;

layout(std140, binding = kUniformView) uniform View { ViewRays rays; };
layout(std430, binding = kStorageIndices) readonly buffer Indices { uint indices[]; };
layout(std430, binding = kStoragePositions) readonly buffer Positions { float positions[]; };
layout(std430, binding = kStorageTriangleSource) readonly buffer TriangleSource { uint triangleSource[]; };
layout(std430, binding = kStoragePoints) writeonly buffer Points { ViewPoint points[]; };
layout(binding = kUnitTriangles) uniform usampler2D triangleImage;

layout(location = 0) uniform uint firstPoint;    // of this binding of the list
layout(location = 1) uniform uint pointCount;    // in it
layout(location = 2) uniform uint firstTriangle; // of this binding of the triangles
layout(location = 3) uniform uint triangleCount; // in it

const uint kNothing = 0xffffffffu;

dvec3 corner(uint i)
{
    uint p = 3u * indices[i];
    return dvec3(positions[p], positions[p + 1u], positions[p + 2u]);
}

struct Ray
{
    dvec3 origin, direction;
};

Ray rayThrough(ivec2 pixel, ivec2 size)
{
    double x = (2.0LF * double(pixel.x) + 1.0LF) / double(size.x) - 1.0LF;
    double y = (2.0LF * double(pixel.y) + 1.0LF) / double(size.y) - 1.0LF;
    return Ray(rays.rayOrigin[0].xyz + x * rays.rayOrigin[1].xyz + y * rays.rayOrigin[2].xyz,
               rays.rayDirection[0].xyz + x * rays.rayDirection[1].xyz + y * rays.rayDirection[2].xyz);
}

// The point of a segment nearest to the line of a ray; `distance2` is its squared distance as seen in the picture.
dvec3 nearestOnEdge(Ray ray, dvec3 a, dvec3 b, out double distance2)
{
    dvec3 d = ray.direction / length(ray.direction);
    dvec3 e = b - a, s = a - ray.origin;
    dvec3 eAcross = e - d * dot(d, e), sAcross = s - d * dot(d, s);
    double l = dot(eAcross, eAcross);
    double t = l > 0.0LF ? clamp(-dot(eAcross, sAcross) / l, 0.0LF, 1.0LF) : 0.0LF;
    dvec3 across = sAcross + t * eAcross;
    dvec3 p = a + t * e;
    double w = dot(rays.clipW.xyz, p) + rays.clipW.w;
    distance2 = dot(across, across) / (w * w);
    return p;
}

// Moeller & Trumbore 1997. Where the rasterizer, which rounds corners to parts of a pixel, found a triangle that the ray
// just misses, the nearest point of its edges: a sample lies on its triangle.
dvec3 pointOn(Ray ray, dvec3 a, dvec3 b, dvec3 c)
{
    dvec3 e1 = b - a, e2 = c - a;
    dvec3 p = cross(ray.direction, e2);
    double determinant = dot(e1, p);
    if (determinant != 0.0LF) {
        dvec3 s = ray.origin - a;
        dvec3 q = cross(s, e1);
        double u = dot(s, p) / determinant, v = dot(ray.direction, q) / determinant;
        if (u >= 0.0LF && v >= 0.0LF && u + v <= 1.0LF) return a + u * e1 + v * e2;
    }
    double dAB, dBC, dCA;
    dvec3 onAB = nearestOnEdge(ray, a, b, dAB), onBC = nearestOnEdge(ray, b, c, dBC), onCA = nearestOnEdge(ray, c, a, dCA);
    if (dAB <= dBC && dAB <= dCA) return onAB;
    return dBC <= dCA ? onBC : onCA;
}

void main()
{
    uint entry = gl_GlobalInvocationID.x;
    if (entry >= pointCount) return;
    ivec2 size = textureSize(triangleImage, 0);
    uint index = firstPoint + entry;
    ivec2 pixel = ivec2(index % uint(size.x), index / uint(size.x));
    uint triangle = texelFetch(triangleImage, pixel, 0).r;
    if (triangle == kNothing) {
        points[entry] = ViewPoint(vec3(0.0), kNoPixel, vec3(0.0), kNothing);
        return;
    }
    uint row = triangle - firstTriangle;
    if (triangle < firstTriangle || row >= triangleCount) return; // another binding's

    dvec3 a = corner(3u * row), b = corner(3u * row + 1u), c = corner(3u * row + 2u);
    dvec3 position = pointOn(rayThrough(pixel, size), a, b, c);
    dvec3 normal = cross(b - a, c - a);
    double l = length(normal);
    dvec3 toEye = rays.eyeLocal.xyz - rays.eyeLocal.w * position;
    if (dot(normal, toEye) < 0.0LF) normal = -normal;
    points[entry] = ViewPoint(vec3(position), index, l > 0.0LF ? vec3(normal / l) : vec3(0.0), triangleSource[row]);
}
