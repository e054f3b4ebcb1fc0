// SPDX-License-Identifier: MIT
#include "lixel/judge/rank_correlation.h"

#include "support/random_cases.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace lixel {
namespace {

using test::forEachCase;
using test::kCases;
using test::Rng;
using Values = std::vector<double>;

TEST(RankCorrelation, OfAHandMadeListIsThatByHand)
{
    // Squares of the differences of ranks: 0, 1, 1, 0, 0; 1 - 6 x 2 / (5 x 24).
    EXPECT_NEAR(rankCorrelation(Values{10, 20, 30, 40, 50}, Values{1, 3, 2, 4, 5}).value(), 0.9, 1e-12);
    EXPECT_EQ(ranks(Values{5, 1, 5, 5, 0}), (Values{4, 2, 4, 4, 1}));
}

TEST(RankCorrelation, IsNothingWhereThereIsNoOrder)
{
    EXPECT_FALSE(rankCorrelation({}, {}));
    EXPECT_FALSE(rankCorrelation(Values{1}, Values{2}));
    EXPECT_FALSE(rankCorrelation(Values{1, 2, 3}, Values{4, 4, 4}));
}

TEST(RankCorrelation, AsksForTheOrderOnlyAndTurnsWithIt)
{
    forEachCase(kCases, [](Rng& rng) {
        Values a, b, grown, turned;
        for (int i = 0; i < 30; ++i) {
            a.push_back(rng.uniform(-2, 2));
            b.push_back(a.back() + rng.uniform(-2, 2));
            grown.push_back(std::exp(3 * b.back()));
            turned.push_back(-b.back());
        }
        const double found = rankCorrelation(a, b).value();
        EXPECT_NEAR(rankCorrelation(a, grown).value(), found, 1e-12);
        EXPECT_NEAR(rankCorrelation(a, turned).value(), -found, 1e-12);
        EXPECT_NEAR(rankCorrelation(b, a).value(), found, 1e-12);
        EXPECT_NEAR(rankCorrelation(b, grown).value(), 1, 1e-12);
    });
}

} // namespace
} // namespace lixel
