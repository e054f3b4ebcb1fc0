// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/warp/texture_warp.h"
#include "lixel/plan/warp/warp_choice.h"
#include "lixel/plan/warp/warp_scratch.h"

#include <span>

namespace lixel {

// The rectilinear warp: one function of x for all rows, one of y for all columns, each from the greatest importance in every column
// and every row.
//
//   P. Rosen. Rectilinear Texture Warping for Fast Adaptive Shadow Mapping. 2012; as Milet et al. 2015, section 2.2, describe it.
//
//   Needs    samples within the square; columns, rows and square of `out`
//   Returns  knots and lines of `out`
//   Differs  the power of the density, 1 in the paper, and the floor
void makeRtw(std::span<const PlacedSample> samples, const RtwWarp& choice, WarpScratch& scratch, TextureWarp& out);

} // namespace lixel
