// SPDX-License-Identifier: MIT
#include "report/sample_results.h"
#include "report/schema_check.h"
#include "run_command.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <filesystem>
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

TEST(StudyCommand, WithoutANameListsTheStudies)
{
    const CommandResult result = runLixel({"study"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_NE(result.out.find("one-to-one"), std::string::npos);
    EXPECT_NE(result.out.find("plane-budget"), std::string::npos);
}

} // namespace
} // namespace lixel::test
