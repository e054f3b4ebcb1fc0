// SPDX-License-Identifier: MIT
// `lixel compare`: numbers, pictures and the report.
#include "report/in_browser.h"
#include "report/sample_results.h"
#include "report/schema_check.h"
#include "run_command.h"
#include "support/scene_files.h"

#include "lixel/plan/technique.h"
#include "lixel/report/png.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <system_error>
#include <tuple>

namespace lixel::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

class Compare : public ::testing::Test
{
protected:
    CommandResult compare(const Words& words, int exitCode = 0)
    {
        Words all{"compare"};
        all.insert(all.end(), words.begin(), words.end());
        CommandOptions options;
        options.folder = folder_.path();
        const CommandResult run = runLixel(all, options);
        EXPECT_EQ(run.exitCode, exitCode) << asTyped(all) << "\n" << run.err;
        return run;
    }
    // The table at 64x64 by the CPU executor into the folder `out`.
    CommandResult compareTable(Words words, int exitCode = 0)
    {
        const Words fixed{"table", "--size",          "64x64", "--lixels", "128x128", "--executor",
                          "trace", "--timing-frames", "1",     "-o",       "out"};
        words.insert(words.begin(), fixed.begin(), fixed.end());
        return compare(words, exitCode);
    }
    fs::path out() const { return folder_.path() / "out"; }
    std::string resultsText() const { return readWhole(out() / "results.json"); }
    Json results() const { return Json::parse(resultsText()).at("results"); }

    TemporaryFolder folder_;
};

Json withoutTiming(Json json)
{
    if (json.is_object()) json.erase("timing");
    for (auto& part : json)
        if (part.is_structured()) part = withoutTiming(part);
    return json;
}

auto keyOf(const Json& row)
{
    const auto text = [&](const char* name) { return row.at(name).get<std::string>(); };
    return std::tuple(text("scene"), text("view"), text("light"), text("technique_full"), text("lixels"), text("size"),
                      text("executor"));
}

