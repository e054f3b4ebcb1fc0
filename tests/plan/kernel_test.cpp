// SPDX-License-Identifier: MIT
#include "lixel/shared/lookup/kernel.h"
#include "support/random_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lixel {
namespace {

using namespace test;

shared::LxLookup kernelOf(int kind, int side)
{
    shared::LxLookup how = shared::lxOneDepth(side);
    how.kernel = kind;
    return how;
}

TEST(Kernel, TapsOfAGridAreALixelApartAroundTheReceiver)
{
    for (int side = 1; side <= 5; ++side) {
        const shared::LxLookup how = kernelOf(shared::LX_KERNEL_GRID, side);
        for (int tap = 0; tap < side * side; ++tap) {
            const shared::vec2 at = shared::lxTap(how, tap % side, tap / side, 7u);
            EXPECT_EQ(at.x, float(tap % side) - float(side - 1) / 2);
            EXPECT_EQ(at.y, float(tap / side) - float(side - 1) / 2);
        }
    }
}

// By one angle for the whole grid, evenly enough from none to a right one, after which the grid is the same again.
TEST(Kernel, RotatedTapsAreTheGridTurnedByAnAngleBelowARightOne)
{
    std::array<int, 9> tenDegrees{};
    forEachCase(kCases, [&](Rng& rng) {
        const int side = rng.integer(2, 5);
        const shared::LxLookup how = kernelOf(shared::LX_KERNEL_ROTATED, side);
        const auto seed = shared::lxDiced(shared::uint(rng.integer(0, 1 << 30)));
        const float first = -float(side - 1) / 2;
        const shared::vec2 corner = shared::lxTap(how, 0, 0, seed);
        const double angle = std::atan2(corner.y, corner.x) - std::atan2(first, first);
        ASSERT_GE(angle, -1e-6);
        ASSERT_LT(angle, std::numbers::pi / 2);
        ++tenDegrees[std::size_t(std::clamp(angle * 18 / std::numbers::pi, 0.0, 8.0))];
        for (int tap = 0; tap < side * side; ++tap) {
            const shared::vec2 at = shared::lxTap(how, tap % side, tap / side, seed);
            const double x = first + float(tap % side), y = first + float(tap / side);
            EXPECT_NEAR(at.x, std::cos(angle) * x - std::sin(angle) * y, 1e-5);
            EXPECT_NEAR(at.y, std::sin(angle) * x + std::cos(angle) * y, 1e-5);
        }
    });
    for (const int count : tenDegrees) EXPECT_GT(count, scaled(kCases) / 20); // of a ninth
}

TEST(Kernel, JitteredTapsStayInTheirSquaresAndFillThemEvenly)
{
    std::array<int, 16> cells{};
    int taps = 0;
    forEachCase(kCases, [&](Rng& rng) {
        const int side = rng.integer(2, 5);
        const shared::LxLookup how = kernelOf(shared::LX_KERNEL_JITTERED, side);
        const auto seed = shared::lxDiced(shared::uint(rng.integer(0, 1 << 30)));
        for (int tap = 0; tap < side * side; ++tap) {
            const shared::vec2 at = shared::lxTap(how, tap % side, tap / side, seed);
            const float x = at.x + float(side - 1) / 2 - float(tap % side) + 0.5f;
            const float y = at.y + float(side - 1) / 2 - float(tap / side) + 0.5f;
            ASSERT_TRUE(x >= 0 && x <= 1 && y >= 0 && y <= 1) << x << " " << y;
            ++cells[std::size_t(std::min(int(x * 4), 3) + 4 * std::min(int(y * 4), 3))];
            ++taps;
        }
    });
    for (const int count : cells) EXPECT_NEAR(count, taps / 16.0, 5 * std::sqrt(taps / 16.0));
}

} // namespace
} // namespace lixel
