// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/warp/texture_warp.h"
#include "lixel/plan/warp/warp_choice.h"
#include "lixel/plan/warp/warp_scratch.h"

#include <span>

namespace lixel {

// The non-orthogonal warp: every row of the map has its own function of x, and every column of the map so warped its own of y, so that
// all lixels serve as many samples.
//
//   T. Milet, J. Navratil, P. Zemcik. An Improved Non-Orthogonal Texture Warping for Better Shadow Rendering. 2015, section 3,
//   steps 2 to 7, equations 1 to 6.
//
//   Needs    samples within the square; columns, rows and square of `out`
//   Returns  knots and lines of `out`. Without samples, or with all importance even, the identity
//   Differs  where line_functions.h does; functions are interpolated between lines, unless they are to be the paper's
void makeNow(std::span<const PlacedSample> samples, const NowWarp& choice, WarpScratch& scratch, TextureWarp& out);

} // namespace lixel
