// SPDX-License-Identifier: MIT
// `lixel compare --path`: frames along a path, and how steady shadows are between them.
#include "report/sample_results.h"
#include "report/schema_check.h"
#include "run_command.h"
#include "support/scene_files.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace lixel::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

// Small, without times, by the CPU executor where nothing else is said.
class ComparePath : public ::testing::Test
{
protected:
    CommandResult run(const std::string& scene, const Words& words, int exitCode = 0)
    {
        Words all{"compare",         scene, "--size", "64x64",   "--lixels", "64x64",
                  "--timing-frames", "0",   "--json", "run.json"};
        all.insert(all.end(), words.begin(), words.end());
        if (std::ranges::find(words, "--executor") == words.end()) all.insert(all.end(), {"--executor", "trace"});
        CommandOptions options;
        options.folder = folder_.path();
        const CommandResult result = runLixel(all, options);
        EXPECT_EQ(result.exitCode, exitCode) << asTyped(all) << "\n" << result.err;
        return result;
    }
    Json rowsOf(const std::string& scene, const Words& words)
    {
        fs::remove(folder_.path() / "run.json");
        run(scene, words);
        const std::string text = readWhole(folder_.path() / "run.json");
        EXPECT_EQ(schemaError(text), "");
        return Json::parse(text).at("results");
    }
    void write(const std::string& name, std::string_view text) { std::ofstream(folder_.path() / name) << text; }

    TemporaryFolder folder_;
};

const Json& rowOf(const Json& rows, const std::string& technique)
{
    for (const Json& row : rows)
        if (row.at("technique") == technique) return row;
    throw std::logic_error("no row of " + technique);
}

std::int64_t flipsOf(const Json& rows, const std::string& technique)
{
    return rowOf(rows, technique).at("temporal").at("flips");
}

const Words kSun{"--light-direction=0.3,-1,-0.2"};

Words with(Words words, const Words& more)
{
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

// The map of `uniform` depends on scene and light alone: where these are still, so is every shadow, to the last bit.
TEST_F(ComparePath, UniformFlipsNowhereWhileSceneAndLightAreStill)
{
    const Json rows = rowsOf("bunnies", {"--path", "--frames", "6", "--still"});
    EXPECT_EQ(flipsOf(rows, "uniform"), 0);
    EXPECT_GT(flipsOf(rows, "focused"), 0) << "its map follows the camera";
    EXPECT_EQ(flipsOf(rows, "exact"), 0);
    EXPECT_GT(rowOf(rows, "uniform").at("misclassified").get<std::int64_t>(), 0) << "still wrong, but steadily";
    EXPECT_EQ(rowOf(rows, "uniform").at("temporal").at("still"), true);
}

TEST_F(ComparePath, BothExecutorsAreAskedAboutTheSameSamples)
{
    if (const std::string missing = missingGraphics(folder_.path()); !missing.empty()) GTEST_SKIP() << missing;
    const Json rows = rowsOf("bunnies", {"--path", "--frames", "4", "--still", "--executor", "both"});
    ASSERT_EQ(rows.size(), 6u);
    for (const Json& row : rows) {
        EXPECT_EQ(row.at("temporal").at("samples"), rows[0].at("temporal").at("samples"));
        EXPECT_EQ(row.at("agreement_with"), row.at("executor") == "gl" ? "trace" : "gl");
        EXPECT_GE(row.at("agreement_percent").get<double>(), 99.5) << row.at("technique");
        const bool follows = row.at("technique") == "focused";
        EXPECT_EQ(row.at("temporal").at("flips").get<int>() > 0, follows) << row.at("technique");
    }
}

TEST_F(ComparePath, UniformFlipsWhereCastersMove)
{
    const Json rows = rowsOf("bunnies", with({"--path", "--frames", "6"}, kSun));
    EXPECT_GT(flipsOf(rows, "uniform"), 0);
    EXPECT_EQ(flipsOf(rows, "exact"), 0);
    EXPECT_EQ(rowOf(rows, "uniform").at("temporal").at("still"), false);
}

// What moves with its triangle is followed: of a skin that bends, samples are compared and not lost.
TEST_F(ComparePath, SamplesFollowWhatMoves)
{
    write("still.json", R"({"camera": {"eye": [1, 1, 4], "target": [0, 1, 0]}, "light": {"direction": [-0.3, -1, -0.4]},
                            "path": [{"time": 0, "eye": [1, 1, 4], "target": [0, 1, 0]},
                                     {"time": 1, "eye": [1, 1.001, 4], "target": [0, 1, 0]}]})");
    const Json rows =
        rowsOf((dataFolder() / "skin.glb").string(), {"--path", "--view", "./still.json", "--frames", "9"});
    const Json& row = rowOf(rows, "exact");
    const auto lightFacing = row.at("light_facing").get<double>();
    EXPECT_GT(lightFacing, 0);
    EXPECT_GT(row.at("temporal").at("samples").get<double>(), 0.6 * lightFacing * 8 / 9);
}

