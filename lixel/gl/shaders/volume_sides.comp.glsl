// SPDX-License-Identifier: MIT
// The silhouettes: how often each edge bounds the volumes of the triangles that meet in it. Every triangle, seen from the light, is
// one caster whose corners run counterclockwise; where as many of them run along an edge one way as the other, nothing hangs
// from it (Kim et al. 2008 count such multiplicities for non-manifold meshes).
#include "lixel/gl/shaders/volume_edges.glsl"
#include "lixel/gl/shaders/volume_index.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = kStorageEdgeUses) readonly buffer Uses { uint uses[]; };
layout(std430, binding = kStorageFacing) readonly buffer Facing { int facing[]; };
layout(std430, binding = kStorageSides) writeonly buffer Sides { uint sides[]; };
layout(std430, binding = kStorageSideDraw) buffer SideDraw { uint vertexCount, instanceCount, firstVertex, baseInstance; };
layout(location = 0) uniform uint edgeCount;
layout(location = 1) uniform uint verticesASide;

void main()
{
    uint index = indexInRows();
    if (index >= edgeCount) return;
    MeshEdge edge = edges[index];
    int times = 0;
    for (uint i = edge.firstUse; i < edge.firstUse + edge.useCount; ++i) {
        int seen = facing[uses[i] >> 1];
        times += (uses[i] & 1u) == 0u ? seen : -seen;
    }
    if (times == 0) return;
    uint first = atomicAdd(vertexCount, verticesASide * uint(abs(times))) / verticesASide;
    for (uint i = 0u; i < uint(abs(times)); ++i) sides[first + i] = 2u * index + (times < 0 ? 1u : 0u);
}
