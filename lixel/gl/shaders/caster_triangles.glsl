// SPDX-License-Identifier: MIT
// Casters from buffers, by the number of a triangle in drawing order.
#include "lixel/shared/gl_slots.h"

layout(std430, binding = kStorageIndices) readonly buffer Indices { uint indices[]; };
layout(std430, binding = kStoragePositions) readonly buffer Positions { float positions[]; };

vec3 cornerAt(uint index)
{
    uint p = 3u * index;
    return vec3(positions[p], positions[p + 1u], positions[p + 2u]);
}
