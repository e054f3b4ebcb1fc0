// SPDX-License-Identifier: MIT
// The ray of each lixel of a warped map: where its centre lies in the region's NDC square before the warp, the inverse of
// lixel/shared/warp.h. An invocation walks up a piece of a column, whose place along y only grows and along x changes little, and
// so finds each knot beside the last one. Also the box around the rays of each run of a column.
#include "lixel/gl/shaders/warp_knots.glsl"
#include "lixel/gl/shaders/warp_region.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = kStorageWarpRays) writeonly buffer Rays { vec2 rays[]; }; // column by column
layout(std430, binding = kStorageWarpRuns) writeonly buffer Runs { vec4 runs[]; }; // least x, y, greatest x, y; likewise

const int kPiece = 4 * LX_WARP_RUN; // lixels

// A cell of a function's knots, and the knots around it.
struct Cell
{
    int index;
    float low, high;
};

float knot(LxWarpLines l, int cells, int i)
{
    if (i == 0) return 0.0;
    return i == cells ? 1.0 : lxKnotBetween(l, i);
}

Cell cellAt(LxWarpLines l, int cells, int index)
{
    return Cell(index, knot(l, cells, index), knot(l, cells, index + 1));
}

Cell nearCell(Cell cell, LxWarpLines l, int cells, float value)
{
    while (cell.high <= value && cell.index < cells - 1) {
        ++cell.index;
        cell.low = cell.high;
        cell.high = knot(l, cells, cell.index + 1);
    }
    while (cell.low > value && cell.index > 0) {
        --cell.index;
        cell.high = cell.low;
        cell.low = knot(l, cells, cell.index);
    }
    return cell;
}

// Where the function has the value; outside [0, 1] the identity.
float placeIn(Cell cell, int cells, float value)
{
    if (!(value > 0.0) || !(value < 1.0)) return value;
    return (float(cell.index) + clamp((value - cell.low) / (cell.high - cell.low), 0.0, 1.0)) / float(cells);
}

int cellOf(float place, int cells) { return clamp(int(floor(place * float(cells))), 0, cells - 1); }

void main()
{
    ivec2 size = mapSize();
    int piece = int(gl_GlobalInvocationID.x);
    int column = piece % size.x;
    int first = piece / size.x * kPiece;
    if (first >= size.y) return;

    ShadowWarp warp = region.warp;
    vec2 side = warp.square.zw - warp.square.xy;
    vec2 begin = (region.rectangle.xy - warp.square.xy) / side;
    int columns = int(warp.grid.y), rows = int(warp.grid.z);
    vec2 ndcScale = side / region.lixelFromNdc.xy;
    vec2 ndcOffset = (warp.square.xy - region.lixelFromNdc.zw) / region.lixelFromNdc.xy;

    vec2 at = begin + (vec2(column, first) + 0.5) / side;
    LxWarpLines ofColumn = lxColumnLines(warp, at.x);
    vec2 ray = lxUnwarped(warp, at);
    Cell cellY = cellAt(ofColumn, rows, cellOf(ray.y, rows));
    int indexX = cellOf(ray.x, columns);
    vec4 box = vec4(0.0);
    for (int y = first; y < min(first + kPiece, size.y); ++y) {
        at.y = begin.y + (float(y) + 0.5) / side.y;
        cellY = nearCell(cellY, ofColumn, rows, at.y);
        ray.y = placeIn(cellY, rows, at.y);
        LxWarpLines ofRow = lxRowLines(warp, ray.y);
        Cell cellX = nearCell(cellAt(ofRow, columns, indexX), ofRow, columns, at.x);
        indexX = cellX.index;
        ray.x = placeIn(cellX, columns, at.x);
        vec2 ndc = ray * ndcScale + ndcOffset;
        rays[column * size.y + y] = ndc;
        box = y % LX_WARP_RUN == 0 ? vec4(ndc, ndc) : vec4(min(box.xy, ndc), max(box.zw, ndc));
        if ((y + 1) % LX_WARP_RUN == 0 || y + 1 == size.y) runs[column * int(setup.size.z) + y / LX_WARP_RUN] = box;
    }
}
