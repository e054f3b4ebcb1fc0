// SPDX-License-Identifier: MIT
#include "lixel/plan/need.h"

#include "lixel/plan/footprint.h"

#include <algorithm>

namespace lixel {
namespace {

constexpr std::size_t kMostAtBoundaries = 768, kMostOthers = 256;
constexpr double kAwayFromBoundaries = 0.02;

// A lixel that spans the map is not longer in the picture than so many of its diagonals.
constexpr double kMostDiagonals = 8;

// Every step-th of the samples that `wanted` takes, each with the weight of all it stands for.
template <typename Wanted, typename Sample>
void takeEvenly(std::size_t count, std::size_t most, const Wanted& wanted, const Sample& sample,
                std::vector<NeedSample>& out)
{
    std::size_t total = 0;
    for (std::size_t i = 0; i < count; ++i) total += wanted(i);
    if (total == 0) return;
    const std::size_t taken = std::min(total, most);
    std::size_t number = 0, next = 0; // the next one is number next * total / taken + half a step
    for (std::size_t i = 0; i < count && next < taken; ++i) {
        if (!wanted(i)) continue;
        if (number++ < (2 * next + 1) * total / (2 * taken)) continue;
        NeedSample chosen = sample(i);
        chosen.weight *= double(total) / double(taken);
        out.push_back(chosen);
        ++next;
    }
}

} // namespace

void gatherNeedSamples(const NeedSource& source, const Light& light, Vec3d originWorld,
                       std::vector<NeedSample>& samples)
{
    samples.clear();
    const Observation* observed = source.observed;
    if (!observed || observed->atBoundary.empty() || source.lightNumber >= kObservedLights) {
        const auto any = [](std::size_t) { return true; };
        const auto seen = [&](std::size_t i) { return NeedSample{source.seenLocal[i], source.seenNormal[i], 1}; };
        takeEvenly(source.seenLocal.size(), kMostAtBoundaries + kMostOthers, any, seen, samples);
        return;
    }
    const ViewSamples& cells = observed->samples;
    const Vec3d toLocal = cells.originWorld - originWorld;
    const auto at = [&](std::size_t i) { return toDouble(cells.positionLocal[i]) + toLocal; };
    const auto normal = [&](std::size_t i) { return toDouble(cells.normal[i]); };
    const std::uint32_t bit = std::uint32_t{1} << source.lightNumber;
    const auto isAtBoundary = [&](std::size_t i) { return (observed->atBoundary[i] & bit) != 0; };
    const auto isAway = [&](std::size_t i) {
        return !isAtBoundary(i) && isLightFacing(light, originWorld, at(i), normal(i));
    };
    takeEvenly(
        cells.size(), kMostAtBoundaries, isAtBoundary,
        [&](std::size_t i) {
            return NeedSample{at(i), normal(i), double(cells.weightOf(i))};
        },
        samples);
    takeEvenly(
        cells.size(), kMostOthers, isAway,
        [&](std::size_t i) {
            return NeedSample{at(i), normal(i), kAwayFromBoundaries * double(cells.weightOf(i))};
        },
        samples);
}

Need needOf(const Fit& fit, const View& view, Vec3d originWorld, const NeedSample& sample)
{
    const LightImage image(fit.lightClipFromLocal, {0, 0, 1, 1, 0});
    const auto f = footprint(view, originWorld, image, sample.pointLocal, sample.normal);
    if (!f) return {};
    // Columns of the inverse: pixels along a step of x, and of y.
    const auto& m = f->lixelFromPixel;
    const double most = kMostDiagonals * std::hypot(view.width, view.height), area = f->lixelsPerPixel;
    const auto capped = [&](double length) { return area > 0 ? std::min(length / area, most) : most; };
    return {sample.weight * capped(std::hypot(m[1][1], m[1][0])), sample.weight * capped(std::hypot(m[0][1], m[0][0]))};
}

} // namespace lixel
