// SPDX-License-Identifier: MIT
#include "lixel/judge/temporal.h"

#include "support/random_cases.h"

#include <gtest/gtest.h>

namespace lixel {
namespace {

using enum ShadowState;
using test::forEachCase;
using test::kCases;
using test::Rng;
using States = std::vector<ShadowState>;

std::vector<std::uint32_t> inOrder(std::size_t count)
{
    std::vector<std::uint32_t> from;
    for (std::size_t i = 0; i < count; ++i) from.push_back(std::uint32_t(i));
    return from;
}

TEST(ShadowStates, RoundOneHalfToLitAndLeaveOutWhatNoRegionHolds)
{
    EXPECT_EQ(statesOf({{1, 0.5f, 0.49f, 0}, {}}), (States{Lit, Lit, Dark, Dark}));
    EXPECT_EQ(statesOf({{1, 0, 1, 0}, {1, 0, 0, 1}}), (States{None, Dark, Lit, None}));
}

TEST(ShadowStates, OfTheTruthLeaveOutWhatFacesAwayHoweverItIsTold)
{
    ViewSamples samples;
    samples.positionLocal = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    samples.normal = {{0, 1, 0}, {0, 1, 0}, {0, -1, 0}};
    const std::vector<float> exact{1, 0, 0};
    const States expected{Lit, Dark, None};
    EXPECT_EQ(exactStates(samples, Light(), exact), expected); // light travels down
    EXPECT_EQ(exactStates(std::vector{Zone::Interior, Zone::EdgeBand, Zone::FacingAway}, exact), expected);
}

TEST(TemporalScore, AFlipIsAMapThatChangesWhereTheTruthDoesNot)
{
    for (const ShadowState map : {None, Dark, Lit})
        for (const ShadowState mapNow : {None, Dark, Lit})
            for (const ShadowState exact : {None, Dark, Lit})
                for (const ShadowState exactNow : {None, Dark, Lit}) {
                    const States m{map}, n{mapNow}, e{exact}, f{exactNow};
                    const TemporalScore score = temporalScore({m, e}, std::vector{Zone::Interior}, {n, f}, inOrder(1));
                    const bool couldFlip = map != None && mapNow != None && exact != None && exact == exactNow;
                    EXPECT_EQ(score.all.samples, couldFlip);
                    EXPECT_EQ(score.all.flips, couldFlip && map != mapNow);
                }
}

TEST(TemporalScore, SamplesCountInTheirZoneOfTheFrameBefore)
{
    const std::vector<Zone> zones{Zone::EdgeBand, Zone::Interior, Zone::TerminatorBand, Zone::EdgeBand};
    const States before(4, Lit), exact(4, Lit);
    // Three of the four are still seen, in another order.
    const std::vector<std::uint32_t> from{3, 2, 0};
    const States now{Dark, Dark, Lit}, exactNow(3, Lit);
    const TemporalScore score = temporalScore({before, exact}, zones, {now, exactNow}, from);
    EXPECT_EQ(score.edgeBand.samples, 2);
    EXPECT_EQ(score.edgeBand.flips, 1);
    EXPECT_EQ(score.terminatorBand.samples, 1);
    EXPECT_EQ(score.terminatorBand.flips, 1);
    EXPECT_EQ(score.interior.samples, 0);
    EXPECT_DOUBLE_EQ(score.all.percent(), 100.0 * 2 / 3);
}

// Whatever the maps say: what says the truth in both frames, or the same in both, flips nowhere; and zones add up.
TEST(TemporalScore, OfTheTruthOrOfWhatStaysIsZeroAndZonesAddUp)
{
    forEachCase(kCases, [](Rng& rng) {
        const auto any = [&](std::initializer_list<ShadowState> of) {
            return of.begin()[rng.integer(0, int(of.size()) - 1)];
        };
        States map, mapNow, exact, exactNow;
        std::vector<Zone> zones;
        for (int i = 0; i < 40; ++i) {
            map.push_back(any({None, Dark, Lit})), mapNow.push_back(any({None, Dark, Lit}));
            exact.push_back(any({None, Dark, Lit})), exactNow.push_back(any({None, Dark, Lit}));
            zones.push_back(Zone(rng.integer(1, 3)));
        }
        const auto from = inOrder(40);
        EXPECT_EQ(temporalScore({exact, exact}, zones, {exactNow, exactNow}, from).all.flips, 0);
        EXPECT_EQ(temporalScore({map, exact}, zones, {map, exactNow}, from).all.flips, 0);
        TemporalScore once = temporalScore({map, exact}, zones, {mapNow, exactNow}, from);
        EXPECT_EQ(once.all.flips, once.edgeBand.flips + once.terminatorBand.flips + once.interior.flips);
        EXPECT_EQ(once.all.samples, once.edgeBand.samples + once.terminatorBand.samples + once.interior.samples);
        const TemporalScore one = once;
        once += one;
        EXPECT_EQ(once.all.flips, 2 * one.all.flips);
        EXPECT_EQ(once.interior.samples, 2 * one.interior.samples);
    });
}

} // namespace
} // namespace lixel
