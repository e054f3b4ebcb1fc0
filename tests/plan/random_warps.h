// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/warp/texture_warp.h"
#include "support/random_cases.h"

namespace lixel::test {

// A function of one axis: steps that differ by up to `strength` to 1, none shorter than a twentieth of the mean.
inline void appendAnyFunction(int cells, double strength, Rng& rng, std::vector<float>& knots)
{
    std::vector<double> steps;
    double sum = 0;
    for (int i = 0; i < cells; ++i) {
        steps.push_back(rng.logUniform(1, strength));
        sum += steps.back();
    }
    double below = 0;
    knots.push_back(0);
    for (int i = 0; i < cells; ++i) {
        below += 0.05 / cells + 0.95 * steps[std::size_t(i)] / sum;
        knots.push_back(i + 1 < cells ? float(below) : 1.0f);
    }
}

// Functions of all kinds, as different from line to line as anything makes them, or the same for all lines.
inline TextureWarp anyWarp(const LixelRectangle& square, Rng& rng)
{
    TextureWarp warp;
    const WarpLines kinds[] = {WarpLines::Rectilinear, WarpLines::Nearest, WarpLines::Interpolated};
    warp.lines = kinds[rng.integer(0, 2)];
    warp.columns = rng.integer(1, 40);
    warp.rows = rng.integer(1, 40);
    warp.square = square;
    const double strength = rng.chance(0.1) ? 1 : rng.logUniform(1, 50);
    const bool isOne = warp.lines == WarpLines::Rectilinear;
    for (int i = 0; i < (isOne ? 1 : warp.rows); ++i) appendAnyFunction(warp.columns, strength, rng, warp.rowKnots);
    for (int i = 0; i < (isOne ? 1 : warp.columns); ++i) appendAnyFunction(warp.rows, strength, rng, warp.columnKnots);
    return warp;
}

} // namespace lixel::test
