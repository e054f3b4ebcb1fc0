// SPDX-License-Identifier: MIT
// Marks the cells of an observation that have a neighbour across a jump in depth or across a shadow's boundary.
#include "lixel/shared/gl_slots.h"
#include "lixel/shared/observe.h"

layout(local_size_x = 64) in;

layout(std430, binding = kStorageCells) buffer Cells { ObservedPoint cells[]; };

layout(location = 0) uniform ivec2 grid;

uint atBoundary = 0u, atDepthJump = 0u;

void look(ObservedPoint own, ivec2 at)
{
    if (at.x < 0 || at.y < 0 || at.x >= grid.x || at.y >= grid.y) return;
    ObservedPoint other = cells[at.y * grid.x + at.x];
    if (other.point.pixel == kNoPixel || lxIsDepthJump(own.point.positionLocal, own.point.normal,
                                                       other.point.positionLocal, other.point.normal))
        atDepthJump = 1u;
    else atBoundary |= (own.lit ^ other.lit) & own.facing & other.facing;
}

// Only what no other cell reads is written.
void main()
{
    int cell = int(gl_GlobalInvocationID.x);
    if (cell >= grid.x * grid.y) return;
    ObservedPoint own = cells[cell];
    if (own.point.pixel == kNoPixel) return;
    ivec2 at = ivec2(cell % grid.x, cell / grid.x);
    look(own, at + ivec2(1, 0));
    look(own, at - ivec2(1, 0));
    look(own, at + ivec2(0, 1));
    look(own, at - ivec2(0, 1));
    cells[cell].atBoundary = atBoundary;
    cells[cell].atDepthJump = atDepthJump;
}
