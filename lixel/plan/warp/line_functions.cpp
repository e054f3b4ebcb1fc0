// SPDX-License-Identifier: MIT
#include "lixel/plan/warp/line_functions.h"

#include "lixel/base/assert.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace lixel {
namespace {

// The sum over lines within `reach` of each, cell by cell.
template <typename Value>
void sumAmongLines(std::span<const Value> importance, int lines, int cells, int reach, std::vector<double>& sums)
{
    const auto n = std::size_t(cells);
    sums.assign(std::size_t(lines) * n, 0);
    for (std::size_t cell = 0; cell < n; ++cell) {
        double sum = 0;
        for (int line = 0; line < std::min(reach, lines); ++line)
            sum += double(importance[std::size_t(line) * n + cell]);
        for (int line = 0; line < lines; ++line) {
            if (line + reach < lines) sum += double(importance[std::size_t(line + reach) * n + cell]);
            if (line - reach > 0) sum -= double(importance[std::size_t(line - reach - 1) * n + cell]);
            sums[std::size_t(line) * n + cell] = std::max(sum, 0.0);
        }
    }
}

} // namespace

void appendLineFunctions(std::span<const std::uint32_t> importance, int lines, int cells, const LineOptions& options,
                         LineScratch& scratch, std::vector<float>& knots)
{
    LX_ASSERT(importance.size() == std::size_t(lines) * std::size_t(cells));
    const auto n = std::size_t(cells);
    const int reach = std::min(int(std::lround(options.smooth * lines)), lines);
    // Two sums, one after the other, weigh lines by their distance; over all lines one is enough.
    sumAmongLines(importance, lines, cells, reach < lines ? reach / 2 : lines, scratch.once);
    sumAmongLines(std::span<const double>(scratch.once), lines, cells, reach - reach / 2, scratch.sums);
    scratch.averaged.assign(n, 0);
    for (std::size_t i = 0; i < importance.size(); ++i) scratch.averaged[i % n] += double(importance[i]);
    for (double& a : scratch.averaged) a *= kOfAverage / lines;

    const double floor = std::clamp(options.floor, kLeastFloor, 1.0);
    for (std::size_t line = 0; line < std::size_t(lines); ++line) {
        scratch.line.assign(n, 0);
        double total = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const double among = scratch.sums[line * n + i] + scratch.averaged[i];
            total += scratch.line[i] = options.power == 1 ? among : std::pow(among, options.power);
        }
        double below = 0;
        knots.push_back(0);
        for (std::size_t i = 0; i + 1 < n; ++i) {
            const double even = 1.0 / double(cells);
            below += total > 0 ? floor * even + (1 - floor) * scratch.line[i] / total : even;
            knots.push_back(float(below));
        }
        knots.push_back(1);
    }
}

} // namespace lixel
