// SPDX-License-Identifier: MIT
// `lixel reproduce scene-optimised-table2` and `-table3`: frame loops, timed. What times are is not tested.
#include "report/sample_results.h"
#include "report/schema_check.h"
#include "run_command.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace lixel::test {
namespace {

using Json = nlohmann::json;

const Json* numberOf(const Json& numbers, const std::string& key)
{
    for (const Json& number : numbers)
        if (number.at("key") == key) return &number;
    return nullptr;
}

class SceneOptimisedLoops : public ::testing::Test
{
protected:
    void SetUp() override
    {
        options_.folder = folder_.path();
        if (const std::string missing = missingGraphics(folder_.path()); !missing.empty()) GTEST_SKIP() << missing;
    }

    // The results of a quick run, which follow the schema and in which all is measured and every number has a name of its own.
    Json quick(const std::string& name)
    {
        const CommandResult run = runLixel({"reproduce", name, "--quick", "-o", "out"}, options_);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        const std::string text = readWhole(folder_.path() / "out" / "results.json");
        EXPECT_EQ(schemaError(text), "");
        Json results = Json::parse(text);
        std::set<std::string> keys;
        const Json& made = results.at("reproduction");
        for (const Json* numbers : {&made.at("numbers"), &made.at("timing").at("numbers")})
            for (const Json& number : *numbers) {
                EXPECT_TRUE(keys.insert(number.at("key")).second) << number;
                EXPECT_GE(number.at("ours").get<double>(), 0) << number;
            }
        for (const Json& row : results.at("results")) {
            EXPECT_FALSE(row.contains("refused")) << row.dump();
            EXPECT_GT(row.at("timing").at("frame_ms").get<double>(), 0);
        }
        return results;
    }

    TemporaryFolder folder_;
    CommandOptions options_;
};

TEST_F(SceneOptimisedLoops, Table2HasThePapersRatiosAndMeansBelowTheWorstFrames)
{
    const Json results = quick("scene-optimised-table2");
    const Json& made = results.at("reproduction");
    const Json& times = made.at("timing").at("numbers");
    const Json* const one = numberOf(times, "1 light, 100x100: optimal over focused, mean");
    const Json* const four = numberOf(times, "4 lights, 100x100: optimal over focused, mean");
    ASSERT_TRUE(one && four) << times.dump(1);
    EXPECT_NEAR(one->at("papers").get<double>(), 1.19, 0.005);
    EXPECT_NEAR(four->at("papers").get<double>(), 1.11, 0.005);
    for (const char* what : {"optimal", "ours", "lispsm"}) {
        const std::string key = std::string("4 lights, 100x100: ") + what + " over focused, ";
        const Json *const mean = numberOf(times, key + "mean"), *const worst = numberOf(times, key + "worst frame");
        ASSERT_TRUE(mean && worst) << key;
        EXPECT_LE(mean->at("ours").get<double>(), worst->at("ours").get<double>());
    }
    EXPECT_TRUE(numberOf(times, "readback, 32 lights over 1"));
    EXPECT_TRUE(numberOf(made.at("numbers"), "4 lights: optimal 250x250 over focused 350x350, misclassified"));
}

TEST_F(SceneOptimisedLoops, Table3HasStagesThatAddUpToTheFrame)
{
    const Json results = quick("scene-optimised-table3");
    const Json& times = results.at("reproduction").at("timing").at("numbers");
    for (const std::string of : {"optimal", "normal", "ours"}) {
        const auto ours = [&](const char* stage) {
            const Json* const number = numberOf(times, of + ": " + stage);
            return number ? number->at("ours").get<double>() : std::nan("");
        };
        EXPECT_NEAR(ours("optimisation") + ours("render and wait"), ours("total scene"), 1e-9);
        EXPECT_NEAR(ours("optimisation, share") + ours("render and wait, share"), 100, 1e-9);
        EXPECT_GT(ours("pass \"light depth\", of frames apart"), 0);
        EXPECT_EQ(numberOf(times, of + ": pass \"sample\", of frames apart") == nullptr, of == "normal");
    }
}

TEST_F(SceneOptimisedLoops, RefuseAnotherExecutor)
{
    for (const char* name : {"scene-optimised-table2", "scene-optimised-table3"}) {
        const CommandResult run = runLixel({"reproduce", name, "--quick", "--executor", "trace"}, options_);
        EXPECT_EQ(run.exitCode, 2);
        EXPECT_NE(run.err.find("gl executor"), std::string::npos) << run.err;
    }
}

} // namespace
} // namespace lixel::test
