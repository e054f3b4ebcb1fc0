// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

// How small a square map may be for errors under a tolerance.
namespace lixel {

inline constexpr int kSmallestSide = 8, kLargestSide = 8192;

// Sides of maps, each about 2 % longer than the one before, from kSmallestSide to kLargestSide.
std::vector<int> ladderOfSides();

// Errors go with the size of a lixel, 1 / side, over what remains at any size, but not side by side: where lixels fall on an edge is
// chance. The smallest map is therefore a side of the ladder at which the tolerance holds, as it does at the next two; at the one
// before, it does not. One much smaller may hold by chance.
struct SmallestMap
{
    int predicted = 0;       // from two measured maps, within the ladder
    std::optional<int> side; // nothing: no map of the ladder
    double percent = 0;      // misclassified there; with no map, at the largest
    int measured = 0;        // sides that were asked
};

// `percentAt`: what a map of this side misclassifies, infinite where there is no such map. Measured are `firstSide`, where errors as
// 1 / side then lead, and where the line through both leads; from there on sides are tried.
SmallestMap smallestMap(double tolerancePercent, int firstSide, const std::function<double(int)>& percentAt);

} // namespace lixel
