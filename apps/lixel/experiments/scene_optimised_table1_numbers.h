// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/judge/ranked_sums.h"
#include "lixel/report/reproduction.h"

#include <vector>

// Table 1 of "Scene Optimized Shadow Mapping": the paper's numbers, and ours in its form.
namespace lixel::app {

// The paper's columns come first and in its order: Optimal, Focused, LiSPSM, Plane, Normal.
inline constexpr std::size_t kPapersColumns = 5;
inline constexpr std::size_t kOptimal = 0, kFocused = 1;

// Of misclassified samples, a light a case: all data, then the tenth of the lights that is worst by each method.
ReproducedTable tableOf(std::vector<ReproducedTable::Column> columns, const ComparableErrors& counted);

// What the paper's text says, and how many fewer errors than Focused each method has.
std::vector<ReproducedNumber> numbersOf(const ReproducedTable& table, const ComparableErrors& counted, double pixels);

} // namespace lixel::app
