// SPDX-License-Identifier: MIT
#include "lixel/judge/shades.h"

#include "support/random_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lixel {
namespace {

// A square picture of one plane that faces the light, a sample a pixel.
ViewSamples squareOf(int side)
{
    ViewSamples samples;
    samples.width = samples.height = side;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            samples.pixel.push_back({float(x) + 0.5f, float(y) + 0.5f});
            samples.positionLocal.push_back({float(x), float(y), 0});
            samples.normal.push_back({0, 0, 1});
            samples.triangle.push_back(kNoTriangle);
        }
    return samples;
}

// A straight boundary in any direction with a linear ramp across it is as wide as its middle nine tenths.
TEST(Shades, ARampIsAsWideAcrossTheBoundaryInAnyDirection)
{
    constexpr int kSide = 200;
    const ViewSamples samples = squareOf(kSide);
    const std::vector<Zone> zones(samples.size(), Zone::Interior);
    double sum = 0;
    int count = 0;
    test::forEachCase(test::kCases, [&](test::Rng& rng) {
        const double angle = rng.uniform(0, 6.2831853), width = 8;
        const double x = std::cos(angle), y = std::sin(angle);
        std::vector<float> visibility, exact;
        for (const Vec2f& pixel : samples.pixel) {
            const double across = x * (double(pixel.x) - kSide / 2) + y * (double(pixel.y) - kSide / 2);
            visibility.push_back(float(std::clamp(0.5 + across / width, 0.0, 1.0)));
            exact.push_back(across >= 0 ? 1.0f : 0.0f);
        }
        const Shades shades = shadesOf(samples, zones, visibility, exact);
        // Along an axis a boundary counts pi / 4 of its length, along a diagonal pi / 4 * sqrt(2); there is a row more or less.
        EXPECT_GT(shades.transitionPixels(), (0.9 * width - 1) * 0.9);
        EXPECT_LT(shades.transitionPixels(), (0.9 * width + 1) * 1.2733);
        sum += shades.transitionPixels();
        ++count;
    });
    EXPECT_NEAR(sum / count, 0.9 * 8, 0.05 * 8);
}

TEST(Shades, DistinctOnesAreCountedOfSamplesThatFaceTheLight)
{
    const ViewSamples samples = squareOf(3);
    std::vector<Zone> zones(9, Zone::EdgeBand);
    zones[8] = Zone::FacingAway;
    const std::vector<float> visibility{0, 0, 0.5f, 1.0f / 3, 1.0f / 3, 1, 1, 1, 0.75f}, exact(9, 1.0f);
    EXPECT_EQ(shadesOf(samples, zones, visibility, exact).distinct, 4);
    EXPECT_EQ(shadesOf(samples, zones, visibility, exact).transitionPixels(), 0); // there is no boundary
}

TEST(Shades, LightBleedsIntoDarkInteriorsOnly)
{
    const ViewSamples samples = squareOf(2);
    const std::vector<Zone> zones{Zone::Interior, Zone::Interior, Zone::EdgeBand, Zone::Interior};
    const std::vector<float> exact{0, 0, 0, 1}, visibility{0.5f, 0, 1, 0.25f};
    const Shades shades = shadesOf(samples, zones, visibility, exact);
    EXPECT_DOUBLE_EQ(shades.bleedingPercent(), 25);
    EXPECT_EQ(shades.darkInterior, 2);
    EXPECT_EQ(shades.litDarkInterior, 1); // one half is lit
}

TEST(Shades, ErrorsAreRootMeanSquareAndLargest)
{
    const std::vector<float> a{0, 1, 0.5f, 0}, b{0, 0.5f, 0.5f, 0};
    EXPECT_DOUBLE_EQ(shadeError(a, b).rootMeanSquare(), 0.25);
    EXPECT_DOUBLE_EQ(shadeError(a, b).largest, 0.5);
    EXPECT_EQ(shadeError({}, {}).rootMeanSquare(), 0);
}

} // namespace
} // namespace lixel
