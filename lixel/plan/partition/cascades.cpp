// SPDX-License-Identifier: MIT
#include "lixel/plan/partition/cascades.h"

#include "lixel/plan/fit/along_view.h"
#include "lixel/plan/fit/stable.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lixel {
namespace {

using Splits = std::array<double, kMostCells + 1>;

// Room for the rounding of float half-spaces: against the depths themselves, so that it does not change as the camera moves, and
// against their offset where the frame's origin is far from the eye.
constexpr double kOverlap = 1e-5, kOffsetRounding = 4e-7;

double blend(double near, double far, double share, double lambda)
{
    const double even = near + (far - near) * share;
    if (!(near > 0)) return even;
    return lambda * near * std::pow(far / near, share) + (1 - lambda) * even;
}

Cells split(const ViewDepth& depth, double near, double far, int count, double lambda)
{
    LX_ASSERT(count >= 1 && count <= int(kMostCells));
    Splits splits;
    for (int i = 0; i <= count; ++i) splits[std::size_t(i)] = blend(near, far, double(i) / count, lambda);
    return cellsBetween(depth, {splits.data(), std::size_t(count) + 1});
}

// Outwards to steps that small changes of the picture do not cross.
double stepped(double depth, double (*rounding)(double)) { return std::exp2(0.25 * rounding(4 * std::log2(depth))); }

} // namespace

Cells cellsBetween(const ViewDepth& depth, std::span<const double> splits)
{
    Cells cells;
    for (std::size_t i = 0; i + 1 < splits.size(); ++i) {
        const bool isFirst = i == 0, isLast = i + 2 == splits.size();
        const double slack = std::max(kOverlap * std::abs(splits[i + 1]), kOffsetRounding * std::abs(depth.offset));
        Cell cell;
        if (!isFirst) cell.holdsLocal.push_back(depth.beyond(splits[i] - slack));
        if (!isLast) cell.holdsLocal.push_back(depth.before(splits[i + 1] + slack));
        if (!isLast) cell.servesLocal.push_back(depth.before(splits[i + 1]));
        cells.push_back(cell);
    }
    return cells;
}

CellsResult splitPssm(const FitInput& input, int count, double lambda)
{
    if (input.sceneLocal.isEmpty()) return Unexpected{FitFailure::EmptyScene};
    const ViewDepth depth = viewDepth(input.view, input.originWorld);
    if (!depth.isPerspective) lambda = 0;
    if (input.isStable) {
        if (input.light.kind != LightKind::Directional) return wholeSpace();
        const DepthSpan range = stableDepths(input);
        return split(depth, range.nearest, range.farthest, count, lambda);
    }
    std::vector<Vec3d>& points = input.scratch.points;
    findVisiblePoints(input, points);
    if (points.empty()) return Unexpected{FitFailure::NothingInView};
    FitInput anySeen = input;
    anySeen.seenLocal = {};
    const DepthSpan range = seenDepths(anySeen, depth, points);
    return split(depth, range.nearest, range.farthest, count, lambda);
}

CellsResult splitSdsm(const FitInput& input, int count)
{
    if (input.sceneLocal.isEmpty()) return Unexpected{FitFailure::EmptyScene};
    if (!input.hasViewSamples) return Unexpected{FitFailure::NoViewSamples};
    if (input.seenLocal.empty()) return Unexpected{FitFailure::NothingInView};
    const ViewDepth depth = viewDepth(input.view, input.originWorld);
    DepthSpan range = seenDepths(input, depth, {});
    if (input.isStable && range.nearest > 0)
        range = {stepped(range.nearest, [](double x) { return std::floor(x); }),
                 stepped(range.farthest, [](double x) { return std::ceil(x); })};
    return split(depth, range.nearest, range.farthest, count, depth.isPerspective ? 1 : 0);
}

} // namespace lixel
