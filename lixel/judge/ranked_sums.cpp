// SPDX-License-Identifier: MIT
#include "lixel/judge/ranked_sums.h"

#include "lixel/base/assert.h"

#include <algorithm>
#include <numeric>

namespace lixel {

RankedSums rankedSums(std::span<const std::vector<double>> errors, double share)
{
    RankedSums sums;
    if (errors.empty()) return sums;
    sums.cases = errors.front().size();
    // A tenth of 30 is 3, whatever 0.1 is in binary.
    sums.worstCases = std::min(sums.cases, std::max<std::size_t>(std::size_t(share * double(sums.cases) + 1e-9), 1));
    std::vector<std::size_t> worstFirst(sums.cases);
    for (const std::vector<double>& by : errors) {
        LX_ASSERT(by.size() == sums.cases);
        sums.all.push_back(std::accumulate(by.begin(), by.end(), 0.0));
        std::iota(worstFirst.begin(), worstFirst.end(), std::size_t(0));
        std::stable_sort(worstFirst.begin(), worstFirst.end(),
                         [&](std::size_t a, std::size_t b) { return by[a] > by[b]; });
        std::vector<double>& worst = sums.worst.emplace_back();
        for (const std::vector<double>& of : errors) {
            double& sum = worst.emplace_back(0.0);
            for (std::size_t i = 0; i < sums.worstCases; ++i) sum += of[worstFirst[i]];
        }
    }
    return sums;
}

ComparableErrors comparableErrors(std::span<const PossibleErrors> ofMethods, std::size_t standIn)
{
    LX_ASSERT(standIn < ofMethods.size());
    const PossibleErrors& inPlace = ofMethods[standIn];
    ComparableErrors out;
    for (std::size_t i = 0; i < inPlace.size(); ++i)
        if (inPlace[i]) out.cases.push_back(i);
    for (const PossibleErrors& of : ofMethods) {
        LX_ASSERT(of.size() == inPlace.size());
        std::vector<double>& errors = out.errors.emplace_back();
        int& refused = out.refused.emplace_back(0);
        for (const std::size_t i : out.cases) {
            errors.push_back(of[i].value_or(*inPlace[i]));
            refused += !of[i];
        }
    }
    return out;
}

} // namespace lixel
