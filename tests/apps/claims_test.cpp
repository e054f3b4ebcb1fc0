// SPDX-License-Identifier: MIT
// What papers say in words, held against made-up numbers.
#include "experiments/claim_rules.h"
#include "experiments/claims.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace lixel::app {
namespace {

using Numbers = std::initializer_list<std::pair<const char*, double>>;

Reproduction with(Numbers numbers, bool isQuick = false)
{
    Reproduction out;
    out.isQuick = isQuick;
    for (const auto& [key, value] : numbers) out.numbers.push_back({key, "", value, std::nullopt, ""});
    return out;
}

Reproduction withTimes(Numbers times, bool isQuick = false)
{
    Reproduction out = with(times, isQuick);
    std::swap(out.numbers, out.timingNumbers);
    return out;
}

// The one whose sentence holds these words.
ReproducedClaim claimOn(std::string_view words, std::string_view experiment, const Reproduction& reproduction)
{
    const std::vector<ReproducedClaim> claims = claimsOf(experiment, reproduction);
    const auto found = std::ranges::find_if(claims, [&](const ReproducedClaim& claim) {
        return std::string_view(claim.sentence).find(words) != std::string_view::npos;
    });
    EXPECT_NE(found, claims.end()) << words;
    return found == claims.end() ? ReproducedClaim{} : *found;
}

TEST(Claims, OfALixelForEveryPixelNameTheScenes)
{
    const ReproducedClaim claim = claimOn("deteriorate badly", "lixel-fig7",
                                          with({{"bunnies: light in front, psm over focused", 3.3},
                                                {"objects: light in front, psm over focused", 0.946}}));
    EXPECT_EQ(claim.holds, false);
    EXPECT_EQ(claim.measured, "bunnies 3.3; objects 0.946 (errors of psm over those of focused; at least 1.5)");
    EXPECT_EQ(claim.source, "section 4");
    EXPECT_FALSE(claim.isOfTiming);
}

TEST(Claims, OfMultipleDepthsNameTheLookupWhole)
{
    constexpr const char* kAgainst = ": RMSE over that of PCF(16,1), against the 4x4 footprint of PCF(16,1)";
    Reproduction run;
    for (const auto& [lookup, error] : {std::pair("depths(3)+pcf(9)", 1.07), std::pair("depths(3,q=25)+pcf(9)", 2.12),
                                        std::pair("depths(3)+pcf(4)", 0.5), std::pair("depths(2,max)+pcf(9)", 0.6)})
        run.numbers.push_back({std::string("planar, ") + lookup + kAgainst, "ratio", error, std::nullopt, ""});
    const ReproducedClaim claim = claimOn("On a plane three depths and 3x3 taps", "multiple-depth-figures", run);
    EXPECT_EQ(claim.holds, true);
    EXPECT_TRUE(claim.measured.starts_with("depths(3)+pcf(9) 1.07 (")) << claim.measured;
}

// The misclassified percents stand beside their ratio under keys that begin and end alike.
TEST(Claims, OfSceneOptimisedMapsCompareMapsOfTwoSizesByTheRatioAlone)
{
    const Numbers numbers{{"4 lights: optimal 1250x1250, misclassified", 0.03},
                          {"4 lights: focused 1750x1750, misclassified", 0.02},
                          {"4 lights: optimal 1250x1250 over focused 1750x1750, misclassified", 1.5}};
    const ReproducedClaim full = claimOn("similar quality", "scene-optimised-table2", with(numbers));
    EXPECT_EQ(full.holds, false);
    EXPECT_TRUE(full.measured.starts_with("optimal 1250x1250 over focused 1750x1750: 1.5 (")) << full.measured;
    EXPECT_EQ(claimOn("similar quality", "scene-optimised-table2", with(numbers, true)).holds, std::nullopt);
}

TEST(Claims, OfTableOneAreOfItsCells)
{
    Reproduction run;
    run.tables = {{"Errors", "pixels", "Table 1", {{"Optimal", ""}, {"Focused", ""}, {"LiSPSM", ""}}, {}}};
    run.tables.front().rows = {{"using all data", {{2811.1, {}}, {4087.2, {}}, {3209, {}}}}};
    const ReproducedClaim claim = claimOn("27.65 %", "scene-optimised-table1", run);
    EXPECT_EQ(claim.holds, true);
    EXPECT_TRUE(claim.measured.starts_with("Focused 1.45 (")) << claim.measured;
    EXPECT_EQ(claimOn("LiSPSM makes more errors", "scene-optimised-table1", run).holds, false);
    const ReproducedClaim fewest = claimOn("fewest errors of the five", "scene-optimised-table1", run);
    EXPECT_TRUE(fewest.measured.starts_with("Optimal 2810; Focused 4090; LiSPSM 3210")) << fewest.measured;
}

TEST(Claims, OfWarpsComparePlaceByPlace)
{
    const Reproduction run = with({{"city (Observatory): Ours, misclassified", 2},
                                   {"city (Observatory): RTW, misclassified", 4},
                                   {"sponza (Sponza): Ours, misclassified", 3},
                                   {"sponza (Sponza): RTW, misclassified", 2.5},
                                   {"hall (Hall): Ours, misclassified", 7}});
    const ReproducedClaim claim = claimOn("better results than RTW", "now-table3", run);
    EXPECT_EQ(claim.holds, false);
    EXPECT_TRUE(claim.measured.starts_with("city (Observatory): 0.5; sponza (Sponza): 1.2 (")) << claim.measured;
}

// Two pictures are too few for a quick run; their number is told in any.
TEST(Claims, OfWarpsNeedPictures)
{
    const auto holds = [](const char* key, bool isQuick) {
        return claimOn("than the desired view when the camera renders a bigger", "now-figures",
                       with({{key, 1.2}}, isQuick))
            .holds;
    };
    EXPECT_EQ(holds("more than 30 % of the map seen, 2 pictures: Ours over Ours-DV", true), std::nullopt);
    EXPECT_EQ(holds("more than 30 % of the map seen, 2 pictures: Ours over Ours-DV", false), false);
    EXPECT_EQ(holds("more than 30 % of the map seen, 17 pictures: Ours over Ours-DV", true), false);
}

Reproduction shades(double seen, double missing, bool isQuick)
{
    Reproduction out;
    out.isQuick = isQuick;
    out.numbers = {{"PCF(1,1)", "shades", 2, 2, ""}, {"PCF(25,8)", "shades", seen - missing, 201, ""}};
    return out;
}

// One picture that shows fewer shades says nothing; one that shows more refutes.
TEST(Claims, ThatAQuickRunCannotDecideAreLeftOpen)
{
    const auto holds = [](const Reproduction& run) {
        return claimOn("nk + 1 outcomes", "multiple-depth-table1", run).holds;
    };
    EXPECT_EQ(holds(shades(201, 0, false)), true);
    EXPECT_EQ(holds(shades(201, 0, true)), true);
    EXPECT_EQ(holds(shades(201, 5, false)), false);
    EXPECT_EQ(holds(shades(201, 5, true)), std::nullopt);
    EXPECT_EQ(holds(shades(202, 0, true)), false);
    const ReproducedClaim open = claimOn("nk + 1 outcomes", "multiple-depth-table1", shades(201, 5, true));
    EXPECT_NE(open.measured.find("1 of 2 entries"), std::string::npos) << open.measured;
    EXPECT_NE(open.measured.find("; open: one small picture"), std::string::npos) << open.measured;
}

// Of several numbers one that is clearly beyond a bound decides, and else one that is near.
TEST(Claims, NearABoundAreOpenInQuickRunsOnly)
{
    const auto holds = [](double bunnies, double objects, bool isQuick) {
        const Reproduction run = with({{"bunnies: light in front, psm over focused", bunnies},
                                       {"objects: light in front, psm over focused", objects}},
                                      isQuick);
        return claimOn("deteriorate badly", "lixel-fig7", run).holds;
    };
    EXPECT_EQ(holds(1.45, 3, true), std::nullopt);
    EXPECT_EQ(holds(1.55, 3, true), std::nullopt);
    EXPECT_EQ(holds(1.45, 0.9, true), false);
    EXPECT_EQ(holds(1.6, 3, true), true);
    EXPECT_EQ(holds(1.45, 3, false), false);
    EXPECT_EQ(holds(1.55, 3, false), true);
}

// A quick run's frames are smaller than the paper's: too slow is too slow, fast enough says nothing.
TEST(Claims, OfEasierOrHarderCasesAreDecidedOneWay)
{
    const auto rate = [](double fps, bool isQuick) {
        const ReproducedClaim claim = claimOn("thirtieth of a second", "lixel-fig7",
                                              withTimes({{"bunnies: planes(floor,wall)+plane-optimal", fps}}, isQuick));
        EXPECT_TRUE(claim.isOfTiming);
        return claim.holds;
    };
    EXPECT_EQ(rate(37, false), true);
    EXPECT_EQ(rate(37, true), std::nullopt);
    EXPECT_EQ(rate(3, true), false);
    const auto cost = [](double ratio, bool isQuick) {
        return claimOn("at most 1.19", "scene-optimised-table2",
                       withTimes({{"1 light, 100x100: optimal over focused, mean", ratio}}, isQuick))
            .holds;
    };
    EXPECT_EQ(cost(1.1, true), true);
    EXPECT_EQ(cost(1.3, true), std::nullopt);
    EXPECT_EQ(cost(1.3, false), false);
}

// No crossing is a result too.
TEST(Claims, SayWhereCostsNeverBreakEven)
{
    const Numbers never{{"lambda 0.500: PCF(16,1)", 3}, {"lambda 1.500: PCF(16,1)", 20}};
    const ReproducedClaim claim = claimOn("1.28 times the lixels", "multiple-depth-cost", withTimes(never));
    EXPECT_EQ(claim.holds, false);
    EXPECT_TRUE(claim.measured.starts_with("not up to pictures of 1.500 times")) << claim.measured;
    Reproduction crossed = withTimes(never);
    crossed.timingNumbers.push_back({"measured break-even, f / (h w)", "", 0.62, std::nullopt, ""});
    EXPECT_EQ(claimOn("1.28 times the lixels", "multiple-depth-cost", crossed).holds, true);
}

TEST(Claims, WithoutTheirNumbersAreLeftOut)
{
    for (const char* experiment :
         {"lixel-fig7", "normal-against-focused", "scene-optimised-table1", "scene-optimised-table2",
          "scene-optimised-table3", "multiple-depth-table1", "multiple-depth-figures", "multiple-depth-cost",
          "now-table1", "now-table2", "now-table3", "now-figures", "no-such-experiment"})
        EXPECT_TRUE(claimsOf(experiment, {}).empty()) << experiment;
    EXPECT_EQ(claimsOf("lixel-fig7", with({{"bunnies: psm errs less than focused", 30}})).size(), 1u);
}

TEST(Claims, WriteThreeDigitsWithoutExponents)
{
    EXPECT_EQ(shortly(2811.1), "2810");
    EXPECT_EQ(shortly(99.96), "100");
    EXPECT_EQ(shortly(1'886'057), "1890000");
    EXPECT_EQ(shortly(-143.21), "-143");
    EXPECT_EQ(shortly(1.0952), "1.1");
    EXPECT_EQ(shortly(0.00331), "0.00331");
    EXPECT_EQ(shortly(0), "0");
    EXPECT_EQ(shortly(0.0000123), "0.0000123");
}

TEST(Claims, PatternsTellThePlaceWithinTheirBraces)
{
    const Reproduction run = with({{"a, one: x", 1}, {"a, two: x", 2}, {"b, one: x", 3}, {"a, one: y", 4}});
    const std::vector<Place> places = placesOf("a, {*}: x", run);
    ASSERT_EQ(places.size(), 2u);
    EXPECT_EQ(places[0].name, "one");
    EXPECT_EQ(places[1].value, 2);
    EXPECT_EQ(placesOf("{*one}: x", run).size(), 2u);
    EXPECT_EQ(placesOf("{a, t*o}: x", run).front().name, "a, two");
    EXPECT_EQ(placesOf("{?, one}: x", run).size(), 2u);
    EXPECT_TRUE(placesOf("{?one}: x", run).empty());
    EXPECT_EQ(placesOf("a, one: x", run).size(), 1u);
    EXPECT_TRUE(placesOf("a, one", run).empty());
    EXPECT_TRUE(placesOf("a, *: x", run).empty()) << "outside of braces a star is a star";
}

} // namespace
} // namespace lixel::app
