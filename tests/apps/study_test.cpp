// SPDX-License-Identifier: MIT
#include "report/sample_results.h"
#include "report/schema_check.h"
#include "run_command.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace lixel::test {
namespace {

// The title of "A Lixel for every Pixel": every point of the plane has its lixel where its pixel is.
TEST(StudyCommand, OneToOneFindsEveryLixelAtItsPixel)
{
    const CommandResult result = runLixel({"study", "one-to-one", "--count", "1000", "--json", "-"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(schemaError(result.out, "one-to-one.schema.json"), "");
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_LT(json["max_deviation_double_pixels"].get<double>(), 1e-8);
    EXPECT_GT(json["configurations_double"].get<int>(), 900);
    const std::string missing = missingGraphics(std::filesystem::temp_directory_path());
    if (!missing.empty()) GTEST_SKIP() << missing;
    EXPECT_LT(json["max_deviation_gpu_pixels"].get<double>(), 0.01);
    EXPECT_EQ(json["configurations_gpu"], json["configurations_double"]);
}

TEST(StudyCommand, WithTheCpuExecutorLeavesTheDeviceOut)
{
    const CommandResult result =
        runLixel({"study", "one-to-one", "--count", "200", "--executor", "trace", "--json", "-"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(schemaError(result.out, "one-to-one.schema.json"), "");
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_TRUE(json["max_deviation_gpu_pixels"].is_null());
    EXPECT_TRUE(json["why_no_gpu"].is_string());
}

// Two lights: enough for the form; what is within 2 % is the study's to say.
TEST(StudyCommand, SceneOptimalSearchComparesWithTheBestOfVeryManyAxes)
{
    const CommandResult result =
        runLixel({"study", "scene-optimal-search", "--count", "2", "--executor", "trace", "--json", "-"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(schemaError(result.out, "scene-optimal-search.schema.json"), "");
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["cases"].size() + 4 * json["lights_left_out"].get<std::size_t>(), 8u);
    for (const auto& row : json["wide"]) EXPECT_LT(row["worst_ratio"].get<double>(), 1.1) << row;
}

// What is found holds what was asked for, in fewer lixels than focused maps take.
TEST(StudyCommand, ResolutionFindsMapsThatHoldTheTolerance)
{
    const CommandResult result = runLixel({"study", "resolution", "bunnies", "--view", "close-up", "--size", "256x256",
                                           "--tolerance", "1%", "--executor", "trace", "--json", "-"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(schemaError(result.out, "resolution.schema.json"), "");
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["tolerance_percent"], 1);
    const auto& rows = json["rows"];
    ASSERT_EQ(rows.size(), 2u);
    for (const auto& row : rows) EXPECT_LE(row["misclassified_percent"].get<double>(), 1);
    EXPECT_EQ(rows[1]["technique"], "focused");
    EXPECT_LT(rows[0]["lixels"].get<int>(), rows[1]["lixels"].get<int>());
}

TEST(StudyCommand, ResolutionSaysWhereEvenTheLargestMapMissesTheTolerance)
{
    const CommandResult result = runLixel({"study", "resolution", "bunnies", "--view", "close-up", "--size", "64x64",
                                           "--tolerance", "1e-9", "--technique", "focused", "--executor", "trace"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_NE(result.out.find("8192x8192, misses the tolerance"), std::string::npos) << result.out;
}

TEST(StudyCommand, WarpsHaveWhatTheyAreByThemselvesInEveryCurveAndSpreadSamplesMoreEvenly)
{
    const CommandResult result = runLixel({"study", "warps", "colonnade", "--view", "overview", "--size", "64x64",
                                           "--lixels", "32x32", "--executor", "trace", "--json", "-"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(schemaError(result.out, "warps.schema.json"), "");
    const auto json = nlohmann::json::parse(result.out);
    std::map<std::string, std::set<std::int64_t>> own;
    double plain = 0, warped = 0;
    for (const auto& row : json["rows"]) {
        const std::string technique = row["technique"];
        if (row["is_own"].get<bool>()) own[technique.substr(0, 11)].insert(row["misclassified"].get<std::int64_t>());
        if (technique == "desired-view+now") warped = row["used_share"];
        if (technique == "desired-view") plain = row["used_share"];
    }
    ASSERT_EQ(own.size(), 2u); // focused+now and focused+rtw
    for (const auto& [warp, misclassified] : own) EXPECT_EQ(misclassified.size(), 1u) << warp;
    EXPECT_GT(warped, plain);
}

// By every parameter: each curve has what its technique has just once, and that is the same in all of them.
TEST(StudyCommand, SceneOptimalSensitivityMeetsItsTechniqueInEveryCurve)
{
    const CommandResult result =
        runLixel({"study", "scene-optimal-sensitivity", "--lights", "1", "--executor", "trace", "--json", "-"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(schemaError(result.out, "scene-optimal-sensitivity.schema.json"), "");
    const auto json = nlohmann::json::parse(result.out);
    std::map<std::string, std::set<std::int64_t>> own;
    std::map<std::string, int> curves;
    for (const auto& row : json["rows"]) {
        if (!row["is_own"].get<bool>()) continue;
        own[row["technique"]].insert(row["misclassified"].get<std::int64_t>());
        ++curves[row["technique"]];
    }
    ASSERT_EQ(own.size(), 2u);
    for (const auto& [technique, values] : own) EXPECT_EQ(values.size(), 1u) << technique;
    EXPECT_EQ(curves["scene-optimal(uncovered=lit)"], 6);
    EXPECT_EQ(curves["scene-optimal(metric=l2,search=paper,uncovered=lit)"], 8);
}

TEST(StudyCommand, SceneOptimalMetricsRanksEveryMetric)
{
    const CommandResult result =
        runLixel({"study", "scene-optimal-metrics", "--lights", "3", "--executor", "trace", "--json", "-"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(schemaError(result.out, "scene-optimal-metrics.schema.json"), "");
    const auto json = nlohmann::json::parse(result.out);
    ASSERT_EQ(json["metrics"].size(), 4u);
    for (const auto& metric : json["metrics"]) EXPECT_GT(metric["within_lights"].get<double>(), 0) << metric;
}

// On planes errors fall as lixels grow, and with a lixel a pixel there are next to none.
TEST(StudyCommand, PlaneBudgetHasNextToNoErrorsOnPlanesWithALixelAPixel)
{
    const TemporaryFolder folder;
    CommandOptions options;
    options.folder = folder.path();
    const CommandResult result =
        runLixel({"study", "plane-budget", "--quick", "--executor", "trace", "-o", "out"}, options);
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const std::string text = readWhole(folder.path() / "out" / "results.json");
    EXPECT_EQ(schemaError(text), "");
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / "report.html"));
    const auto json = nlohmann::json::parse(text);
    int exact = 0;
    for (const auto& curve : json.at("study").at("curves")) {
        const auto& points = curve.at("points");
        const auto percent = [](const nlohmann::json& point) {
            return point.at("misclassified_percent").get<double>();
        };
        if (curve.at("technique").get<std::string>().find("exact") == std::string::npos) {
            ASSERT_EQ(points.size(), 7u);
            EXPECT_LT(percent(points.back()), 0.5 * percent(points.front()));
        } else if (curve.at("receivers") == "planes") {
            ++exact;
            EXPECT_LT(percent(points.front()), 0.05);
        }
    }
    EXPECT_EQ(exact, 3) << "one a scene";
}

// Every lookup over the same samples; the best ones are beaten by none, and bytes grow with what lixels hold.
TEST(StudyCommand, LookupsStandAgainstBytesWithTheBestNamed)
{
    const TemporaryFolder folder;
    CommandOptions options;
    options.folder = folder.path();
    const CommandResult result =
        runLixel({"study", "lookups", "--quick", "--executor", "trace", "--timing-frames", "0", "-o", "out"}, options);
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const std::string text = readWhole(folder.path() / "out" / "results.json");
    EXPECT_EQ(schemaError(text), "");
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / "report.html"));
    const auto study = nlohmann::json::parse(text).at("study");
    std::map<std::string, nlohmann::json> lookups;
    for (const auto& lookup : study.at("lookups")) {
        lookups[lookup.at("lookup")] = lookup;
        EXPECT_EQ(lookup.at("lights"), study.at("lookups")[0].at("lights"));
        EXPECT_EQ(lookup.at("dark_interior_samples"), study.at("lookups")[0].at("dark_interior_samples"));
        EXPECT_TRUE(lookup.at("timing").is_null());
    }
    EXPECT_EQ(lookups.at("pcf(1)").at("ratio_to_nearest"), 1.0);
    const std::map<std::string, int> outcomes{{"pcf(9)", 10},           {"depths(2,max)", 3},
                                              {"depths(3)+pcf(4)", 13}, {"fast-pcf+pcf(4)", 17},
                                              {"depths(8)+pcf(9)", 73}, {"bilinear", 2}};
    for (const auto& [name, most] : outcomes) EXPECT_LE(lookups.at(name).at("shades").get<int>(), most) << name;
    EXPECT_EQ(lookups.at("pcf(9)").at("shades"), 10);
    EXPECT_TRUE(lookups.at("bilinear").at("filtered_rmse").is_null());
    EXPECT_TRUE(lookups.at("bilinear").at("filtered_largest").is_null());
    for (const auto& [name, lookup] : lookups) {
        EXPECT_GE(lookup.at("area_largest"), lookup.at("area_rmse")) << name;
        if (!lookup.at("filtered_rmse").is_null()) {
            EXPECT_GE(lookup.at("filtered_largest"), lookup.at("filtered_rmse")) << name;
        }
    }
    EXPECT_LT(lookups.at("pcf(25)").at("filtered_rmse").get<double>(),
              lookups.at("pcf(1)").at("filtered_rmse").get<double>());
    EXPECT_GT(lookups.at("pcf(4)").at("transition_pixels"), lookups.at("pcf(1)").at("transition_pixels"));
    EXPECT_GT(lookups.at("pcf(25)").at("transition_pixels"), lookups.at("pcf(4)").at("transition_pixels"));
    EXPECT_GT(lookups.at("vsm").at("bleeding_percent").get<double>(),
              lookups.at("pcf(9)").at("bleeding_percent").get<double>());
    for (const auto& front : study.at("fronts")) {
        const std::string error = front.at("error");
        for (const std::string best : front.at("lookups"))
            for (const auto& [name, other] : lookups) {
                if (other.at(error).is_null()) continue;
                EXPECT_FALSE(other.at(error) < lookups.at(best).at(error) &&
                             other.at("bytes_per_lixel") <= lookups.at(best).at("bytes_per_lixel"))
                    << name << " beats " << best;
            }
    }
}

TEST(StudyCommand, WithoutANameListsTheStudies)
{
    const CommandResult result = runLixel({"study"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_NE(result.out.find("one-to-one"), std::string::npos);
    EXPECT_NE(result.out.find("plane-budget"), std::string::npos);
}

} // namespace
} // namespace lixel::test
