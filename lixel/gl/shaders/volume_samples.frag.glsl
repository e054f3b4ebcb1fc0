// SPDX-License-Identifier: MIT
// The sample in each pixel, of a list with an entry a pixel: its place, as bits, and its triangle.
#include "lixel/shared/gl_slots.h"
#include "lixel/shared/view_tables.h"

layout(std430, binding = kStoragePoints) readonly buffer Points { ViewPoint points[]; };

layout(location = 0) uniform uint firstPoint; // of this part of the list
layout(location = 1) uniform uint pointCount; // in it
layout(location = 2) uniform uint width;      // of the picture

layout(location = 0) out uvec4 outSample;

void main()
{
    uint entry = uint(gl_FragCoord.y) * width + uint(gl_FragCoord.x) - firstPoint;
    if (entry >= pointCount || points[entry].pixel == kNoPixel) discard;
    outSample = uvec4(floatBitsToUint(points[entry].positionLocal), points[entry].triangle);
}
