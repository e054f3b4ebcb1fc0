// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace lixel {

// A measured pair: how large something was, and what it cost.
struct GrowthPoint
{
    double size = 0, cost = 0; // above 0
};

// cost = factor * size^exponent, by least squares of log cost over log size. Only the upper half of the sizes counts, rounded up
// and three at least: where things are small, costs that do not grow hide those that do.
struct Growth
{
    double exponent = 0, factor = 0;
    double deviation = 0; // root mean square of log cost beside the line
    double from = 0;      // the least size that counts
    std::size_t points = 0;
};

// Sizes rise. Nothing for fewer than three points, or where sizes are equal.
std::optional<Growth> growthOf(std::span<const GrowthPoint> points);

} // namespace lixel
