// SPDX-License-Identifier: MIT
// Where a point of a region's square lies after its texture warp, and back: one text for the CPU executor and for GLSL.
//
//   P. Rosen. Rectilinear Texture Warping for Fast Adaptive Shadow Mapping. 2012.
//   T. Milet, J. Navratil, P. Zemcik. An Improved Non-Orthogonal Texture Warping for Better Shadow Rendering. 2015, equation 6.
//
// A warp has a grid of n columns and m rows over the square. It moves along x first, by functions of x that stand one a row, and
// then along y, by functions of y that stand one a column *of the warped x*: so it inverts in two steps of one dimension, y
// through the column of the warped point, then x through the row. Each function is linear between its knots, which stand at the
// borders of the grid's cells (n + 1 of x, m + 1 of y), grows strictly, and takes 0 to 0 and 1 to 1. Rectilinear warps have one
// function for all rows and one for all columns. Outside the square a warp is the identity along that axis, its functions those
// of the nearest row or column, so that guard bands stay.
//
// The includer provides the knots: in GLSL a function `float lxWarpKnot(int i)` before this file, in C++ a callable of the same
// form as the template argument Knots, which may be left out where no region has a warp.
#ifndef LIXEL_SHARED_WARP_H
#define LIXEL_SHARED_WARP_H
#include "lixel/shared/shadow_tables.h"

LX_SHARED_BEGIN

#ifdef __cplusplus
struct LxNoKnots
{
    float operator()(int) const { return 0.0f; }
};
#define LX_KNOTS_FN                                                                                                    \
    template <typename Knots = LxNoKnots>                                                                              \
    inline
#define LX_KNOTS , const Knots& lxWarpKnot = Knots()
#define LX_PASS_KNOTS , lxWarpKnot
#else
#define LX_KNOTS_FN
#define LX_KNOTS
#define LX_PASS_KNOTS
#endif

// Two neighbouring functions of one axis and the second one's share at some place.
struct LxWarpLines
{
    int first;     // index of the first one's first knot
    int second;    // of the second one's
    float share;   // in [0, 1]
    float perUnit; // how fast the share grows with the place across
};

// The functions at a place `across`, of `lines` that lie side by side, or of one for all where it is rectilinear.
LX_FN LxWarpLines lxWarpLines(ShadowWarp warp, float across, int lines, int begin, int knots)
{
    LxWarpLines l;
    l.first = begin;
    l.second = begin;
    l.share = 0.0f;
    l.perUnit = 0.0f;
    if (warp.kind.x == LX_WARP_RECTILINEAR) return l;
    float last = float(lines - 1);
    float place = across * float(lines) - 0.5f; // lines stand at the middles of their rows or columns
    if (warp.kind.x == LX_WARP_NEAREST) {
        int line = int(clamp(floor(place + 0.5f), 0.0f, last));
        l.first = begin + line * knots;
        l.second = l.first;
        return l;
    }
    float before = clamp(floor(place), 0.0f, max(last - 1.0f, 0.0f));
    l.first = begin + int(before) * knots;
    l.second = lines > 1 ? l.first + knots : l.first;
    l.share = clamp(place - before, 0.0f, 1.0f);
    l.perUnit = place > 0.0f && place < last ? float(lines) : 0.0f;
    return l;
}

LX_FN LxWarpLines lxRowLines(ShadowWarp warp, float y)
{
    return lxWarpLines(warp, y, int(warp.grid.z), int(warp.grid.x), int(warp.grid.y) + 1);
}

LX_FN LxWarpLines lxColumnLines(ShadowWarp warp, float warpedX)
{
    return lxWarpLines(warp, warpedX, int(warp.grid.y), int(warp.grid.w), int(warp.grid.z) + 1);
}

// Knot `i` between the two.
LX_KNOTS_FN float lxKnotBetween(LxWarpLines l, int i LX_KNOTS)
{
    float first = lxWarpKnot(l.first + i);
    return l.share > 0.0f ? mix(first, lxWarpKnot(l.second + i), l.share) : first;
}

