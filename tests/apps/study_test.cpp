// SPDX-License-Identifier: MIT
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

TEST(StudyCommand, WithoutANameListsTheStudies)
{
    const CommandResult result = runLixel({"study"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_NE(result.out.find("one-to-one"), std::string::npos);
}

} // namespace
} // namespace lixel::test
