// SPDX-License-Identifier: MIT
// The cells of an observation: the sample of each cell's pixel, which lights it faces and which of them reach it.
#include "lixel/shared/gl_slots.h"
#include "lixel/shared/observe.h"

layout(local_size_x = 64) in;

layout(std430, binding = kStoragePoints) readonly buffer Points { ViewPoint points[]; };
layout(std430, binding = kStorageVisibility) readonly buffer Visibilities { float visibility[]; };
layout(std430, binding = kStorageShadingLights) readonly buffer Lights { ShadingLight lights[]; };
layout(std430, binding = kStorageCells) writeonly buffer Cells { ObservedPoint cells[]; };

layout(location = 0) uniform ivec2 grid;
layout(location = 1) uniform ivec2 picture;
layout(location = 2) uniform uint firstPoint; // of this part of the list
layout(location = 3) uniform uint pointCount; // in it
layout(location = 4) uniform int lightCount;

void main()
{
    int cell = int(gl_GlobalInvocationID.x);
    if (cell >= grid.x * grid.y) return;
    int x = lxPixelOfCell(cell % grid.x, grid.x, picture.x);
    int y = lxPixelOfCell(cell / grid.x, grid.y, picture.y);
    uint index = uint(y) * uint(picture.x) + uint(x);
    uint entry = index - firstPoint;
    if (index < firstPoint || entry >= pointCount) return; // another part's

    ViewPoint point = points[entry];
    uint lit = 0u, facing = 0u;
    if (point.pixel != kNoPixel)
        for (int i = 0; i < lightCount; ++i) {
            if (!lxFaces(lights[i], point.positionLocal, point.normal)) continue;
            facing |= 1u << i;
            if (lxIsLit(visibility[uint(i) * pointCount + entry])) lit |= 1u << i;
        }
    cells[cell] = ObservedPoint(point, lit, facing, 0u, 0u);
}