// A function of one axis at a place, and how it changes there.
struct LxAlongLine
{
    float value;
    float slope;  // with the place along
    float across; // with the place across, where functions are interpolated
};

LX_KNOTS_FN LxAlongLine lxAlongLine(LxWarpLines l, int cells, float along LX_KNOTS)
{
    LxAlongLine a;
    a.value = along;
    a.slope = 1.0f;
    a.across = 0.0f;
    if (along < 0.0f || along > 1.0f) return a;
    float place = along * float(cells);
    float cell = clamp(floor(place), 0.0f, float(cells) - 1.0f);
    float share = place - cell;
    int i = int(cell);
    float first0 = lxWarpKnot(l.first + i);
    float first1 = lxWarpKnot(l.first + i + 1);
    float second0 = first0;
    float second1 = first1;
    if (l.second != l.first) {
        second0 = lxWarpKnot(l.second + i);
        second1 = lxWarpKnot(l.second + i + 1);
    }
    float low = mix(first0, second0, l.share);
    float high = mix(first1, second1, l.share);
    a.value = mix(low, high, share);
    a.slope = (high - low) * float(cells);
    a.across = (mix(second0, second1, share) - mix(first0, first1, share)) * l.perUnit;
    return a;
}

// Knots of a line around a value: lowValue <= value < highValue.
struct LxKnotRange
{
    int low;
    int high;
    float lowValue;
    float highValue;
};

// All of the line.
LX_FN LxKnotRange lxWholeLine(int cells)
{
    LxKnotRange r;
    r.low = 0;
    r.high = cells;
    r.lowValue = 0.0f;
    r.highValue = 1.0f;
    return r;
}

// A small range, by ever longer steps from the cell of a place that the value's is expected to be near.
LX_KNOTS_FN LxKnotRange lxKnotsNear(LxWarpLines l, int cells, float value, float start LX_KNOTS)
{
    LxKnotRange r;
    r.low = int(clamp(floor(start * float(cells)), 0.0f, float(cells) - 1.0f));
    r.high = r.low + 1;
    r.lowValue = r.low > 0 ? lxKnotBetween(l, r.low LX_PASS_KNOTS) : 0.0f;
    r.highValue = r.high < cells ? lxKnotBetween(l, r.high LX_PASS_KNOTS) : 1.0f;
    for (int step = 1; r.lowValue > value; step *= 2) {
        r.high = r.low;
        r.highValue = r.lowValue;
        r.low = max(r.low - step, 0);
        r.lowValue = r.low > 0 ? lxKnotBetween(l, r.low LX_PASS_KNOTS) : 0.0f;
    }
    for (int step = 1; r.highValue <= value; step *= 2) {
        r.low = r.high;
        r.lowValue = r.highValue;
        r.high = min(r.high + step, cells);
        r.highValue = r.high < cells ? lxKnotBetween(l, r.high LX_PASS_KNOTS) : 1.0f;
    }
    return r;
}

// Where the function of one axis has a value between 0 and 1, that its knots of a range are around.
LX_KNOTS_FN float lxWhereInRange(LxWarpLines l, int cells, float value, LxKnotRange r LX_KNOTS)
{
    while (r.high - r.low > 1) {
        int middle = (r.low + r.high) / 2;
        float at = lxKnotBetween(l, middle LX_PASS_KNOTS);
        if (at <= value) {
            r.low = middle;
            r.lowValue = at;
        } else {
            r.high = middle;
            r.highValue = at;
        }
    }
    return (float(r.low) + clamp((value - r.lowValue) / (r.highValue - r.lowValue), 0.0f, 1.0f)) / float(cells);
}

// Where the function of one axis has a value: its inverse. Outside [0, 1] the identity.
LX_KNOTS_FN float lxWhereAlongLine(LxWarpLines l, int cells, float value LX_KNOTS)
{
    if (!(value > 0.0f) || !(value < 1.0f)) return value;
    return lxWhereInRange(l, cells, value, lxWholeLine(cells) LX_PASS_KNOTS);
}

