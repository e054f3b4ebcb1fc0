// SPDX-License-Identifier: MIT
#include "lixel/plan/warp/now.h"

namespace lixel {

void makeNow(std::span<const PlacedSample> samples, const NowWarp& choice, WarpScratch& scratch, TextureWarp& out)
{
    const WarpOptions& options = choice.options;
    const LineOptions lines{options.smooth, options.power, options.floor};
    out.lines = choice.lines;
    out.rowKnots.clear();
    out.columnKnots.clear();

    // Steps 2 to 5: a function for every row.
    countSamples(samples, out.columns, out.rows, options.importance.isCounted, scratch.map);
    appendLineFunctions(scratch.map, out.rows, out.columns, lines, scratch.lines, out.rowKnots);

    // Step 6: every sample moves along its row. Lines of the next functions are columns: the map is turned.
    const shared::ShadowWarp row = tableRow(out);
    scratch.moved.clear();
    for (const PlacedSample& s : samples) {
        const auto x = shared::lxAlongLine(shared::lxRowLines(row, s.y), out.columns, s.x, knotsOf(out));
        scratch.moved.push_back({s.y, x.value, s.units});
    }

    // Step 7: a function for every column of what the rows made.
    countSamples(scratch.moved, out.rows, out.columns, options.importance.isCounted, scratch.map);
    appendLineFunctions(scratch.map, out.columns, out.rows, lines, scratch.lines, out.columnKnots);
}

} // namespace lixel
