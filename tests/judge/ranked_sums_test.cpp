// SPDX-License-Identifier: MIT
#include "lixel/judge/ranked_sums.h"

#include "support/random_cases.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace lixel {
namespace {

using test::forEachCase;
using test::kCases;
using test::Rng;
using Errors = std::vector<std::vector<double>>;

// Twenty cases, of which two are the worst tenth: by the first method cases 3 and 17, by the second 0 and 3, whose 9 comes
// before the 9 of case 19.
TEST(RankedSums, OfAHandMadeTableAreThoseByHand)
{
    Errors errors(2, std::vector<double>(20, 1));
    errors[0][3] = 50, errors[0][17] = 40, errors[0][0] = 5;
    errors[1][0] = 30, errors[1][3] = 9, errors[1][19] = 9, errors[1][17] = 2;
    const RankedSums sums = rankedSums(errors, 0.1);
    EXPECT_EQ(sums.cases, 20u);
    EXPECT_EQ(sums.worstCases, 2u);
    EXPECT_EQ(sums.all, (std::vector<double>{17 + 95, 16 + 50}));
    EXPECT_EQ(sums.worst, (Errors{{90, 11}, {55, 39}}));
}

TEST(RankedSums, HaveAtLeastOneWorstCaseAndATenthOfThirtyIsThree)
{
    EXPECT_EQ(rankedSums(Errors{{1, 4, 2}}, 0.1).worst, (Errors{{4}}));
    for (std::size_t cases = 10; cases <= 500; cases += 10)
        EXPECT_EQ(rankedSums(Errors{std::vector<double>(cases, 1)}, 0.1).worstCases, cases / 10);
    EXPECT_EQ(rankedSums(Errors{{}, {}}, 0.1).all, (std::vector<double>{0, 0}));
    EXPECT_TRUE(rankedSums({}, 0.1).all.empty());
}

// A method's own worst cases are the worst that it has, and all of them are everything.
TEST(RankedSums, AMethodIsNowhereWorseThanInItsOwnWorstCases)
{
    forEachCase(kCases, [](Rng& rng) {
        Errors errors(std::size_t(rng.integer(1, 6)), std::vector<double>(std::size_t(rng.integer(1, 60))));
        for (std::vector<double>& of : errors)
            for (double& error : of) error = rng.integer(0, 20);
        const RankedSums sums = rankedSums(errors, rng.uniform(0.05, 0.9)), whole = rankedSums(errors, 1);
        for (std::size_t by = 0; by < errors.size(); ++by) {
            EXPECT_EQ(whole.worst[by], whole.all);
            for (std::size_t of = 0; of < errors.size(); ++of) {
                EXPECT_LE(sums.worst[by][of], sums.worst[of][of]);
                EXPECT_LE(sums.worst[by][of], sums.all[of]);
            }
        }
    });
}

// Method 1 stands in. Case 1 is refused by method 0, case 3 by it, case 2 by method 1 itself and so left out for all.
TEST(ComparableErrors, ARefusedCaseCountsAsTheStandInOrForNoOne)
{
    const std::vector<PossibleErrors> ofMethods{
        {5, std::nullopt, 7, std::nullopt}, {1, 2, std::nullopt, 4}, {9, 8, 6, 3}};
    const ComparableErrors comparable = comparableErrors(ofMethods, 1);
    EXPECT_EQ(comparable.cases, (std::vector<std::size_t>{0, 1, 3}));
    EXPECT_EQ(comparable.errors, (Errors{{5, 2, 4}, {1, 2, 4}, {9, 8, 3}}));
    EXPECT_EQ(comparable.refused, (std::vector<int>{2, 0, 0}));
}

} // namespace
} // namespace lixel
