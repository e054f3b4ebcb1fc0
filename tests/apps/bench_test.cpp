// SPDX-License-Identifier: MIT
#include "report/sample_results.h"
#include "report/schema_check.h"
#include "run_command.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>

namespace lixel::test {
namespace {

// Lixels cost a map time in proportion, in part; lights do. Times are of a busy machine: exponents are only roughly known here.
TEST(BenchCommand, FindsHowCostGrowsAndNamesWhatMakesNothing)
{
    const TemporaryFolder folder;
    const std::string out = (folder.path() / "out").string();
    const CommandResult result = runLixel({"bench", "--quick", "--axes", "lixels,lights", "--techniques",
                                           "focused,exact", "--executor", "trace", "--timing-frames", "1", "-o", out});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_GT(std::filesystem::file_size(out + "/report.html"), 10'000u);
    const std::string text = readWhole(out + "/results.json");
    EXPECT_EQ(schemaError(text, "bench.schema.json"), "");

    const auto json = nlohmann::json::parse(text);
    std::map<std::string, int> measured;
    for (const auto& row : json["rows"]) {
        if (row["technique"] == "exact") {
            EXPECT_TRUE(row.contains("skipped")) << row;
            continue;
        }
        ++measured[row["axis"].get<std::string>()];
        EXPECT_GT(row["timing"]["frame_ms"].get<double>(), 0) << row;
        EXPECT_GT(row["timing"]["peak_resident_bytes"].get<double>(), 1e6) << row;
    }
    EXPECT_EQ(measured["lixels"], 4);
    EXPECT_EQ(measured["lights"], 3);
    std::map<std::string, double> exponents;
    for (const auto& fitted : json["timing"]["growth"])
        if (fitted["quantity"] == "frame_ms")
            exponents[fitted["axis"].get<std::string>()] = fitted["exponent"].get<double>();
    ASSERT_EQ(exponents.size(), 2u);
    EXPECT_GT(exponents["lights"], 0.3);
    EXPECT_LT(exponents["lights"], 2);
    EXPECT_LT(exponents["lixels"], 2);
}

} // namespace
} // namespace lixel::test
