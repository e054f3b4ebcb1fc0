// SPDX-License-Identifier: MIT
#include "lixel/report/false_colour.h"

#include "support/random_cases.h"

#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <limits>
#include <set>
#include <tuple>

namespace lixel::test {
namespace {

int lightness(Rgba8 c) { return 299 * c.r + 587 * c.g + 114 * c.b; }

TEST(DensityColour, FallsInLightnessBothWaysFromOneLixelAPixel)
{
    for (int way : {-1, 1})
        for (int step = 0; step < 100; ++step) {
            const double octaves = way * kDensityOctaves * step / 100.0,
                         further = way * kDensityOctaves * (step + 1) / 100.0;
            EXPECT_GT(lightness(densityColour(std::exp2(octaves))), lightness(densityColour(std::exp2(further))));
        }
}

TEST(DensityColour, IsRedWhereLixelsAreTooFewAndBlueWhereTheyAreManyEnough)
{
    forEachCase(kCases, [](Rng& rng) {
        const Rgba8 few = densityColour(rng.logUniform(1e-9, 0.5)), many = densityColour(rng.logUniform(2, 1e9));
        EXPECT_GT(few.r, few.b);
        EXPECT_LT(many.r, many.b);
    });
}

TEST(DensityColour, ClampsAtItsEnds)
{
    EXPECT_EQ(densityColour(0), densityColour(std::exp2(-kDensityOctaves)));
    EXPECT_EQ(densityColour(std::numeric_limits<double>::infinity()), densityColour(std::exp2(kDensityOctaves)));
}

TEST(FootprintColour, IsThatOfTheDensityOfSquareLixelsAsLongTurnedRound)
{
    forEachCase(kCases, [](Rng& rng) {
        const double pixelsPerLixel = rng.logUniform(1e-3, 1e3);
        EXPECT_EQ(footprintColour(pixelsPerLixel), densityColour(1 / pixelsPerLixel));
        const Rgba8 longer = footprintColour(rng.logUniform(2, 1e9)),
                    shorter = footprintColour(rng.logUniform(1e-9, 0.5));
        EXPECT_GT(longer.r, longer.b);
        EXPECT_LT(shorter.r, shorter.b);
    });
    EXPECT_EQ(footprintColour(std::numeric_limits<double>::infinity()), densityColour(0)); // edge-on
    EXPECT_EQ(footprintColour(std::numeric_limits<double>::quiet_NaN()).a, 0);
}

TEST(DensityPicture, HasFewEnoughColoursForAPalette)
{
    Image<float> densities(400, 100);
    Rng rng(1);
    for (float& value : densities.data()) value = float(rng.logUniform(1e-6, 1e6));
    densities(0, 0) = std::numeric_limits<float>::quiet_NaN();
    densities(1, 0) = 0;
    densities(2, 0) = std::numeric_limits<float>::infinity();
    std::set<std::tuple<int, int, int, int>> colours;
    const Image<Rgba8> picture = densityPicture(densities);
    for (const Rgba8 c : picture.data()) colours.emplace(c.r, c.g, c.b, c.a);
    EXPECT_LE(colours.size(), 256u);
    EXPECT_EQ(picture(0, 0).a, 0);
    EXPECT_EQ(picture(1, 0), densityColour(0));
    EXPECT_EQ(picture(2, 0), densityColour(1e30));
    const Image<Rgba8> footprint = footprintPicture(densities);
    for (const Rgba8 c : footprint.data()) colours.emplace(c.r, c.g, c.b, c.a);
    EXPECT_LE(colours.size(), 256u) << "the same palette";
    EXPECT_EQ(footprint(0, 0).a, 0);
    EXPECT_EQ(footprint(1, 0), picture(2, 0));
    EXPECT_EQ(footprint(2, 0), picture(1, 0));
}

TEST(ErrorPicture, ShowsOnlyWhatIsWrong)
{
    Image<Verdict> verdicts(4, 1);
    verdicts.data() = {Verdict::NotCounted, Verdict::Right, Verdict::FalseShadow, Verdict::FalseLit};
    const Image<Rgba8> picture = errorPicture(verdicts);
    EXPECT_EQ(picture(0, 0).a, 0);
    EXPECT_EQ(picture(1, 0).a, 0);
    EXPECT_EQ(picture(2, 0).a, 255);
    EXPECT_EQ(picture(3, 0).a, 255);
    EXPECT_GT(picture(2, 0).r, picture(2, 0).b + 100);
    EXPECT_GT(picture(3, 0).b, picture(3, 0).r + 100);
}

// Cells 4 x 4 pixels: a square in each marked cell that is at no depth jump, of that light alone, and none beyond the picture.
TEST(BoundaryPicture, MarksTheCellsThatTheEnergyIsMadeFrom)
{
    forEachCase(kCases, [](Rng& rng) {
        constexpr int kCells = 8, kSize = 32;
        Observation observed;
        observed.grid = {kCells, kCells};
        observed.samples.width = observed.samples.height = kSize;
        const auto light = std::size_t(rng.integer(0, 31));
        Image<int> isMarked(kCells, kCells, 0);
        for (int y = 0; y < kCells; ++y)
            for (int x = 0; x < kCells; ++x) {
                if (rng.chance(0.2)) continue; // the sky
                observed.samples.pixel.push_back({4 * float(x) + 2.5f, 4 * float(y) + 2.5f});
                observed.samples.positionLocal.push_back({0, 0, 0});
                observed.samples.atDepthJump.push_back(std::uint8_t(rng.chance(0.3)));
                observed.atBoundary.push_back(std::uint32_t(rng.bits()));
                isMarked(x, y) = !observed.samples.atDepthJump.back() && (observed.atBoundary.back() >> light & 1u);
            }
        const Image<Rgba8> picture = boundaryPicture(observed, light);
        Image<int> pixels(kCells, kCells, 0);
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x)
                if (picture(x, y).a != 0) ++pixels(x / 4, y / 4);
        for (std::size_t i = 0; i < pixels.data().size(); ++i) ASSERT_EQ(pixels.data()[i], isMarked.data()[i] ? 9 : 0);
        observed.atBoundary.clear();
        const Image<Rgba8> unmarked = boundaryPicture(observed, light);
        for (const Rgba8 pixel : unmarked.data()) ASSERT_EQ(pixel.a, 0);
    });
}

} // namespace
} // namespace lixel::test
