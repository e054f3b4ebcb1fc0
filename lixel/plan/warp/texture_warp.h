// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/vec.h"
#include "lixel/plan/light_image.h"
#include "lixel/shared/warp.h"

#include <vector>

namespace lixel {

// How the functions of a texture warp stand (lixel/shared/warp.h has what they mean).
enum class WarpLines {
    Rectilinear, // one function for all rows, one for all columns (Rosen 2012)
    Nearest, // one a row and one a column of the grid; a point takes those it lies in (Milet et al. 2015, equation 6)
    Interpolated // it takes what lies between the middles of the nearest two
};

// How triangles get into a warped map, where hardware draws straight edges only.
enum class WarpRaster {
    Vertices,   // vertices are moved, edges stay straight
    Tessellate, // triangles over which the warp bends are cut up first (Milet et al. 2015, section 4.1)
    Exact       // coverage and depth are those of the ray through the middle of each lixel
};

// The warp of one region's square. Knots go function by function: of rows columns + 1 each, of columns rows + 1 each; each
// function begins at 0, ends at 1 and grows strictly. Without columns it is the identity.
struct TextureWarp
{
    WarpLines lines = WarpLines::Interpolated;
    WarpRaster raster = WarpRaster::Exact; // of executors that rasterise
    int columns = 0, rows = 0;
    std::vector<float> rowKnots, columnKnots;
    LixelRectangle square = {}; // lixels that are warped; around them guard bands stay

    bool isIdentity() const { return columns == 0; }
    friend bool operator==(const TextureWarp&, const TextureWarp&) = default;
};

// The warp as shaders read it, by itself: its rows' knots first, then its columns'.
shared::ShadowWarp tableRow(const TextureWarp& warp);

// Its knots in that order, for the functions of lixel/shared/warp.h.
struct KnotsOf
{
    const float* rowKnots;
    const float* columnKnots;
    int countOfRows;

    float operator()(int i) const { return i < countOfRows ? rowKnots[i] : columnKnots[i - countOfRows]; }
};
inline KnotsOf knotsOf(const TextureWarp& warp)
{
    return {warp.rowKnots.data(), warp.columnKnots.data(), int(warp.rowKnots.size())};
}

// Of the region's row of the table: its knots are appended to the table of all.
shared::ShadowWarp appendWarp(const TextureWarp& warp, std::vector<float>& knots);

} // namespace lixel