TEST_F(Compare, WritesResultsPicturesAndReport)
{
    const CommandResult run = compareTable({"--view", "overview", "--techniques", "uniform,focused+pcf:9"});
    EXPECT_EQ(run.err, "");
    EXPECT_NE(run.out.find("report: out/report.html"), std::string::npos) << run.out;
    EXPECT_EQ(schemaError(resultsText()), "");
    EXPECT_GT(fs::file_size(out() / "report.html"), 10'000u);

    const Json rows = results();
    ASSERT_EQ(rows.size(), 3u) << "exact stands beside every comparison";
    for (const Json& row : rows) {
        const Json& pictures = row.at("pictures");
        EXPECT_EQ(pictures.size(), row.at("technique") == "exact" ? 2u : 4u);
        for (const auto& [what, file] : pictures.items())
            EXPECT_EQ(readPng(out() / file.get<std::string>()).width(), 64) << what;
    }
}

TEST_F(Compare, ItsReportIsUsableInABrowser)
{
    if (const std::string missing = missingGraphics(folder_.path()); !missing.empty()) GTEST_SKIP() << missing;
    compare({"bunnies", "--view", "overview", "--size", "128x128", "--lixels", "128x128", "--techniques",
             "uniform,focused", "-o", "out"});
    const InBrowser used = useInBrowser(out() / "report.html", "compare");
    if (used == InBrowser::NoBrowser) GTEST_SKIP() << "needs chromium and chromedriver";
    EXPECT_EQ(used, InBrowser::Usable);
}

TEST_F(Compare, RowsAreSortedAndTheirTechniquesReadBack)
{
    compareTable({"--view", "two-lights", "--techniques", "pcf:4+uniform,focused,exact-area:4,exact"});
    const Json rows = results();
    ASSERT_EQ(rows.size(), 8u);
    EXPECT_TRUE(
        std::is_sorted(rows.begin(), rows.end(), [](const Json& a, const Json& b) { return keyOf(a) < keyOf(b); }));
    for (const Json& row : rows) {
        const std::string full = row.at("technique_full");
        const auto typed = parseTechnique(row.at("technique").get<std::string>()), read = parseTechnique(full);
        ASSERT_TRUE(typed && read) << full;
        EXPECT_EQ(*typed, *read);
        EXPECT_EQ(toString(*read), full);
    }
}

TEST_F(Compare, CountsAddUp)
{
    compareTable({"--view", "two-lights"});
    for (const Json& row : results()) {
        const auto count = [&](const char* name) { return row.at(name).get<std::int64_t>(); };
        EXPECT_EQ(count("misclassified"), count("false_shadow") + count("false_lit"));
        EXPECT_EQ(count("light_facing"),
                  count("edge_band_samples") + count("terminator_band_samples") + count("interior_samples"));
        EXPECT_EQ(count("unserved"), 0);
        EXPECT_GT(count("light_facing"), 0);
        const bool isExact = row.at("technique") == "exact";
        EXPECT_TRUE(!isExact || count("misclassified") == 0);
        EXPECT_EQ(count("lixels_used"), isExact ? 0 : 128 * 128);
        EXPECT_EQ(row.at("timing").at("frame_ms").is_null(), isExact);
    }
}

TEST_F(Compare, WhatAFilterStandsForIsATechniqueWithoutAMap)
{
    compareTable(
        {"--view", "overview", "--shades", "--techniques", "exact-filtered(pcf(9)),exact-filtered(msm,rays=4),pcf(9)"});
    EXPECT_EQ(schemaError(resultsText()), "");
    const Json rows = results();
    ASSERT_EQ(rows.size(), 4u);
    for (const Json& row : rows) {
        if (!row.at("technique").get<std::string>().starts_with("exact-filtered")) continue;
        EXPECT_EQ(row.at("lixels_used"), 0);
        EXPECT_EQ(row.at("bytes"), 0);
        EXPECT_TRUE(row.at("timing").at("frame_ms").is_null());
        const double rmse = row.at("shades").at("filtered_rmse");
        const bool isAsFine = row.at("technique") == "exact-filtered(pcf(9))";
        EXPECT_TRUE(isAsFine ? rmse == 0 : rmse > 0) << rmse; // as many rays as the measure takes
    }
}

TEST_F(Compare, WhatAFilterStandsForIsRefusedWhereItsMapsAre)
{
    compare({"lamp", "--view", "ceiling", "--size", "32x32", "--lixels", "32x32", "--executor", "trace",
             "--timing-frames", "0", "--techniques", "exact-filtered(focused)", "--json", "out.json"},
            5);
    const Json rows = Json::parse(readWhole(folder_.path() / "out.json")).at("results");
    EXPECT_TRUE(std::ranges::any_of(rows, [](const Json& row) { return row.contains("refused"); }));
}

TEST_F(Compare, TheSameCommandGivesTheSameBytes)
{
    const Words words{"--view", "overview", "--techniques", "focused+pcf:9,exact-area:4"};
    compareTable(words);
    const Json first = withoutTiming(Json::parse(resultsText()));
    const std::string picture =
        readWhole(out() / first.at("results")[0].at("pictures").at("shaded").get<std::string>());
    compareTable(words);
    const Json second = withoutTiming(Json::parse(resultsText()));
    EXPECT_EQ(first.dump(), second.dump());
    EXPECT_EQ(picture, readWhole(out() / second.at("results")[0].at("pictures").at("shaded").get<std::string>()));
}

TEST_F(Compare, JsonOnStandardOutputIsAloneThere)
{
    const Words words{"table", "--view",     "overview", "--size",          "32x32", "--lixels",
                      "64x64", "--executor", "trace",    "--timing-frames", "0"};
    Words printed = words, written = words;
    printed.insert(printed.end(), {"--json", "-"});
    written.insert(written.end(), {"--json", "file.json"});
    const CommandResult run = compare(printed);
    EXPECT_EQ(schemaError(run.out), "");
    EXPECT_NE(run.err.find("misclassified"), std::string::npos) << "the table goes beside it";
    compare(written);
    Json file = withoutTiming(Json::parse(readWhole(folder_.path() / "file.json"))),
         out = withoutTiming(Json::parse(run.out));
    file.erase("command"), out.erase("command");
    EXPECT_EQ(file, out);
    EXPECT_EQ(folder_.fileCount(), 1u);
}

TEST_F(Compare, AllViewsOfABuiltInSceneAreTaken)
{
    compare({"table", "--size", "16x16", "--lixels", "32x32", "--executor", "trace", "--timing-frames", "0",
             "--techniques", "focused", "--json", "all.json"});
    std::vector<std::string> views;
    const Json run = Json::parse(readWhole(folder_.path() / "all.json"));
    for (const Json& row : run.at("results")) views.push_back(row.at("view"));
    views.erase(std::unique(views.begin(), views.end()), views.end());
    EXPECT_GE(views.size(), 8u);
}

TEST_F(Compare, BothExecutorsSayHowFarTheyAgree)
{
    if (const std::string missing = missingGraphics(folder_.path()); !missing.empty()) GTEST_SKIP() << missing;
    compare(
        {"table", "--view", "overview", "--size", "128x128", "--lixels", "256x256", "--executor", "both", "-o", "out"});
    EXPECT_EQ(schemaError(resultsText()), "");
    const Json rows = results();
    ASSERT_EQ(rows.size(), 6u);
    for (const Json& row : rows) {
        EXPECT_EQ(row.at("agreement_with"), row.at("executor") == "gl" ? "trace" : "gl");
        EXPECT_GE(row.at("agreement_percent").get<double>(), 99.5) << row.at("technique");
        if (row.at("technique") == "exact") {
            EXPECT_TRUE(row.at("lixels_agreeing_percent").is_null());
        } else {
            EXPECT_GE(row.at("lixels_agreeing_percent").get<double>(), 95);
        }
        EXPECT_EQ(row.at("light_facing"), rows[0].at("light_facing")) << "both are asked about the same samples";
    }
}

TEST_F(Compare, ShadowVolumesAreCountedByGlAndRefusedElsewhereByName)
{
    if (const std::string missing = missingGraphics(folder_.path()); !missing.empty()) GTEST_SKIP() << missing;
    compare({"table", "--view", "two-lights", "--size", "128x128", "--lixels", "64x64", "--executor", "both",
             "--techniques", "shadow-volumes", "--timing-frames", "1", "-o", "out"});
    EXPECT_EQ(schemaError(resultsText()), "");
    int measured = 0, refused = 0;
    for (const Json& row : results()) {
        if (row.at("technique") != "shadow-volumes") continue;
        if (row.at("executor") == "trace") {
            EXPECT_EQ(row.at("refused").at("reason"), "needs-gl");
            ++refused;
            continue;
        }
        EXPECT_LE(row.at("misclassified"), row.at("light_facing").get<int>() / 1000);
        EXPECT_GT(row.at("timing").at("frame_ms"), 0);
        ++measured;
    }
    EXPECT_EQ(measured, 2);
    EXPECT_EQ(refused, 2);

    const CommandResult holes =
        compare({"fence", "--view", "tree", "--size", "32x32", "--techniques", "shadow-volumes", "--json", "-"}, 5);
    EXPECT_NE(holes.out.find("masked-casters"), std::string::npos) << holes.out;
    const CommandResult path = compare({"table", "--path", "--techniques", "shadow-volumes", "--json", "-"}, 2);
    EXPECT_NE(path.err.find("--path"), std::string::npos) << path.err;
}

TEST_F(Compare, RefusedLightsHaveRowsWithTheReason)
{
    const std::string room = (dataFolder() / "room.obj").string();
    compare({room, "--light-position", "2,0.5,2", "--executor", "trace", "--size", "64x64", "-o", "out"}, 5);
    EXPECT_EQ(schemaError(resultsText()), "");
    int refused = 0;
    for (const Json& row : results()) {
        if (row.at("technique") == "exact") continue;
        ++refused;
        EXPECT_EQ(row.at("refused").at("reason"), "extent-not-in-hemisphere");
        EXPECT_NE(row.at("refused").at("message").get<std::string>().find("cube"), std::string::npos);
        EXPECT_FALSE(row.contains("misclassified"));
    }
    EXPECT_EQ(refused, 2);
    EXPECT_TRUE(fs::exists(out() / "report.html"));
}

// Every file below the folder, hidden ones too, with its bytes.
std::map<std::string, std::string> filesBelow(const fs::path& folder)
{
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (!entry.is_directory()) files[entry.path().string()] = readWhole(entry.path());
    return files;
}

// Files come and go while it looks.
int picturesBelow(const fs::path& folder)
{
    int count = 0;
    std::error_code gone;
    for (auto at = fs::recursive_directory_iterator(folder, gone); !gone && at != fs::recursive_directory_iterator();
         at.increment(gone))
        count += at->path().extension() == ".png";
    return count;
}

TEST_F(Compare, AnInterruptionLeavesNothing)
{
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
        CommandOptions options;
        options.folder = folder_.path();
        options.signal = signal;
        options.interruptWhen = [&] { return picturesBelow(out()) > 1; };
        const CommandResult run =
            runLixel({"compare", "table", "--size", "512x512", "--executor", "trace", "-o", "out"}, options);
        EXPECT_EQ(run.exitCode, 130) << signal;
        EXPECT_EQ(run.err, "lixel: interrupted\n") << signal;
        EXPECT_FALSE(fs::exists(out())) << signal;
    }
}

