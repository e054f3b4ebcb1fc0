// SPDX-License-Identifier: MIT
// Edges of the casters, and the sides of volumes that hang from them: 2 * edge, and 1 more where a side runs from `to` to `from`.
#include "lixel/shared/gl_slots.h"

struct MeshEdge
{
    uint from, to, firstUse, useCount;
};
layout(std430, binding = kStorageEdges) readonly buffer Edges { MeshEdge edges[]; };
