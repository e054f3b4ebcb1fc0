// SPDX-License-Identifier: MIT
// `render --plan` writes plans, `matrix(file)` and `plan(file)` read them.
#include "report/sample_results.h"
#include "run_command.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <fstream>

namespace lixel::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

class PlanFile : public ::testing::Test
{
protected:
    CommandResult run(const Words& words, int exitCode = 0)
    {
        CommandOptions options;
        options.folder = folder_.path();
        const CommandResult result = runLixel(words, options);
        EXPECT_EQ(result.exitCode, exitCode) << asTyped(words) << "\n" << result.err;
        return result;
    }
    void write(const std::string& name, const std::string& text) { std::ofstream(folder_.path() / name) << text; }
    // Rows by technique as typed.
    std::map<std::string, Json> compare(const std::string& techniques, int exitCode = 0)
    {
        const CommandResult result =
            run({"compare", "table", "--view", "overview", "--size", "128x96", "--lixels", "160x120", "--executor",
                 "trace", "--timing-frames", "0", "--techniques", techniques, "--json", "-"},
                exitCode);
        std::map<std::string, Json> rows;
        if (exitCode != 0) return rows;
        const Json json = Json::parse(result.out);
        for (const Json& row : json.at("results")) rows[row.at("technique")] = row;
        return rows;
    }
    void renderPlan(const std::string& technique, const std::string& file)
    {
        run({"render", "table", "--view", "overview", "--size", "128x96", "--lixels", "160x120", "--executor", "trace",
             "--technique", technique, "--plan", file});
    }
    TemporaryFolder folder_;
};

TEST_F(PlanFile, WhatWasPlannedScoresTheSameWhenItIsReadBack)
{
    for (const char* technique : {"focused", "lispsm", "pssm(3)"}) {
        renderPlan(technique, "plan.json");
        const auto rows = compare(std::string(technique) + ",plan(plan.json)");
        const Json &own = rows.at(technique), &read = rows.at("plan(plan.json)");
        EXPECT_EQ(own.at("misclassified"), read.at("misclassified")) << technique;
        EXPECT_EQ(own.at("light_facing"), read.at("light_facing"));
        EXPECT_EQ(read.at("unserved"), 0);
    }
}

TEST_F(PlanFile, AMatrixInAnotherConventionIsTheSameMap)
{
    renderPlan("focused", "plan.json");
    const Json plan = Json::parse(std::ifstream(folder_.path() / "plan.json"));
    Json rows = plan.at("lights").at(0).at("regions").at(0).at("lightClipFromWorld");
    for (int i = 0; i < 4; ++i) { // y down, 1 near and 0 far
        rows[1][i] = -rows[1][i].get<double>();
        rows[2][i] = 0.5 * (rows[3][i].get<double>() - rows[2][i].get<double>());
    }
    write(
        "matrix.json",
        Json{{"convention", {{"depth", "1..0"}, {"y", "down"}}}, {"lights", {{{"lightClipFromWorld", rows}}}}}.dump());
    const auto scored = compare("focused,matrix(matrix.json)");
    EXPECT_EQ(scored.at("focused").at("misclassified"), scored.at("matrix(matrix.json)").at("misclassified"));
}

TEST_F(PlanFile, ALampAmidTheSceneIsRenderedWithACubeByDefault)
{
    run({"render", "lamp", "--size", "64x64", "--lixels", "96x96", "--executor", "trace", "--plan", "plan.json"});
    const Json plan = Json::parse(std::ifstream(folder_.path() / "plan.json"));
    EXPECT_GT(plan.at("lights").at(0).at("regions").size(), 1u);
}

TEST_F(PlanFile, ALightThatIsNotInItIsRefusedByName)
{
    write("m.json",
          R"({"lights": [{"name": "nobody", "lightClipFromWorld": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]}]})");
    const auto rows = compare("focused,matrix(m.json)");
    EXPECT_EQ(rows.at("matrix(m.json)").at("refused").at("reason"), "not-given");
}

TEST_F(PlanFile, BadOnesGetOneClearLine)
{
    const std::string identity = "[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]";
    const std::vector<std::pair<std::string, std::string>> files{
        {"{", "line 1"},
        {"[]", "object"},
        {"{}", "lights"},
        {R"({"lights": []})", "at least 1"},
        {R"({"lights": [{}]})", "either"},
        {R"({"lights": [{"lightClipFromWorld": [[1,0,0,0]]}]})", "/lights/0/lightClipFromWorld"},
        {R"({"lights": [{"lightClipFromWorld": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,0]]}]})", "inverse"},
        {R"({"lights": [{"lightClipFromWorld": )" + identity + R"(}], "convention": {"depth": "2..3"}})", "-1..1"},
        {R"({"lights": [{"lightClipFromWorld": )" + identity + R"(, "colour": 1}]})", "colour"},
        {R"({"lights": [{"regions": [{"lightClipFromWorld": )" + identity + R"(}, {"lightClipFromWorld": )" + identity +
             "}]}]}",
         "one matrix"},
    };
    for (const auto& [text, expected] : files) {
        write("bad.json", text);
        const CommandResult result = run({"compare", "table", "--techniques", "matrix(bad.json)", "--json", "-"}, 3);
        EXPECT_NE(result.err.find(expected), std::string::npos) << text << "\n" << result.err;
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    }
    run({"compare", "table", "--techniques", "plan(nowhere.json)", "--json", "-"}, 3);
}

} // namespace
} // namespace lixel::test
