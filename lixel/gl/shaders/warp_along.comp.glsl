// SPDX-License-Identifier: MIT
// From what importance is among lines to the knots of each line's function (lixel/plan/warp/line_functions.h). An invocation a line.
#include "lixel/shared/gl_slots.h"

layout(local_size_x = 64) in;

layout(std430, binding = kStorageLineSums) buffer Sums { float sums[]; }; // as in warp_among.comp.glsl
layout(std430, binding = kStorageWarps) writeonly buffer Warps { float warpKnots[]; };

layout(location = 0) uniform int firstKnot;
layout(location = 1) uniform int lines;
layout(location = 2) uniform int cells; // of a line
layout(location = 3) uniform float power;
layout(location = 4) uniform float floorShare;
layout(location = 5) uniform float ofAverage;

void main()
{
    int line = int(gl_GlobalInvocationID.x);
    if (line >= lines) return;
    int begin = (lines + line) * cells, average = 2 * lines * cells;
    double total = 0.0LF;
    for (int i = 0; i < cells; ++i) {
        float among = sums[begin + i] + ofAverage * sums[average + i];
        float density = power == 1.0 || among <= 0.0 ? among : pow(among, power);
        sums[begin + i] = density;
        total += double(density);
    }
    int knot = firstKnot + line * (cells + 1);
    double even = 1.0LF / double(cells), below = 0.0LF;
    warpKnots[knot] = 0.0;
    for (int i = 0; i + 1 < cells; ++i) {
        below += total > 0.0LF ? double(floorShare) * even + (1.0LF - double(floorShare)) * double(sums[begin + i]) / total : even;
        warpKnots[knot + i + 1] = float(below);
    }
    warpKnots[knot + cells] = 1.0;
}