// The same, found sooner where it is near a place.
LX_KNOTS_FN float lxWhereAlongLineNear(LxWarpLines l, int cells, float value, float start LX_KNOTS)
{
    if (!(value > 0.0f) || !(value < 1.0f)) return value;
    return lxWhereInRange(l, cells, value, lxKnotsNear(l, cells, value, start LX_PASS_KNOTS) LX_PASS_KNOTS);
}

// A point of the square, warped, and the derivatives of where it comes to.
struct LxWarped
{
    vec2 at;
    vec2 alongX; // d at / d x of the point that was warped
    vec2 alongY; // d at / d y
};

LX_KNOTS_FN LxWarped lxWarped(ShadowWarp warp, vec2 point LX_KNOTS)
{
    LxAlongLine x = lxAlongLine(lxRowLines(warp, point.y), int(warp.grid.y), point.x LX_PASS_KNOTS);
    LxAlongLine y = lxAlongLine(lxColumnLines(warp, x.value), int(warp.grid.z), point.y LX_PASS_KNOTS);
    LxWarped w;
    w.at = vec2(x.value, y.value);
    w.alongX = vec2(x.slope, y.across * x.slope);
    w.alongY = vec2(x.across, y.slope + y.across * x.across);
    return w;
}

// The point that is warped to here.
LX_KNOTS_FN vec2 lxUnwarped(ShadowWarp warp, vec2 at LX_KNOTS)
{
    float y = lxWhereAlongLine(lxColumnLines(warp, at.x), int(warp.grid.z), at.y LX_PASS_KNOTS);
    float x = lxWhereAlongLine(lxRowLines(warp, y), int(warp.grid.y), at.x LX_PASS_KNOTS);
    return vec2(x, y);
}

// The same, found sooner where that is near another point.
LX_KNOTS_FN vec2 lxUnwarpedNear(ShadowWarp warp, vec2 at, vec2 start LX_KNOTS)
{
    float y = lxWhereAlongLineNear(lxColumnLines(warp, at.x), int(warp.grid.z), at.y, start.y LX_PASS_KNOTS);
    float x = lxWhereAlongLineNear(lxRowLines(warp, y), int(warp.grid.y), at.x, start.x LX_PASS_KNOTS);
    return vec2(x, y);
}

// The two in lixels of the region's layer.
LX_FN vec2 lxInSquare(ShadowWarp warp, vec2 lixel)
{
    return vec2((lixel.x - warp.square.x) / (warp.square.z - warp.square.x),
                (lixel.y - warp.square.y) / (warp.square.w - warp.square.y));
}

LX_FN vec2 lxOfSquare(ShadowWarp warp, vec2 point)
{
    return vec2(warp.square.x + point.x * (warp.square.z - warp.square.x),
                warp.square.y + point.y * (warp.square.w - warp.square.y));
}

LX_KNOTS_FN LxWarped lxWarpedLixel(ShadowWarp warp, vec2 lixel LX_KNOTS)
{
    LxWarped w = lxWarped(warp, lxInSquare(warp, lixel) LX_PASS_KNOTS);
    float heightPerWidth = (warp.square.w - warp.square.y) / (warp.square.z - warp.square.x);
    w.at = lxOfSquare(warp, w.at);
    w.alongX.y *= heightPerWidth;
    w.alongY.x /= heightPerWidth;
    return w;
}

LX_KNOTS_FN vec2 lxUnwarpedLixel(ShadowWarp warp, vec2 lixel LX_KNOTS)
{
    return lxOfSquare(warp, lxUnwarped(warp, lxInSquare(warp, lixel) LX_PASS_KNOTS));
}

LX_KNOTS_FN vec2 lxUnwarpedLixelNear(ShadowWarp warp, vec2 lixel, vec2 start LX_KNOTS)
{
    vec2 at = lxUnwarpedNear(warp, lxInSquare(warp, lixel), lxInSquare(warp, start) LX_PASS_KNOTS);
    return lxOfSquare(warp, at);
}

LX_SHARED_END

#endif
