// SPDX-License-Identifier: MIT
// Draws one queue of triangles into a warped map.
//   RUNS     for large triangles: runs of a column that the triangle passes by are passed over
//   MASKED   the surface has holes
#include "lixel/gl/shaders/warp_drawn.glsl"
#include "lixel/gl/shaders/warp_queues.glsl"

layout(local_size_x = 64) in;

#ifdef RUNS
layout(std430, binding = kStorageWarpRuns) readonly buffer Runs { vec4 runs[]; }; // least x, y, greatest x, y; column by column
#endif

layout(location = 2) uniform int queue;

void drawColumn(Drawn drawn, int column)
{
    ivec2 lixels = lixelsOfColumn(column, drawn.y);
#ifdef RUNS
    int lastRun = lixels.y >= lixels.x ? lixels.y / LX_WARP_RUN : -1;
    for (int run = lixels.x / LX_WARP_RUN; run <= lastRun; ++run) {
        if (missesBox(drawn.triangle, runs[column * int(setup.size.z) + run])) continue;
        drawLixels(drawn, column, max(run * LX_WARP_RUN, lixels.x), min(run * LX_WARP_RUN + LX_WARP_RUN - 1, lixels.y));
    }
#else
    drawLixels(drawn, column, lixels.x, lixels.y);
#endif
}

void main()
{
    int sharing = kInvocations[queue];
    uint each = gl_WorkGroupSize.x / uint(sharing); // triangles of a work group
    int own = int(gl_LocalInvocationID.x) % sharing + int(gl_WorkGroupID.y) * sharing;
    int stride = sharing * int(gl_NumWorkGroups.y);
    uint first = gl_WorkGroupID.x * each + gl_LocalInvocationID.x / uint(sharing);
    for (uint index = first; index < queues[queue].count; index += gl_NumWorkGroups.x * each) {
        uvec2 entry = queued[uint(queue) * capacity + index];
        ivec2 columns = ivec2(entry.y & 0xffffu, entry.y >> 16u);
        Drawn drawn;
        if (!drawnTriangle(entry.x, drawn)) continue;
        for (int column = columns.x + own; column <= columns.y; column += stride) drawColumn(drawn, column);
    }
}