TEST_F(ComparePath, CountsAddUp)
{
    const Json rows =
        rowsOf("table", {"--path", "--frames", "5", "--techniques", "uniform,focused+pcf:9,exact-area:4"});
    for (const Json& row : rows) {
        const Json& temporal = row.at("temporal");
        const auto count = [&](const char* name) { return temporal.at(name).get<std::int64_t>(); };
        EXPECT_EQ(row.at("view"), "path");
        EXPECT_EQ(count("frames"), 5);
        EXPECT_EQ(count("refused_frames"), 0);
        ASSERT_EQ(temporal.at("pairs").size(), 4u);
        std::int64_t samples = 0, flips = 0;
        for (const Json& pair : temporal.at("pairs"))
            samples += pair.at("samples").get<std::int64_t>(), flips += pair.at("flips").get<std::int64_t>();
        EXPECT_EQ(count("samples"), samples);
        EXPECT_EQ(count("flips"), flips);
        EXPECT_EQ(samples, count("edge_band_samples") + count("terminator_band_samples") + count("interior_samples"));
        EXPECT_EQ(flips, count("edge_band_flips") + count("terminator_band_flips") + count("interior_flips"));
        EXPECT_GT(samples, 0);
        EXPECT_LE(samples, row.at("light_facing").get<std::int64_t>());
        EXPECT_EQ(row.at("light_facing"), rows[0].at("light_facing"));
        EXPECT_EQ(row.at("footprint_pixels_per_lixel").is_null(),
                  !row.at("technique_full").get<std::string>().starts_with("whole"));
    }
}

// Two frames say of themselves what the pictures of their times say.
TEST_F(ComparePath, ItsCountsAreThoseOfItsFrames)
{
    const Json path = rowsOf("table", {"--path", "--fps", "2", "--frames", "2", "--time", "1"});
    const Json one = rowsOf("table", {"--path", "--time", "1"}), two = rowsOf("table", {"--path", "--time", "1.5"});
    for (std::size_t i = 0; i < path.size(); ++i)
        for (const char* name : {"light_facing", "misclassified", "false_lit", "edge_band_samples"})
            EXPECT_EQ(path[i].at(name).get<std::int64_t>(),
                      one[i].at(name).get<std::int64_t>() + two[i].at(name).get<std::int64_t>())
                << name;
    EXPECT_FALSE(one[0].contains("temporal"));
}

TEST_F(ComparePath, FramesLieWhereTheyAreAskedFor)
{
    write("walk.json", R"({"light": {"direction": [0.3, -1, -0.2]},
                           "path": [{"time": 1, "eye": [2, 2, 3], "target": [0, 0.5, 0]},
                                    {"time": 3, "eye": [3, 2, 3], "target": [0, 0.5, 0]}]})");
    const auto times = [&](const Words& words) {
        const Json temporal =
            rowOf(rowsOf("table", with({"--path", "--view", "./walk.json", "--techniques", "exact"}, words)), "exact")
                .at("temporal");
        std::vector<double> out{temporal.at("from_seconds")};
        for (const Json& pair : temporal.at("pairs")) out.push_back(pair.at("seconds"));
        EXPECT_EQ(out.back(), temporal.at("to_seconds"));
        return out;
    };
    EXPECT_EQ(times({"--frames", "5"}), (std::vector<double>{1, 1.5, 2, 2.5, 3}));
    EXPECT_EQ(times({"--fps", "2"}), (std::vector<double>{1, 1.5, 2, 2.5, 3}));
    EXPECT_EQ(times({"--fps", "2", "--time", "2"}), (std::vector<double>{2, 2.5, 3}));
    EXPECT_EQ(times({"--fps", "4", "--frames", "3"}), (std::vector<double>{1, 1.25, 1.5}));
    EXPECT_EQ(times({"--frames", "2", "--time", "2"}), (std::vector<double>{2, 3}));
    EXPECT_EQ(times({}).size(), 30u);
}

