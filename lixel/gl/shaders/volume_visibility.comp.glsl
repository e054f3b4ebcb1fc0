// SPDX-License-Identifier: MIT
// In no volume: lit. So is a sample in less than none: it stands on an edge of its own triangle, and the side that hangs there, which
// is behind it, came before it by rounding. Up to four such sides are told from as many volumes less than 256.
#include "lixel/shared/gl_slots.h"
#include "lixel/shared/view_tables.h"

layout(local_size_x = 64) in;

layout(std430, binding = kStoragePoints) readonly buffer Points { ViewPoint points[]; };
layout(std430, binding = kStorageVisibility) writeonly buffer Visibilities { float visibility[]; };
layout(binding = kUnitVolumes) uniform usampler2D volumes; // how many volumes hold the sample, modulo 256

layout(location = 0) uniform uint firstPoint; // of this part of the list
layout(location = 1) uniform uint pointCount; // in it
layout(location = 2) uniform int light;

const float kNoSample = -1.0;
const uint kLessThanNone = 252u; // from here on, modulo 256

void main()
{
    uint entry = gl_GlobalInvocationID.x;
    if (entry >= pointCount) return;
    uint index = firstPoint + entry, width = uint(textureSize(volumes, 0).x);
    uint inVolumes = texelFetch(volumes, ivec2(index % width, index / width), 0).r;
    float lit = inVolumes == 0u || inVolumes >= kLessThanNone ? 1.0 : 0.0;
    visibility[uint(light) * pointCount + entry] = points[entry].pixel == kNoPixel ? kNoSample : lit;
}
