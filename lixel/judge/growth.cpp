// SPDX-License-Identifier: MIT
#include "lixel/judge/growth.h"

#include <algorithm>
#include <cmath>

namespace lixel {

std::optional<Growth> growthOf(std::span<const GrowthPoint> points)
{
    constexpr std::size_t kLeast = 3;
    if (points.size() < kLeast) return std::nullopt;
    const auto upper = points.last(std::max(kLeast, (points.size() + 1) / 2));
    const double n = double(upper.size());
    double meanX = 0, meanY = 0;
    for (const GrowthPoint& p : upper) {
        meanX += std::log(p.size) / n;
        meanY += std::log(p.cost) / n;
    }
    double xx = 0, xy = 0;
    for (const GrowthPoint& p : upper) {
        const double dx = std::log(p.size) - meanX;
        xx += dx * dx;
        xy += dx * (std::log(p.cost) - meanY);
    }
    if (!(xx > 0) || !std::isfinite(xy)) return std::nullopt;
    Growth growth{xy / xx, std::exp(meanY - xy / xx * meanX), 0, upper.front().size, upper.size()};
    for (const GrowthPoint& p : upper) {
        const double beside = std::log(p.cost) - std::log(growth.factor) - growth.exponent * std::log(p.size);
        growth.deviation += beside * beside / n;
    }
    growth.deviation = std::sqrt(growth.deviation);
    return growth;
}

} // namespace lixel