TEST_F(ComparePath, WhatCannotBeAPathIsRefused)
{
    const auto refusal = [&](const Words& words) { return run("table", words, 2).err; };
    const auto mention = [](const std::string& text, const char* what) {
        EXPECT_NE(text.find(what), text.npos) << text;
    };
    mention(refusal({"--frames", "5"}), "--path");
    mention(refusal({"--still"}), "--path");
    mention(refusal({"--path", "--frames", "1"}), "--frames");
    mention(refusal({"--path", "--fps", "0"}), "--fps");
    mention(refusal({"--path", "--fps", "1e-9"}), "--fps");
    mention(refusal({"--path", "--fps", "1e9"}), "--fps");
    mention(refusal({"--path", "--fps", "1", "--frames", "5000"}), "has time for");
    mention(refusal({"--path", "--frames", "5", "--time", "1e6"}), "nothing is left");
    mention(run("bunnies", {"--path", "--frames", "3", "--view", "all"}, 2).err, "one view");
}

// A light that cannot be served along the whole path has the refusal of a picture.
TEST_F(ComparePath, RefusedFramesAreToldAndCountNowhere)
{
    write("past.json",
          R"({"path": [{"time": 0, "eye": [2, 1.5, 2], "target": [0, 0.5, 0], "light": {"position": [0, 9, 0]}},
                                    {"time": 4, "eye": [2.2, 1.5, 2], "target": [0, 0.5, 0], "light": {"position": [0, 0.5, 0]}}]})");
    const Json rows = rowsOf("table", {"--path", "--view", "./past.json", "--frames", "5", "--techniques", "uniform"});
    const Json& temporal = rowOf(rows, "uniform").at("temporal");
    const auto refused = temporal.at("refused_frames").get<int>();
    EXPECT_GE(refused, 1);
    EXPECT_LT(refused, 5);
    EXPECT_EQ(temporal.at("pairs").back().at("samples"), 0);
    EXPECT_LT(rowOf(rows, "uniform").at("light_facing").get<std::int64_t>(),
              rowOf(rows, "exact").at("light_facing").get<std::int64_t>());

    run("table", {"--path", "--frames", "3", "--light-position", "0,0.5,0", "--techniques", "uniform"}, 5);
    const Json inside = Json::parse(readWhole(folder_.path() / "run.json")).at("results");
    EXPECT_EQ(rowOf(inside, "uniform").at("refused").at("reason"), "extent-not-in-hemisphere");
}

TEST_F(ComparePath, TheReportShowsThePictureInTheMiddle)
{
    const CommandResult result = run("bunnies", {"--path", "--frames", "3", "--techniques", "focused", "-o", "out"});
    EXPECT_NE(result.out.find("flips"), std::string::npos);
    const Json rows = Json::parse(readWhole(folder_.path() / "out" / "results.json")).at("results");
    for (const Json& row : rows)
        for (const auto& [what, file] : row.at("pictures").items())
            EXPECT_TRUE(fs::exists(folder_.path() / "out" / file.get<std::string>())) << what;
    for (const char* what : {"shaded", "error", "footprint", "density"})
        EXPECT_TRUE(rowOf(rows, "focused").at("pictures").contains(what)) << what;
    EXPECT_GT(fs::file_size(folder_.path() / "out" / "report.html"), 10'000u);
}

} // namespace
} // namespace lixel::test