TEST_F(Compare, AReaderThatGoesAwayIsOneLineAndLeavesNothing)
{
    CommandOptions options;
    options.folder = folder_.path();
    options.hasNoReader = true;
    const CommandResult run =
        runLixel({"compare", "table", "--view", "overview", "--size", "64x64", "--lixels", "64x64", "--executor",
                  "trace", "--timing-frames", "0", "-o", "out", "--json", "-"},
                 options);
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_EQ(run.err, "lixel: standard output: cannot be written: Broken pipe\n");
    EXPECT_FALSE(fs::exists(out()));
}

TEST_F(Compare, APictureThatCannotTakeItsPlaceLeavesTheResultsOfAnOlderRunAsTheyWere)
{
    compareTable({"--view", "overview"});
    fs::path picture;
    for (const auto& entry : fs::directory_iterator(out() / "pictures")) picture = entry.path();
    fs::remove(picture);
    fs::create_directory(picture);
    const auto before = filesBelow(out());
    CommandOptions options;
    options.folder = folder_.path();
    const CommandResult run = runLixel({"compare", "table", "--view", "overview", "--size", "96x96", "--lixels",
                                        "96x96", "--executor", "trace", "--timing-frames", "0", "-o", "out"},
                                       options);
    EXPECT_EQ(run.exitCode, 1) << run.err;
    EXPECT_NE(run.err.find("Is a directory"), std::string::npos) << run.err;
    EXPECT_EQ(filesBelow(out()), before);
}

TEST_F(Compare, AnInterruptionLeavesTheResultsOfAnOlderRunAsTheyWere)
{
    compareTable({"--view", "overview"});
    const auto before = filesBelow(out());
    const int pictures = picturesBelow(out());
    ASSERT_GT(pictures, 0);
    CommandOptions options;
    options.folder = folder_.path();
    options.interruptWhen = [&] { return picturesBelow(out()) > pictures + 1; };
    const CommandResult run =
        runLixel({"compare", "table", "--size", "512x512", "--executor", "trace", "-o", "out"}, options);
    EXPECT_EQ(run.exitCode, 130);
    EXPECT_EQ(filesBelow(out()), before);

    // One that ends leaves no folder of its own.
    compareTable({"--view", "overview", "--techniques", "focused"});
    for (const auto& entry : fs::directory_iterator(out()))
        EXPECT_FALSE(entry.path().filename().string().starts_with("."));
    EXPECT_EQ(results().size(), 2u);
}

} // namespace
} // namespace lixel::test
