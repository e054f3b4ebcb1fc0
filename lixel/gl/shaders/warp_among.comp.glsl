// SPDX-License-Identifier: MIT
// Importance summed up among the lines on either side of each: two sums, one after the other, and the average of all lines. An
// invocation a cell. In integers and doubles, so that what was added is taken off without rest.
#include "lixel/shared/gl_slots.h"

layout(local_size_x = 64) in;

layout(std430, binding = kStorageImportance) readonly buffer Importance { uint importance[]; }; // line by line
layout(std430, binding = kStorageLineSums) buffer Sums { float sums[]; }; // lines * cells: first sums, as bits; as many: both; cells: average

layout(location = 0) uniform int firstCell; // of the map, in `importance`
layout(location = 1) uniform int lines;
layout(location = 2) uniform int cells; // of a line
layout(location = 3) uniform ivec2 reach; // lines, of the first sum and of the second

void main()
{
    int cell = int(gl_GlobalInvocationID.x);
    if (cell >= cells) return;
    uint sum = 0u;
    double all = 0.0LF;
    for (int line = 0; line < min(reach.x, lines); ++line) sum += importance[firstCell + line * cells + cell];
    for (int line = 0; line < lines; ++line) {
        all += double(importance[firstCell + line * cells + cell]);
        if (line + reach.x < lines) sum += importance[firstCell + (line + reach.x) * cells + cell];
        if (line - reach.x > 0) sum -= importance[firstCell + (line - reach.x - 1) * cells + cell];
        sums[line * cells + cell] = uintBitsToFloat(sum);
    }
    int both = lines * cells;
    double twice = 0.0LF;
    for (int line = 0; line < min(reach.y, lines); ++line) twice += double(floatBitsToUint(sums[line * cells + cell]));
    for (int line = 0; line < lines; ++line) {
        if (line + reach.y < lines) twice += double(floatBitsToUint(sums[(line + reach.y) * cells + cell]));
        if (line - reach.y > 0) twice -= double(floatBitsToUint(sums[(line - reach.y - 1) * cells + cell]));
        sums[both + line * cells + cell] = float(twice);
    }
    sums[2 * both + cell] = float(all / double(lines));
}
