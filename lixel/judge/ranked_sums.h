// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

// How methods degrade, as Table 1 of H. Chong, S. Gortler, Scene Optimized Shadow Mapping, 2007, has it: the errors of all
// methods on the same cases, over all of them, and over the cases that are worst by each method.
namespace lixel {

struct RankedSums
{
    std::vector<double> all;                // [method]
    std::vector<std::vector<double>> worst; // [by][method]: over the cases in which method `by` errs most
    std::size_t cases = 0, worstCases = 0;  // how many are summed
};

// `errors` is [method][case]; `share` of the cases, rounded down but at least one, are the worst. Of equal errors the earlier
// case is the worse one. Without cases all sums are 0.
RankedSums rankedSums(std::span<const std::vector<double>> errors, double share);

// Of one method; no value in cases that it refused.
using PossibleErrors = std::vector<std::optional<double>>;

// Sums compare only over the same cases. In a case that a method refuses it counts with what `standIn` errs there; cases that
// this one refuses too are left out for all.
struct ComparableErrors
{
    std::vector<std::vector<double>> errors; // [method][case that counts]
    std::vector<std::size_t> cases;          // those that count, in their order
    std::vector<int> refused;                // [method]: of the cases that count
};
ComparableErrors comparableErrors(std::span<const PossibleErrors> ofMethods, std::size_t standIn);

} // namespace lixel
