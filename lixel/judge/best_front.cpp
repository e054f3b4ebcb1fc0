// SPDX-License-Identifier: MIT
#include "lixel/judge/best_front.h"

#include "lixel/base/assert.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace lixel {

std::vector<std::size_t> bestFront(std::span<const double> cost, std::span<const double> error)
{
    LX_ASSERT(cost.size() == error.size());
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < cost.size(); ++i)
        if (!std::isnan(cost[i]) && !std::isnan(error[i])) order.push_back(i);
    std::ranges::sort(order, {}, [&](std::size_t i) { return std::tuple(cost[i], error[i], i); });
    std::vector<std::size_t> front;
    for (const std::size_t i : order) {
        const bool isEqual = !front.empty() && cost[i] == cost[front.back()] && error[i] == error[front.back()];
        if (front.empty() || isEqual || error[i] < error[front.back()]) front.push_back(i);
    }
    return front;
}

} // namespace lixel
