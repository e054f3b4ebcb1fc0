// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

// From importance along lines, side by side, to a monotone function for each.
//
//   T. Milet et al. 2015, section 3.1: equations 1 to 4, smoothing among lines; P. Rosen 2012: smoothing along the line.
//
//   Differs  functions are kept, where the paper keeps their offsets o(x) = g(x)/N - x. Smoothing averages importance before the sums
//            of equation 2 and not functions after them: the same, where functions are weighted by their number of samples, as the
//            paper proposes. Density goes with what was averaged to a power: 1 gives the paper's equal counts; of lixels that cost
//            errors as one over the root of their density, errors are least at 2/3. A floor under the density keeps functions
//            invertible
namespace lixel {

struct LineOptions
{
    double smooth =
        0; // lines within this share of all of them, on either side, count too, the less the farther away they are
    double power = 1;
    double floor = 0; // of the density, as a share of its mean along the line; at least kLeastFloor
};

// So that floats tell neighbouring knots apart on grids of up to 1024 cells.
inline constexpr double kLeastFloor = 1.0 / 1024;
// Of the average line, in every line: too little to be seen where there are samples, and the whole of it where there are none.
inline constexpr double kOfAverage = 1e-3;

// Room to work in.
struct LineScratch
{
    std::vector<double> once, sums, averaged, line;
};

// `importance` has `lines` times `cells` values, line by line. Appends cells + 1 knots a line: from 0 to 1, each steeper than the floor.
// A line without importance, its neighbours' included, takes the average of all; where there is none at all, even steps.
void appendLineFunctions(std::span<const std::uint32_t> importance, int lines, int cells, const LineOptions& options,
                         LineScratch& scratch, std::vector<float>& knots);

} // namespace lixel
