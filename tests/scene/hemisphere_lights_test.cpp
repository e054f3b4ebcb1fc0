// SPDX-License-Identifier: MIT
#include "lixel/scene/hemisphere_lights.h"

#include "support/random_cases.h"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace lixel {
namespace {

using test::forEachCase;
using test::kCases;
using test::Rng;

// Sixteen sectors by eight heights of equal area. Chi-squared with 127 degrees of freedom is normal enough: mean 127,
// standard deviation 16; six of them do not happen.
TEST(HemisphereLights, AreUniformOnTheUpperHemisphere)
{
    forEachCase(kCases, [](Rng& rng) {
        constexpr int kSectors = 16, kHeights = 8, kCount = 20'000;
        std::array<int, kSectors * kHeights> cells{};
        Vec3d sum;
        for (const Light& light : hemisphereLights(rng.bits(), kCount)) {
            const Vec3d from = -light.directionWorld;
            ASSERT_EQ(light.kind, LightKind::Directional);
            ASSERT_NEAR(length(from), 1, 1e-12);
            ASSERT_GE(from.y, 0);
            const double turn = 0.5 + std::atan2(from.z, from.x) / (2 * std::numbers::pi);
            const int sector = std::min(int(turn * kSectors), kSectors - 1);
            ++cells[std::size_t(sector * kHeights + std::min(int(from.y * kHeights), kHeights - 1))];
            sum = sum + from;
        }
        const double expected = double(kCount) / double(cells.size());
        double chiSquared = 0;
        for (const int count : cells) chiSquared += (count - expected) * (count - expected) / expected;
        EXPECT_LT(chiSquared, 127 + 6 * 16);
        EXPECT_GT(chiSquared, 127 - 6 * 16) << "too even for chance";
        EXPECT_NEAR(sum.y / kCount, 0.5, 6 * std::sqrt(1.0 / 12 / kCount)); // heights are uniform in [0, 1)
        EXPECT_NEAR(sum.x / kCount, 0, 6 * std::sqrt(1.0 / 3 / kCount));
        EXPECT_NEAR(sum.z / kCount, 0, 6 * std::sqrt(1.0 / 3 / kCount));
    });
}

TEST(HemisphereLights, OfOneSeedAreTheSameHoweverMany)
{
    forEachCase(kCases, [](Rng& rng) {
        const std::uint64_t seed = rng.bits();
        const std::vector<Light> few = hemisphereLights(seed, 7), many = hemisphereLights(seed, 50);
        for (std::size_t i = 0; i < few.size(); ++i) {
            EXPECT_EQ(few[i].name, many[i].name);
            EXPECT_EQ(length(few[i].directionWorld - many[i].directionWorld), 0);
        }
        EXPECT_NE(length(few[0].directionWorld - hemisphereLights(seed + 1, 1)[0].directionWorld), 0);
    });
}

} // namespace
} // namespace lixel
