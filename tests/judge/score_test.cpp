// SPDX-License-Identifier: MIT
#include "lixel/judge/score.h"

#include <gtest/gtest.h>

namespace lixel {
namespace {

// A picture of a flat floor under a light from above, one sample a pixel.
ViewSamples floorSamples(int width, int height)
{
    ViewSamples samples;
    samples.width = width;
    samples.height = height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            samples.pixel.push_back({float(x) + 0.5f, float(y) + 0.5f});
            samples.positionLocal.push_back({float(x), 0, float(y)});
            samples.normal.push_back({0, 1, 0});
            samples.triangle.push_back(0);
        }
    return samples;
}

Light sun() { return {}; }

TEST(Zones, AStraightBoundaryHasABandOfTwoPixelsOnEachSide)
{
    const ViewSamples samples = floorSamples(16, 9);
    std::vector<float> exact;
    for (const Vec2f& pixel : samples.pixel) exact.push_back(pixel.x < 8 ? 1.0f : 0.0f);
    const std::vector<Zone> zones = zonesOf(samples, sun(), exact);
    for (std::size_t i = 0; i < zones.size(); ++i) {
        const bool isNear = samples.pixel[i].x > 6 && samples.pixel[i].x < 10;
        EXPECT_EQ(zones[i], isNear ? Zone::EdgeBand : Zone::Interior) << samples.pixel[i].x;
    }
}

TEST(Zones, WhatFacesAwayHasATerminatorBandAndNoBoundary)
{
    ViewSamples samples = floorSamples(12, 5);
    for (std::size_t i = 0; i < samples.size(); ++i)
        if (samples.pixel[i].x > 6) samples.normal[i] = {0, -1, 0};
    std::vector<float> exact;
    for (const Vec2f& pixel : samples.pixel) exact.push_back(pixel.x < 6 ? 1.0f : 0.0f);
    const std::vector<Zone> zones = zonesOf(samples, sun(), exact);
    for (std::size_t i = 0; i < zones.size(); ++i) {
        const float x = samples.pixel[i].x;
        EXPECT_EQ(zones[i], x > 6 ? Zone::FacingAway : x > 4 ? Zone::TerminatorBand : Zone::Interior) << x;
    }
}

TEST(Score, CountsEachKindOfErrorInItsZoneAndRoundsOneHalfToLit)
{
    const std::vector<Zone> zones{Zone::Interior,       Zone::Interior,   Zone::EdgeBand,
                                  Zone::TerminatorBand, Zone::FacingAway, Zone::EdgeBand};
    const std::vector<float> exact{1, 0, 1, 1, 0, 0};
    const Visibility visibility{{0.5f, 0.49f, 0, 0.25f, 1, 1}, {0, 0, 0, 0, 1, 1}};
    const Score s = score(zones, visibility, exact);
    EXPECT_EQ(s.lightFacing, 5);
    EXPECT_EQ(s.misclassified, 3);
    EXPECT_EQ(s.falseShadow, 2);
    EXPECT_EQ(s.falseLit, 1);
    EXPECT_EQ(s.unserved, 1);
    EXPECT_EQ(s.edgeBand.samples, 2);
    EXPECT_EQ(s.edgeBand.misclassified, 2);
    EXPECT_EQ(s.terminatorBand.misclassified, 1);
    EXPECT_EQ(s.interior.misclassified, 0);
    EXPECT_DOUBLE_EQ(s.misclassifiedPercent(), 60);
}

TEST(ExecutorAgreement, CountsAlikeRoundingAndSharedErrors)
{
    const std::vector<Zone> zones(4, Zone::Interior);
    const std::vector<float> exact{1, 1, 1, 1};
    const ExecutorAgreement a = agreement(zones, {{1, 0, 0, 1}, {}}, {{1, 0, 1, 1}, {}}, exact);
    EXPECT_EQ(a.agreeing, 3);
    EXPECT_EQ(a.misclassifiedByEither, 2);
    EXPECT_EQ(a.misclassifiedByBoth, 1);
}

} // namespace
} // namespace lixel
