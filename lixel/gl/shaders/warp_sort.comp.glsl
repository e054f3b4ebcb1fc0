// SPDX-License-Identifier: MIT
// Queues the triangles that may have lixels of a warped map.   PARABOLOID   the region is on one
#include "lixel/gl/shaders/caster_triangles.glsl"
#include "lixel/gl/shaders/warp_columns.glsl"
#ifdef PARABOLOID
#include "lixel/gl/shaders/paraboloid_box.glsl"
#else
#include "lixel/gl/shaders/caster_box.glsl"
#endif
#include "lixel/gl/shaders/warp_queues.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = kStorageWarpSpans) readonly buffer Spans { uvec2 spans[]; }; // first triangle, count

layout(location = 0) uniform uint firstSpan;

// An invocation never has more rounds to do than drivers let it: `lixels` may be a guess, rows are not.
int queueFor(int columns, int lixels)
{
    int which = 0;
    while (which < kQueues - 1 && (lixels > kMostLixels[which] || (columns / kInvocations[which] + 1) * mapSize().y > kMostRounds)) ++which;
    return which;
}

void queue(uint triangle, ivec2 columns, int lixels)
{
    int which = queueFor(columns.y - columns.x + 1, lixels);
    uint each = uint(64 / kInvocations[which]); // triangles of a work group
    uint at = atomicAdd(queues[which].count, 1u);
    if (at % each == 0u && at / each < kMostGroups) atomicAdd(queues[which].groupsX, 1u);
    queued[uint(which) * capacity + at] = uvec2(triangle, uint(columns.x) | uint(columns.y) << 16u);
}

void sort(uint triangle)
{
    vec4 a = lxLightClip(region, cornerAt(indices[3u * triangle]));
    vec4 b = lxLightClip(region, cornerAt(indices[3u * triangle + 1u]));
    vec4 c = lxLightClip(region, cornerAt(indices[3u * triangle + 2u]));
    vec4 ndc = boxInMap(a, b, c);
    if (any(greaterThan(ndc.xy, ndc.zw)) || isBeyondFarSide(a, b, c)) return;
    vec4 box = squareFromNdc(ndc);
    ivec2 columns = columnsOf(box);
    if (columns.x > columns.y) return;
    // Where there are one or two columns, whether they have any lixel; else a guess at how many.
    ivec2 inFirst = lixelsOfColumn(columns.x, box.yw), inLast = lixelsOfColumn(columns.y, box.yw);
    int most = max(inFirst.y - inFirst.x, inLast.y - inLast.x) + 1;
    if (columns.y - columns.x <= 1 && most <= 0) return;
    queue(triangle, columns, (columns.y - columns.x + 1) * max(most, 1));
}

void main()
{
    uvec2 span = spans[firstSpan + gl_WorkGroupID.x];
    for (uint i = gl_LocalInvocationID.x; i < span.y; i += 64u) sort(span.x + i);
}
