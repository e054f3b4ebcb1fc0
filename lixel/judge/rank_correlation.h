// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

// Whether one list of numbers orders cases as another does, whatever curve leads from one to the other.
namespace lixel {

// Places in ascending order, from 1; equal values share the mean of their places.
std::vector<double> ranks(std::span<const double> values);

// Spearman's coefficient: the correlation of ranks, -1 to 1. Both lists are equally long. Nothing of fewer than two cases, or where
// all values of a list are equal: then there is no order.
std::optional<double> rankCorrelation(std::span<const double> a, std::span<const double> b);

} // namespace lixel
