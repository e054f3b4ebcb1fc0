// SPDX-License-Identifier: MIT
// The two warps as their papers have them.
#include "lixel/plan/warp/now.h"
#include "lixel/plan/warp/rtw.h"

#include "support/random_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lixel {
namespace {

using test::forEachCase;
using test::Rng;

constexpr std::uint32_t kUnit = 256;

TextureWarp grid(int columns, int rows)
{
    TextureWarp warp;
    warp.columns = columns;
    warp.rows = rows;
    warp.square = {0, 0, columns, rows, 0};
    return warp;
}

// The settings of the paper's own map.
NowWarp paperNow(double smooth)
{
    NowWarp now;
    now.options.power = 1;
    now.options.smooth = smooth;
    now.options.floor = 0;
    return now;
}

TextureWarp madeNow(const std::vector<PlacedSample>& samples, const NowWarp& choice, int columns, int rows)
{
    WarpScratch scratch;
    TextureWarp warp = grid(columns, rows);
    makeNow(samples, choice, scratch, warp);
    return warp;
}

TextureWarp madeRtw(const std::vector<PlacedSample>& samples, const RtwWarp& choice, int columns, int rows)
{
    WarpScratch scratch;
    TextureWarp warp = grid(columns, rows);
    makeRtw(samples, choice, scratch, warp);
    return warp;
}

// Clusters of any shape, as a view's samples lie in a light's map.
std::vector<PlacedSample> anySamples(Rng& rng)
{
    std::vector<PlacedSample> samples;
    for (int cluster = rng.integer(1, 6); cluster > 0; --cluster) {
        const Vec2d centre{rng.uniform(0, 1), rng.uniform(0, 1)};
        const double along = rng.logUniform(1e-3, 0.5), across = rng.logUniform(1e-3, 0.5);
        for (int i = rng.integer(1, 2000); i > 0; --i) {
            const double x = centre.x + rng.uniform(-along, along), y = centre.y + rng.uniform(-across, across);
            if (x < 0 || y < 0 || x >= 1 || y >= 1) continue;
            samples.push_back({float(x), float(y), kUnit});
        }
    }
    return samples;
}

// Whether each function begins at 0, ends at 1 and grows strictly.
void expectMonotone(const std::vector<float>& knots, int lines, int cells)
{
    ASSERT_EQ(knots.size(), std::size_t(lines) * std::size_t(cells + 1));
    for (int line = 0; line < lines; ++line) {
        const float* f = knots.data() + std::ptrdiff_t(line) * (cells + 1);
        EXPECT_EQ(f[0], 0);
        EXPECT_EQ(f[cells], 1);
        for (int i = 0; i < cells; ++i) EXPECT_LT(f[i], f[i + 1]);
    }
}

TEST(Warps, FunctionsGrowStrictlyWhateverTheSamplesAre)
{
    forEachCase(test::kCases, [](Rng& rng) {
        std::vector<PlacedSample> samples = anySamples(rng);
        if (rng.chance(0.2)) samples.resize(std::min<std::size_t>(samples.size(), 1)); // one, or none
        if (rng.chance(0.2)) samples.assign(5000, {0.31f, 0.77f, kUnit});              // all in one lixel
        const int columns = rng.integer(8, 200), rows = rng.integer(8, 200);
        NowWarp now = paperNow(rng.chance(0.3) ? 0 : rng.logUniform(1e-2, 1));
        now.options.power = rng.uniform(0.3, 1);
        now.lines = rng.chance(0.5) ? WarpLines::Nearest : WarpLines::Interpolated;
        const TextureWarp warp = madeNow(samples, now, columns, rows);
        expectMonotone(warp.rowKnots, rows, columns);
        expectMonotone(warp.columnKnots, columns, rows);
        const TextureWarp rectilinear = madeRtw(samples, {now.options}, columns, rows);
        expectMonotone(rectilinear.rowKnots, 1, columns);
        expectMonotone(rectilinear.columnKnots, 1, rows);
    });
}

TEST(Warps, WithoutSamplesAndWithAnEvenMapTheyAreTheIdentity)
{
    std::vector<PlacedSample> even;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) even.push_back({(float(x) + 0.5f) / 32, (float(y) + 0.5f) / 32, kUnit});
    for (const std::vector<PlacedSample>& samples : {std::vector<PlacedSample>{}, even})
        for (const TextureWarp& warp : {madeNow(samples, paperNow(0), 32, 32), madeRtw(samples, {}, 32, 32)})
            for (const std::vector<float>* knots : {&warp.rowKnots, &warp.columnKnots})
                for (std::size_t i = 0; i < knots->size(); ++i) EXPECT_NEAR((*knots)[i], float(i % 33) / 32, 1e-6);
}

// Equations 2 to 5: x + o(x) = g(x) / N at the borders of lixels.
TEST(Warps, ARowsFunctionIsItsPrefixSumOverItsNumberOfSamples)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const std::vector<PlacedSample> samples = anySamples(rng);
        const int cells = rng.integer(8, 64);
        const TextureWarp warp = madeNow(samples, paperNow(0), cells, cells);
        for (int row = 0; row < cells; ++row) {
            const auto isBefore = [&](const PlacedSample& s, int column) {
                return std::min(int(s.y * float(cells)), cells - 1) == row &&
                       std::min(int(s.x * float(cells)), cells - 1) < column;
            };
            const auto below = [&](int column) {
                return std::count_if(samples.begin(), samples.end(),
                                     [&](const PlacedSample& s) { return isBefore(s, column); });
            };
            const auto total = double(below(cells));
            if (total < 100) continue; // the average of all rows shows in rows with few samples
            for (int column = 0; column <= cells; ++column)
                EXPECT_NEAR(warp.rowKnots[std::size_t(row * (cells + 1) + column)], double(below(column)) / total,
                            0.012);
        }
    });
}

