// SPDX-License-Identifier: MIT
// The greatest importance in each column of a map, or in each row, and the same smoothed along: what rectilinear warps are made from.
//   SMOOTH   the mean over cells within reach, at the ends over those that there are, rounded
#include "lixel/shared/gl_slots.h"

layout(local_size_x = 64) in;

layout(std430, binding = kStorageImportance) buffer Importance { uint importance[]; };

layout(location = 0) uniform int from; // first entry that is read
layout(location = 1) uniform int to;   // first that is written
layout(location = 2) uniform int cells; // that are written
#ifdef SMOOTH
layout(location = 3) uniform int reach;
#else
layout(location = 3) uniform int across;  // entries that are looked at for each
layout(location = 4) uniform ivec2 steps; // from one cell to the next, and across
#endif

void main()
{
    int cell = int(gl_GlobalInvocationID.x);
    if (cell >= cells) return;
#ifdef SMOOTH
    int first = max(0, cell - reach), end = min(cells, cell + reach + 1);
    double sum = 0.0LF;
    for (int i = first; i < end; ++i) sum += double(importance[from + i]);
    importance[to + cell] = uint(floor(sum / double(end - first) + 0.5LF));
#else
    uint greatest = 0u;
    for (int i = 0; i < across; ++i) greatest = max(greatest, importance[from + cell * steps.x + i * steps.y]);
    importance[to + cell] = greatest;
#endif
}
