// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lixel {

// Of choices with a cost and an error each, those that none beats: none costs no more and errs less, none errs no more and costs less.
// From the cheapest on. Choices with a NaN take no part.
std::vector<std::size_t> bestFront(std::span<const double> cost, std::span<const double> error);

} // namespace lixel
