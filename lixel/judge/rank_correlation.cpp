// SPDX-License-Identifier: MIT
#include "lixel/judge/rank_correlation.h"

#include "lixel/base/assert.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace lixel {

std::vector<double> ranks(std::span<const double> values)
{
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::sort(order, {}, [&](std::size_t i) { return values[i]; });
    std::vector<double> out(values.size());
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
        while (end < order.size() && values[order[end]] == values[order[begin]]) ++end;
        for (std::size_t i = begin; i < end; ++i) out[order[i]] = 0.5 * double(begin + 1 + end);
    }
    return out;
}

std::optional<double> rankCorrelation(std::span<const double> a, std::span<const double> b)
{
    LX_ASSERT(a.size() == b.size());
    const std::vector<double> x = ranks(a), y = ranks(b);
    const double mean = 0.5 * double(a.size() + 1);
    double xx = 0, yy = 0, xy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - mean) * (x[i] - mean);
        yy += (y[i] - mean) * (y[i] - mean);
        xy += (x[i] - mean) * (y[i] - mean);
    }
    if (!(xx > 0 && yy > 0)) return std::nullopt;
    return xy / std::sqrt(xx * yy);
}

} // namespace lixel
