// SPDX-License-Identifier: MIT
#include "lixel/plan/warp/texture_warp.h"

namespace lixel {
namespace {

float sharedKind(WarpLines lines)
{
    switch (lines) {
    case WarpLines::Rectilinear: return shared::LX_WARP_RECTILINEAR;
    case WarpLines::Nearest: return shared::LX_WARP_NEAREST;
    case WarpLines::Interpolated: return shared::LX_WARP_INTERPOLATED;
    }
    return shared::LX_WARP_NONE;
}

} // namespace

shared::ShadowWarp tableRow(const TextureWarp& warp)
{
    shared::ShadowWarp row;
    if (warp.isIdentity()) return row;
    row.kind.x = sharedKind(warp.lines);
    row.grid = {0, float(warp.columns), float(warp.rows), float(warp.rowKnots.size())};
    row.square = {float(warp.square.x0), float(warp.square.y0), float(warp.square.x1), float(warp.square.y1)};
    return row;
}

shared::ShadowWarp appendWarp(const TextureWarp& warp, std::vector<float>& knots)
{
    shared::ShadowWarp row = tableRow(warp);
    if (warp.isIdentity()) return row;
    row.grid.x += float(knots.size());
    row.grid.w += float(knots.size());
    knots.insert(knots.end(), warp.rowKnots.begin(), warp.rowKnots.end());
    knots.insert(knots.end(), warp.columnKnots.begin(), warp.columnKnots.end());
    return row;
}

} // namespace lixel
