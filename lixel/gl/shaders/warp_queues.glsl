// SPDX-License-Identifier: MIT
// Triangles that may have lixels of a warped map, each with its columns, in queues by how many lixels there are to look at: those
// drawn side by side then take about as long.
#include "lixel/gl/shaders/warp_region.glsl"

const int kQueues = 5;
const int kMostLixels[kQueues - 1] = {6, 24, 96, 16384};
const int kInvocations[kQueues] = {1, 1, 1, 8, 64}; // that share a triangle's columns
const int kMostRounds = 48000;                       // of an invocation: some drivers end loops at 65,535
const uint kMostGroups = 32768u;                     // of one dispatch; each takes every so many-th piece of work

// As read by glDispatchComputeIndirect, and how many triangles are queued.
struct Queue
{
    uint groupsX, groupsY, groupsZ;
    uint count;
};
layout(std430, binding = kStorageWarpQueues) buffer Queues { Queue queues[kQueues]; };
// Triangle, and first and last column in 16 bits each; a fifth of the room each queue.
layout(std430, binding = kStorageWarpQueued) buffer Queued { uvec2 queued[]; };

layout(location = 1) uniform uint capacity; // of each queue
