// SPDX-License-Identifier: MIT
// Which lixels of a warped map a box of the region's square can come to: columns by bounds of the functions of x over blocks of
// lines, then the lixels of each column by its own function of y.
#include "lixel/gl/shaders/warp_knots.glsl"
#include "lixel/gl/shaders/warp_region.glsl"

layout(std430, binding = kStorageWarpBounds) readonly buffer Bounds { vec2 bounds[]; };

// Lixels: more than what floats round on the way to the map and back.
const float kLixelRounding = 1.0 / 64.0;
const int kMostLines = 6; // that are looked at one by one
const int kMostBlocks = 5;

// A place of the square between two knots.
struct BetweenKnots
{
    int cell;
    float share;
};

BetweenKnots betweenKnots(float place, int cells)
{
    float scaled = place * float(cells);
    int cell = clamp(int(floor(scaled)), 0, cells - 1);
    return BetweenKnots(cell, scaled - float(cell));
}

float functionAt(int firstKnot, BetweenKnots at)
{
    return mix(lxWarpKnot(firstKnot + at.cell), lxWarpKnot(firstKnot + at.cell + 1), at.share);
}

// What a range comes to whose ends are moved to these: outside the square nothing is.
vec2 movedWithin(vec2 range, vec2 moved)
{
    bvec2 isInside = bvec2(range.x > 0.0 && range.x < 1.0, range.y > 0.0 && range.y < 1.0);
    return mix(range, moved, isInside);
}

// What [x.x, x.y] comes to over the lines that serve [y.x, y.y]. Between two knots the functions of a block lie between the straight
// lines through its bounds.
vec2 warpedX(vec2 x, vec2 y)
{
    ShadowWarp warp = region.warp;
    int cells = int(warp.grid.y), knots = cells + 1;
    int lines = warp.kind.x == LX_WARP_RECTILINEAR ? 1 : int(warp.grid.z);
    int first = clamp(int(floor(y.x * float(lines) - 0.51)), 0, lines - 1);
    int last = clamp(int(floor(y.y * float(lines) + 0.51)), 0, lines - 1);
    BetweenKnots from = betweenKnots(x.x, cells), to = betweenKnots(x.y, cells);
    vec2 range = vec2(1.0, 0.0);
    bool isOneByOne = last - first < kMostLines;
    for (int line = first; isOneByOne && line <= last; ++line) {
        int at = int(warp.grid.x) + line * knots;
        range = vec2(min(range.x, functionAt(at, from)), max(range.y, functionAt(at, to)));
    }
    int level = 0;
    first /= LX_BOUND_LINES;
    last /= LX_BOUND_LINES;
    while (last - first >= kMostBlocks) {
        first /= LX_BOUND_BLOCKS;
        last /= LX_BOUND_BLOCKS;
        ++level;
    }
    for (int block = first; !isOneByOne && block <= last; ++block) {
        int at = int(setup.levels[level].x) + block * knots;
        float low = mix(bounds[at + from.cell].x, bounds[at + from.cell + 1].x, from.share);
        float high = mix(bounds[at + to.cell].y, bounds[at + to.cell + 1].y, to.share);
        range = vec2(min(range.x, low), max(range.y, high));
    }
    return movedWithin(x, range);
}

// Of the region's NDC, in the square that is warped.
vec4 squareFromNdc(vec4 box)
{
    vec2 side = region.warp.square.zw - region.warp.square.xy;
    vec4 lixels = box * region.lixelFromNdc.xyxy + region.lixelFromNdc.zwzw;
    return (lixels - region.warp.square.xyxy) / side.xyxy;
}

// First and last lixel of the rectangle's [0, count) whose centre is in the range of the square, which begins at `begin` and has `side`
// lixels.
ivec2 centresIn(vec2 range, float begin, float side, float count)
{
    float first = ceil(range.x * side + begin - 0.5 - kLixelRounding);
    float last = floor(range.y * side + begin - 0.5 + kLixelRounding);
    return ivec2(max(first, 0.0), min(last, count - 1.0));
}

// First and last column, of lixels of the rectangle, that have something of a box of the square.
ivec2 columnsOf(vec4 box)
{
    vec4 square = region.warp.square;
    return centresIn(warpedX(box.xz, box.yw), square.x - region.rectangle.x, square.z - square.x, setup.size.x);
}

// First and last lixel of a column whose ray has a y in this range of the square.
ivec2 lixelsOfColumn(int column, vec2 y)
{
    ShadowWarp warp = region.warp;
    float across = (region.rectangle.x + float(column) + 0.5 - warp.square.x) / (warp.square.z - warp.square.x);
    LxWarpLines lines = lxColumnLines(warp, across);
    int cells = int(warp.grid.z);
    BetweenKnots from = betweenKnots(y.x, cells), to = betweenKnots(y.y, cells);
    float low = functionAt(lines.first, from), high = functionAt(lines.first, to);
    if (lines.share > 0.0) {
        low = mix(low, functionAt(lines.second, from), lines.share);
        high = mix(high, functionAt(lines.second, to), lines.share);
    }
    return centresIn(movedWithin(y, vec2(low, high)), warp.square.y - region.rectangle.y, warp.square.w - warp.square.y, setup.size.y);
}
