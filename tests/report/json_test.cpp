// SPDX-License-Identifier: MIT
#include "lixel/report/json.h"

#include "sample_results.h"
#include "schema_check.h"
#include "support/random_cases.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

namespace lixel::test {
namespace {

using Json = nlohmann::json;

Measurement& firstMeasured(RunResults& run)
{
    for (ResultRow& row : run.rows)
        if (auto* measured = std::get_if<Measurement>(&row.outcome)) return *measured;
    throw std::logic_error("no row is measured");
}

std::string withoutTiming(const std::string& text)
{
    Json json = Json::parse(text);
    json.erase("timing");
    for (Json& row : json["results"]) row.erase("timing");
    return json.dump();
}

TEST(ResultsJson, IsValidByItsSchema)
{
    EXPECT_EQ(schemaError(toJson(sampleRun())), "");
    EXPECT_EQ(schemaError(toJson(samplePath())), "");
    EXPECT_EQ(schemaError(toJson(sampleReproduction({}, 32))), "");
    EXPECT_EQ(schemaError(toJson(samplePlaneBudget({}, 32))), "");
    EXPECT_EQ(schemaError(toJson(sampleLookups({}, 32))), "");
}

TEST(ResultsJson, IsValidWhenNothingWasMeasuredOrCounted)
{
    RunResults run;
    EXPECT_EQ(schemaError(toJson(run)), "");
    run.rows = {sampleRun().rows.front()};
    run.rows.front().outcome = Measurement{};
    EXPECT_EQ(schemaError(toJson(run)), "");
}

// The schema is closed: it finds what a later change adds, drops or misspells.
TEST(ResultsJson, SchemaForbidsOtherMembers)
{
    const Json good = Json::parse(toJson(samplePath()));
    const auto broken = [&](auto change) {
        Json json = good;
        change(json);
        return schemaError(json.dump());
    };
    EXPECT_NE(broken([](Json& json) { json["extra"] = 1; }), "");
    EXPECT_NE(broken([](Json& json) { json["version"] = 2; }), "");
    EXPECT_NE(broken([](Json& json) { json["results"][0]["extra"] = 1; }), "");
    EXPECT_NE(broken([](Json& json) { json["results"][0].erase("technique"); }), "");
    EXPECT_NE(broken([](Json& json) { json["results"][0]["misclassified"] = -1; }), "");
    EXPECT_NE(broken([](Json& json) { json["results"][0]["size"] = "wide"; }), "");
    EXPECT_NE(broken([](Json& json) { json["results"][0]["timing"]["frame_ms"] = "3"; }), "");
    EXPECT_NE(broken([](Json& json) { json["results"][0].erase("timing"); }), "");
    EXPECT_NE(broken([](Json& json) { json["results"][0]["temporal"]["extra"] = 1; }), "");
    EXPECT_NE(broken([](Json& json) { json["results"][0]["temporal"].erase("flips"); }), "");
    EXPECT_NE(broken([](Json& json) { json["results"][0]["temporal"]["pairs"][0]["flips"] = -1; }), "");
}

TEST(ResultsJson, OrderOfRowsIsNothing)
{
    RunResults run = sampleRun();
    const std::string expected = toJson(run);
    forEachCase(kCases, [&](Rng& rng) {
        std::shuffle(run.rows.begin(), run.rows.end(), std::mt19937_64(rng.bits()));
        ASSERT_EQ(toJson(run), expected);
    });
}

TEST(ResultsJson, RowsAreSortedByTheirKey)
{
    const Json json = Json::parse(toJson(sampleRun()));
    std::vector<std::vector<std::string>> keys;
    for (const Json& row : json["results"]) {
        keys.emplace_back();
        for (const char* part : {"scene", "view", "light", "technique_full", "lixels", "size", "executor"})
            keys.back().push_back(row[part]);
    }
    EXPECT_TRUE(std::is_sorted(keys.begin(), keys.end()));
    EXPECT_EQ(std::adjacent_find(keys.begin(), keys.end()), keys.end());
}

TEST(ResultsJson, NumbersReadBackAsTheSameValue)
{
    RunResults run = sampleRun();
    run.rows = {run.rows.front()};
    forEachCase(kCases, [&](Rng& rng) {
        const double value = rng.logUniform(1e-12, 1e12);
        firstMeasured(run).timing.frameMs = value;
        ASSERT_EQ(Json::parse(toJson(run))["results"][0]["timing"]["frame_ms"], value);
    });
}

TEST(ResultsJson, OnlyTimingDependsOnTheClock)
{
    RunResults run = sampleRun();
    const std::string before = toJson(run);
    run.timing = {"2030-01-01T00:00:00Z", "another machine", 99};
    for (ResultRow& row : run.rows)
        if (auto* measured = std::get_if<Measurement>(&row.outcome))
            measured->timing = {.frameMs = 77, .passes = {{"x", 1}}, .gpuMs = 5, .clock = "another"};
    EXPECT_NE(toJson(run), before);
    EXPECT_EQ(withoutTiming(toJson(run)), withoutTiming(before));
}

TEST(ResultsJson, PercentagesAreThoseOfTheCounts)
{
    RunResults run = sampleRun();
    run.rows = {run.rows.front()};
    Measurement& measured = firstMeasured(run);
    measured.lightFacing = 800;
    measured.misclassified = 3;
    measured.interior = {0, 0};
    const Json row = Json::parse(toJson(run))["results"][0];
    EXPECT_EQ(row["misclassified_percent"], 0.375);
    EXPECT_TRUE(row["interior_percent"].is_null()); // a share of nothing
}

TEST(ResultsJson, ShadesOfATechniqueWithoutAMapHaveNoFilter)
{
    RunResults run = sampleRun();
    run.rows = {run.rows.front()};
    firstMeasured(run).shades = ShadeQuality{3, 1.5, 0, {}, {0.5, 1}, {}, {}};
    const Json told = Json::parse(toJson(run))["results"][0]["shades"];
    EXPECT_EQ(told["area_rmse"], 0.5);
    EXPECT_TRUE(told["filter_lixels"].is_null() && told["filtered_rmse"].is_null());
}

TEST(ResultsJson, FlipsAreToldOfPathsOnlyWithTheirShares)
{
    EXPECT_FALSE(Json::parse(toJson(sampleRun()))["results"][0].contains("temporal"));
    RunResults run = samplePath();
    run.rows = {run.rows.front()};
    Temporal& temporal = *firstMeasured(run).temporal;
    temporal.all = {800, 3};
    temporal.terminatorBand = {0, 0};
    const Json told = Json::parse(toJson(run))["results"][0]["temporal"];
    EXPECT_EQ(told["flips_percent"], 0.375);
    EXPECT_TRUE(told["terminator_band_flips_percent"].is_null()); // a share of nothing
    EXPECT_EQ(told["pairs"].size() + 1, told["frames"].get<std::size_t>());
}

TEST(ResultsJson, WhatOfAnExperimentDependsOnTheClockStandsInItsTiming)
{
    const Json json = Json::parse(toJson(sampleReproduction({}, 32))).at("reproduction");
    ASSERT_EQ(json.at("numbers").size(), 2u);
    EXPECT_EQ(json.at("numbers")[0].at("papers"), 2.25);
    EXPECT_TRUE(json.at("numbers")[1].at("papers").is_null());
    ASSERT_EQ(json.at("timing").at("numbers").size(), 1u);
    EXPECT_EQ(json.at("timing").at("numbers")[0].at("ours"), 290);
    ASSERT_EQ(json.at("charts").size(), 1u);
    EXPECT_EQ(json.at("charts")[0].at("lines")[0].at("points"), Json::parse("[[1, 2], [4, 8]]"));
    ASSERT_EQ(json.at("timing").at("charts").size(), 1u);
    EXPECT_EQ(json.at("timing").at("charts")[0].at("title"), "Frames");
}

// A row's first cell is what the others are more than; nothing is more than none.
TEST(ResultsJson, ATablesPercentagesAreThoseOfItsCells)
{
    const Json table = Json::parse(toJson(sampleReproduction({}, 32))).at("reproduction").at("tables").at(0);
    const Json& cells = table.at("rows")[0].at("cells");
    ASSERT_EQ(cells.size(), table.at("columns").size());
    EXPECT_EQ(cells[0].at("percent_more"), 0);
    EXPECT_EQ(cells[1].at("percent_more"), 150);
    EXPECT_EQ(cells[1].at("papers_percent_more"), 150);
    EXPECT_EQ(cells[2].at("percent_more"), -25);
    EXPECT_TRUE(cells[2].at("papers_percent_more").is_null());
    EXPECT_TRUE(table.at("rows")[1].at("cells")[1].at("percent_more").is_null());
}

TEST(ResultsJson, AStudysPercentagesAreThoseOfItsCounts)
{
    const Json json = Json::parse(toJson(samplePlaneBudget({}, 32)));
    for (const Json& curve : json.at("study").at("curves"))
        for (const Json& point : curve.at("points"))
            EXPECT_EQ(point.at("misclassified_percent").get<double>(),
                      100 * point.at("misclassified").get<double>() / point.at("samples").get<double>());
}

TEST(ResultsJson, InfinityIsNull)
{
    RunResults run = sampleRun();
    run.rows = {run.rows.front()};
    firstMeasured(run).footprintPixelsPerLixel = Percentiles{1, 2, 3, 4, 5, std::numeric_limits<double>::infinity()};
    const std::string text = toJson(run);
    EXPECT_TRUE(Json::parse(text)["results"][0]["footprint_pixels_per_lixel"]["max"].is_null());
    EXPECT_EQ(schemaError(text), "");
}

TEST(ResultsJson, TakesEveryText)
{
    RunResults run = sampleRun();
    run.rows = {run.rows.front()};
    run.rows.front().scene = "a \"quoted\"\\name\n\t\x01 Grüße";
    run.rows.front().view = "not UTF-8: \xff\xc3";
    const Json row = Json::parse(toJson(run))["results"][0];
    EXPECT_EQ(row["scene"], run.rows.front().scene);
    EXPECT_EQ(row["view"], "not UTF-8: \uFFFD\uFFFD");
    EXPECT_EQ(schemaError(toJson(run)), "");
}

} // namespace
} // namespace lixel::test
