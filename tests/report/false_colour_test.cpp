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

} // namespace
} // namespace lixel::test
