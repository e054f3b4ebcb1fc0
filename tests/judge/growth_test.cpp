// SPDX-License-Identifier: MIT
#include "lixel/judge/growth.h"

#include "support/random_cases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lixel::test {
namespace {

TEST(Growth, OfAPowerIsItsExponent)
{
    forEachCase(kCases, [](Rng& rng) {
        const double exponent = rng.uniform(-1, 3), factor = rng.logUniform(1e-3, 1e3);
        std::vector<GrowthPoint> points;
        double size = rng.logUniform(1, 100);
        for (int i = rng.integer(3, 9); i > 0; --i, size *= rng.uniform(1.5, 4))
            points.push_back({size, factor * std::pow(size, exponent)});
        const auto growth = growthOf(points);
        ASSERT_TRUE(growth);
        EXPECT_NEAR(growth->exponent, exponent, 1e-9);
        EXPECT_NEAR(growth->factor / factor, 1, 1e-6);
        EXPECT_NEAR(growth->deviation, 0, 1e-7);
    });
}

// What does not grow, as starting a pass, is most of what small sizes cost.
TEST(Growth, AConstantHidesLittleOfItInTheUpperHalf)
{
    std::vector<GrowthPoint> points;
    for (double size = 1; size <= 1e8; size *= 10) points.push_back({size, 1000 + size});
    const auto growth = growthOf(points);
    ASSERT_TRUE(growth);
    EXPECT_EQ(growth->points, 5u);
    EXPECT_EQ(growth->from, 1e4);
    EXPECT_NEAR(growth->exponent, 1, 0.02);
}

TEST(Growth, NeedsThreePointsOfDifferentSizes)
{
    const std::vector<GrowthPoint> two{{1, 1}, {2, 2}}, same{{2, 1}, {2, 2}, {2, 3}};
    EXPECT_FALSE(growthOf(two));
    EXPECT_FALSE(growthOf(same));
}

} // namespace
} // namespace lixel::test
