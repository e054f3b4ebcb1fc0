// SPDX-License-Identifier: MIT
#include "lixel/plan/warp/rtw.h"

#include <algorithm>
#include <cmath>

namespace lixel {
namespace {

// The mean over neighbours within `reach`, at the ends over those that there are; rounded, as importance is in integers.
void smoothAlong(std::vector<std::uint32_t>& line, int reach, std::vector<double>& sums)
{
    const int cells = int(line.size());
    sums.assign(line.size() + 1, 0);
    for (std::size_t i = 0; i < line.size(); ++i) sums[i + 1] = sums[i] + double(line[i]);
    for (int i = 0; i < cells; ++i) {
        const int first = std::max(0, i - reach), end = std::min(cells, i + reach + 1);
        const double sum = sums[std::size_t(end)] - sums[std::size_t(first)];
        line[std::size_t(i)] = std::uint32_t(std::llround(sum / (end - first)));
    }
}

void appendFunction(const WarpOptions& options, WarpScratch& scratch, std::vector<float>& knots)
{
    std::vector<std::uint32_t>& greatest = scratch.greatest;
    const int cells = int(greatest.size()), reach = int(std::lround(options.smooth * cells));
    smoothAlong(greatest, reach / 2, scratch.lines.sums);
    smoothAlong(greatest, reach - reach / 2, scratch.lines.sums);
    appendLineFunctions(greatest, 1, cells, {0, options.power, options.floor}, scratch.lines, knots);
}

} // namespace

void makeRtw(std::span<const PlacedSample> samples, const RtwWarp& choice, WarpScratch& scratch, TextureWarp& out)
{
    out.lines = WarpLines::Rectilinear;
    out.rowKnots.clear();
    out.columnKnots.clear();
    const auto columns = std::size_t(out.columns), rows = std::size_t(out.rows);
    countSamples(samples, out.columns, out.rows, choice.options.importance.isCounted, scratch.map);
    const auto takeGreatest = [&](std::size_t cells, const auto& cellOf) {
        scratch.greatest.assign(cells, 0);
        for (std::size_t i = 0; i < scratch.map.size(); ++i) {
            std::uint32_t& greatest = scratch.greatest[cellOf(i)];
            greatest = std::max(greatest, scratch.map[i]);
        }
    };
    takeGreatest(columns, [&](std::size_t i) { return i % columns; });
    appendFunction(choice.options, scratch, out.rowKnots);
    takeGreatest(rows, [&](std::size_t i) { return i / columns; });
    appendFunction(choice.options, scratch, out.columnKnots);
}

} // namespace lixel