TEST(Warps, SmoothingOverAllLinesMakesOneFunctionOfAll)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const std::vector<PlacedSample> samples = anySamples(rng);
        const int columns = rng.integer(8, 64), rows = rng.integer(8, 64);
        const TextureWarp warp = madeNow(samples, paperNow(1), columns, rows);
        for (std::size_t i = std::size_t(columns) + 1; i < warp.rowKnots.size(); ++i)
            EXPECT_NEAR(warp.rowKnots[i], warp.rowKnots[i % (std::size_t(columns) + 1)], 1e-6);
        for (std::size_t i = std::size_t(rows) + 1; i < warp.columnKnots.size(); ++i)
            EXPECT_NEAR(warp.columnKnots[i], warp.columnKnots[i % (std::size_t(rows) + 1)], 1e-6);
    });
}

TEST(Warps, MapsOfSamplesComeBackToAMillionthThroughTheInverse)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const std::vector<PlacedSample> samples = anySamples(rng);
        const int columns = rng.integer(8, 256), rows = rng.integer(8, 256);
        NowWarp now;
        now.options.smooth = rng.uniform(0, 0.2);
        RtwWarp rtw;
        for (const TextureWarp& warp : {madeNow(samples, now, columns, rows), madeRtw(samples, rtw, columns, rows)}) {
            const shared::ShadowWarp row = tableRow(warp);
            for (int i = 0; i < 50; ++i) {
                const shared::vec2 at{float(rng.uniform(0, 1)), float(rng.uniform(0, 1))};
                const shared::LxWarped there =
                    shared::lxWarped(row, shared::lxUnwarped(row, at, knotsOf(warp)), knotsOf(warp));
                // Rounding of the inverse moves the place that was found, the place itself is rounded, and its cell is: functions
                // that are steep, or differ from line to line, bring all that back enlarged.
                const shared::vec2 x = there.alongX, y = there.alongY;
                const double longest = std::abs(x.x) + std::abs(x.y) + std::abs(y.x) + std::abs(y.y);
                const double rounding = 6e-8 * (2 * longest + longest * longest / (x.x * y.y - x.y * y.x));
                EXPECT_LT(std::hypot(there.at.x - at.x, there.at.y - at.y), 1e-6 + rounding);
            }
        }
    });
}

// The share of lixels that serve a sample, and how unlike the counts of those are.
struct Evenness
{
    double used = 0, variation = 0;
};

Evenness evennessOf(const TextureWarp& warp, const std::vector<PlacedSample>& samples)
{
    std::vector<PlacedSample> moved;
    for (const PlacedSample& s : samples) {
        const auto at = shared::lxWarped(tableRow(warp), {s.x, s.y}, knotsOf(warp)).at;
        moved.push_back({at.x, at.y, 1});
    }
    std::vector<std::uint32_t> map;
    countSamples(moved, warp.columns, warp.rows, true, map);
    double used = 0, sum = 0, squares = 0;
    for (const std::uint32_t count : map) {
        used += count > 0;
        sum += count;
        squares += double(count) * count;
    }
    const double n = double(map.size()), mean = sum / n;
    return {used / n, std::sqrt(std::max(squares / n - mean * mean, 0.0)) / mean};
}

TEST(Warps, EqualCountsSpreadSamplesMoreEvenlyThanTwoFunctionsCan)
{
    double now = 0, rtw = 0, none = 0;
    int cases = 0;
    forEachCase(test::kCases / 100, [&](Rng& rng) {
        // A floor that lies askew in the map, as most do.
        std::vector<PlacedSample> samples;
        const double lean = rng.uniform(0.3, 1.2), width = rng.uniform(0.05, 0.2);
        for (int i = 0; i < 200000; ++i) {
            const double along = rng.uniform(0, 1);
            const double x = along, y = 0.5 + lean * (along - 0.5) + width * rng.uniform(-1, 1) * (0.2 + along);
            if (y >= 0 && y < 1) samples.push_back({float(x), float(y), kUnit});
        }
        RtwWarp equal;
        equal.options = paperNow(1.0 / 64).options;
        now += evennessOf(madeNow(samples, paperNow(3.0 / 512), 128, 128), samples).used;
        rtw += evennessOf(madeRtw(samples, equal, 128, 128), samples).used;
        none += evennessOf(madeNow({}, paperNow(0), 128, 128), samples).used;
        ++cases;
    });
    std::printf("lixels that serve a sample: now %.3f, rtw %.3f, no warp %.3f\n", now / cases, rtw / cases,
                none / cases);
    EXPECT_GE(now, 1.7 * rtw);
}

TEST(Warps, ALesserPowerGivesDenseLixelsLess)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const std::vector<PlacedSample> samples = anySamples(rng);
        if (samples.size() < 1000) return;
        const auto variation = [&](double power) {
            NowWarp now = paperNow(0.05);
            now.options.power = power;
            return evennessOf(madeNow(samples, now, 64, 64), samples).variation;
        };
        const double none = evennessOf(madeNow({}, paperNow(0), 64, 64), samples).variation;
        EXPECT_LT(variation(1), none * 1.05);
        EXPECT_LT(variation(2.0 / 3), none * 1.05);
    });
}

} // namespace
} // namespace lixel
