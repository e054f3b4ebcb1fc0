// SPDX-License-Identifier: MIT
#include "lixel/plan/warp/texture_warp.h"

#include "plan/random_warps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lixel {
namespace {

using test::forEachCase;
using test::Rng;

// A warp of its own square, as lookups read it.
struct Read
{
    TextureWarp warp;
    shared::ShadowWarp row;

    explicit Read(TextureWarp of) : warp(std::move(of)), row(tableRow(warp)) {}
    shared::LxWarped forward(shared::vec2 p) const { return shared::lxWarped(row, p, knotsOf(warp)); }
    shared::vec2 back(shared::vec2 p) const { return shared::lxUnwarped(row, p, knotsOf(warp)); }
};

Read anyRead(Rng& rng) { return Read(test::anyWarp({0, 0, 64, 64, 0}, rng)); }

shared::vec2 anyPoint(Rng& rng) { return {float(rng.uniform(0, 1)), float(rng.uniform(0, 1))}; }

double distance(shared::vec2 a, shared::vec2 b) { return std::hypot(a.x - b.x, a.y - b.y); }

// How far two points that came to one place within 1e-6 may lie apart.
double apart(const shared::LxWarped& w)
{
    const double area = w.alongX.x * w.alongY.y - w.alongX.y * w.alongY.x;
    const double longest = std::abs(w.alongX.x) + std::abs(w.alongX.y) + std::abs(w.alongY.x) + std::abs(w.alongY.y);
    return 1e-6 * std::max(1.0, longest / area);
}

TEST(TextureWarp, WhatIsUnwarpedComesBackWhenItIsWarpedToAMillionthOfTheMap)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const Read read = anyRead(rng);
        for (int i = 0; i < 20; ++i) {
            const shared::vec2 at = anyPoint(rng), back = read.back(at);
            // Between two knots of a steep line floats of the place along have no more digits.
            const shared::LxWarped again = read.forward(back);
            const double digits = 6e-8 * (std::abs(again.alongX.x) + std::abs(again.alongX.y) +
                                          std::abs(again.alongY.x) + std::abs(again.alongY.y));
            if (read.warp.lines == WarpLines::Nearest) {
                // At a border of lines the point may be taken through the next one.
                const double row = back.y * read.warp.rows, column = at.x * read.warp.columns;
                if (std::abs(row - std::round(row)) < 1e-4 || std::abs(column - std::round(column)) < 1e-4) continue;
            }
            EXPECT_LT(distance(again.at, at), 1e-6 + digits);
        }
    });
}

TEST(TextureWarp, WhatIsWarpedComesBackWhenItIsUnwarped)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const Read read = anyRead(rng);
        for (int i = 0; i < 20; ++i) {
            const shared::vec2 point = anyPoint(rng);
            const shared::LxWarped there = read.forward(point);
            if (read.warp.lines == WarpLines::Nearest) {
                const double row = point.y * read.warp.rows, column = there.at.x * read.warp.columns;
                if (std::abs(row - std::round(row)) < 1e-4 || std::abs(column - std::round(column)) < 1e-4) continue;
            }
            EXPECT_LT(distance(read.back(there.at), point), apart(there));
        }
    });
}

TEST(TextureWarp, WhereASearchBeginsIsNothing)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const Read read = anyRead(rng);
        for (int i = 0; i < 20; ++i) {
            const shared::vec2 at = anyPoint(rng), near{float(rng.uniform(-0.5, 1.5)), float(rng.uniform(-0.5, 1.5))};
            const shared::vec2 back = read.back(at),
                               sooner = shared::lxUnwarpedNear(read.row, at, near, knotsOf(read.warp));
            EXPECT_EQ(distance(sooner, back), 0);
        }
    });
}

TEST(TextureWarp, EvenStepsAreTheIdentity)
{
    forEachCase(test::kCases, [](Rng& rng) {
        TextureWarp warp = test::anyWarp({0, 0, 64, 64, 0}, rng);
        const auto make = [](std::vector<float>& knots, int cells) {
            for (std::size_t i = 0; i < knots.size(); ++i) knots[i] = float(i % std::size_t(cells + 1)) / float(cells);
        };
        make(warp.rowKnots, warp.columns);
        make(warp.columnKnots, warp.rows);
        const Read read(warp);
        for (int i = 0; i < 20; ++i) {
            const shared::vec2 point = anyPoint(rng);
            EXPECT_LT(distance(read.forward(point).at, point), 2e-7);
            EXPECT_LT(distance(read.back(point), point), 2e-7);
        }
    });
}

