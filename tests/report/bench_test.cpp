// SPDX-License-Identifier: MIT
#include "lixel/report/bench.h"

#include "sample_results.h"
#include "schema_check.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <set>

namespace lixel::test {
namespace {

TEST(Bench, FindsTheExponentOfEachTechnique)
{
    std::set<std::string> seen;
    for (const BenchGrowth& growth : growthsOf(sampleBench({}, 0))) {
        seen.insert(growth.axis + growth.technique + growth.quantity);
        const double expected = growth.technique == "focused" ? 0.5 : growth.technique == "psm" ? 1.0 : 1.5;
        if (growth.quantity == "frame_ms" || growth.quantity == "plan_ms") {
            EXPECT_NEAR(growth.growth.exponent, expected, 1e-9) << growth.technique;
        }
        if (growth.quantity == "device_bytes") {
            EXPECT_NEAR(growth.growth.exponent, 1, 1e-9);
        }
        EXPECT_EQ(growth.growth.points, 3u);
    }
    EXPECT_EQ(seen.size(), 2u * 3 * 4);
}

TEST(Bench, IsValidByItsSchemaAndKeepsWhatDependsOnTheMachineApart)
{
    const std::string text = toJson(sampleBench({}, 0));
    EXPECT_EQ(schemaError(text, "bench.schema.json"), "");
    const auto json = nlohmann::json::parse(text);
    for (const auto& row : json["rows"]) EXPECT_NE(row.contains("skipped"), row.contains("timing"));
}

} // namespace
} // namespace lixel::test