TEST(TextureWarp, TheSquareGoesOntoItselfAndGuardBandsStay)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const Read read = anyRead(rng);
        for (int i = 0; i < 20; ++i) {
            const shared::vec2 at = read.forward(anyPoint(rng)).at;
            EXPECT_TRUE(at.x >= 0 && at.y >= 0 && at.x <= 1 && at.y <= 1) << at.x << ' ' << at.y;
            const float along = float(rng.uniform(0, 1)), outside = float(rng.chance(0.5) ? -0.01 : 1.01);
            EXPECT_EQ(read.forward({outside, along}).at.x, outside);
            EXPECT_EQ(read.forward({along, outside}).at.y, outside);
            EXPECT_EQ(read.back({outside, along}).x, outside);
            EXPECT_EQ(read.back({along, outside}).y, outside);
        }
    });
}

TEST(TextureWarp, DerivativesAreThoseOfTheMap)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const Read read = anyRead(rng);
        const TextureWarp& w = read.warp;
        const double step = 1.0 / 4096;
        const auto middle = [&](int cells) { // well inside a cell, off the middles of lines
            return (rng.integer(0, cells - 1) + (rng.chance(0.5) ? 0.25 : 0.75)) / cells;
        };
        const shared::vec2 p{float(middle(w.columns)), float(middle(w.rows))};
        const shared::LxWarped at = read.forward(p);
        const double column = at.at.x * w.columns, fraction = column - std::floor(column);
        const double reach = 2 * step * w.columns * (std::abs(at.alongX.x) + std::abs(at.alongY.x));
        const bool nearBorder = std::min({fraction, 1 - fraction, std::abs(fraction - 0.5)}) < reach;
        if (nearBorder && w.lines != WarpLines::Rectilinear) return;
        const auto change = [&](shared::vec2 by) {
            const shared::vec2 a = read.forward(p + by).at, b = read.forward(p - by).at;
            return Vec2d{(a.x - b.x) / (2 * step), (a.y - b.y) / (2 * step)};
        };
        const Vec2d alongX = change({float(step), 0}), alongY = change({0, float(step)});
        // Lines that cross are not straight: a product of two slopes bends within a cell.
        const double bend = 2 * step * w.columns * w.rows * (std::abs(at.alongX.x) + std::abs(at.alongY.x) + 1);
        EXPECT_NEAR(at.alongX.x, alongX.x, 2e-3);
        EXPECT_NEAR(at.alongX.y, alongX.y, 2e-3 + bend);
        EXPECT_NEAR(at.alongY.x, alongY.x, 2e-3);
        EXPECT_NEAR(at.alongY.y, alongY.y, 2e-3 + bend);
        EXPECT_GT(at.alongX.x * at.alongY.y - at.alongX.y * at.alongY.x, 0);
    });
}

TEST(TextureWarp, InterpolatedLinesHaveNoJumps)
{
    forEachCase(test::kCases, [](Rng& rng) {
        TextureWarp warp = test::anyWarp({0, 0, 64, 64, 0}, rng);
        if (warp.lines == WarpLines::Nearest) return;
        const Read read(warp);
        for (int i = 0; i < 20; ++i) {
            const bool isAtBorder = rng.chance(0.5); // of rows, where lines would change
            shared::vec2 p = anyPoint(rng);
            if (isAtBorder) p.y = float(rng.integer(0, warp.rows)) / float(warp.rows);
            const shared::vec2 q{p.x, p.y + 1e-5f};
            const shared::LxWarped a = read.forward(p), b = read.forward(q);
            // Steps are at most 20 times as long as even ones, and differ by the whole square from line to line.
            const double steepest = 20.0 + warp.rows;
            EXPECT_LT(distance(a.at, b.at), 1e-5 * steepest * (1 + 20 + warp.columns) + 1e-6);
        }
    });
}

TEST(TextureWarp, ManyWarpsShareATableOfKnots)
{
    forEachCase(test::kCases, [](Rng& rng) {
        std::vector<float> knots;
        for (int i = 0; i < 4; ++i) {
            const Read alone = anyRead(rng);
            const shared::ShadowWarp row = appendWarp(alone.warp, knots);
            const auto knot = [&](int k) { return knots[std::size_t(k)]; };
            const shared::vec2 p = anyPoint(rng);
            EXPECT_EQ(distance(shared::lxWarped(row, p, knot).at, alone.forward(p).at), 0);
            EXPECT_EQ(distance(shared::lxUnwarped(row, p, knot), alone.back(p)), 0);
        }
        EXPECT_EQ(appendWarp(TextureWarp{}, knots).kind.x, shared::LX_WARP_NONE);
    });
}

} // namespace
} // namespace lixel
