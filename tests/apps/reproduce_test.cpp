// SPDX-License-Identifier: MIT
// `lixel reproduce`: the papers' experiments.
#include "report/sample_results.h"
#include "report/schema_check.h"
#include "run_command.h"

#include "lixel/report/png.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace lixel::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

// Once for all tests, by the CPU executor.
class ReproduceLixelFig7 : public ::testing::Test
{
protected:
    static void SetUpTestSuite()
    {
        folder_ = std::make_unique<TemporaryFolder>();
        CommandOptions options;
        options.folder = folder_->path();
        run_ = runLixel({"reproduce", "lixel-fig7", "--quick", "--executor", "trace", "-o", "out"}, options);
    }
    static void TearDownTestSuite() { folder_.reset(); }
    void SetUp() override { ASSERT_EQ(run_.exitCode, 0) << run_.err; }

    static fs::path out() { return folder_->path() / "out"; }
    static std::string resultsText() { return readWhole(out() / "results.json"); }
    static Json results() { return Json::parse(resultsText()); }

    static inline std::unique_ptr<TemporaryFolder> folder_;
    static inline CommandResult run_;
};

TEST_F(ReproduceLixelFig7, WritesNumbersAndAReport)
{
    EXPECT_EQ(schemaError(resultsText()), "");
    EXPECT_NE(run_.out.find("report: out/report.html"), std::string::npos) << run_.out;
    EXPECT_NE(run_.out.find("performed comparably"), std::string::npos) << run_.out;
    EXPECT_GT(fs::file_size(out() / "report.html"), 100'000u);
    const Json run = results();
    for (const Json& number : run.at("reproduction").at("numbers"))
        EXPECT_NE(run_.out.find(number.at("key").get<std::string>()), std::string::npos);
}

// Six techniques in the same frames of both scenes, none of which is refused or leaves a sample unserved.
TEST_F(ReproduceLixelFig7, EveryTechniqueServesEveryFrame)
{
    const Json run = results();
    std::map<std::string, std::set<std::string>> views; // by technique
    for (const Json& row : run.at("results")) {
        ASSERT_FALSE(row.contains("refused")) << row.dump();
        EXPECT_EQ(row.at("unserved"), 0);
        views[row.at("technique")].insert(row.at("scene").get<std::string>() + row.at("view").get<std::string>());
    }
    ASSERT_EQ(views.size(), 7u) << "and exact in frames that are shown";
    for (const auto& [technique, where] : views) EXPECT_EQ(where.size(), technique == "exact" ? 8u : 16u) << technique;
}

// As the paper has it, no technique has more lixels than another, and maps for planes are three where they are as given.
TEST_F(ReproduceLixelFig7, TechniquesHaveEquallyManyLixels)
{
    const Json run = results();
    for (const Json& row : run.at("results")) {
        if (row.at("technique") == "exact") continue;
        EXPECT_LE(row.at("lixels_used"), 128 * 128) << row.dump();
        EXPECT_GE(row.at("lixels_used"), 0.9 * 128 * 128) << row.dump();
        if (row.at("lixels").get<std::string>().find(',') == std::string::npos || row.at("regions").size() != 3)
            continue;
        EXPECT_EQ(row.at("regions")[0].at("lixels"), Json({87, 87}));
        EXPECT_EQ(row.at("regions")[2].at("lixels"), Json({32, 32}));
    }
}

TEST_F(ReproduceLixelFig7, FiguresHaveTheirPicturesAndEnlargeWithinThem)
{
    const Json run = results(), figures = run.at("reproduction").at("figures");
    ASSERT_EQ(figures.size(), 8u) << "of two scenes: ordinary, elongated, from the side, in front";
    std::set<std::string> files;
    for (const Json& figure : figures) {
        ASSERT_EQ(figure.at("techniques").size(), 4u);
        for (const Json& technique : figure.at("techniques")) {
            const auto row = std::find_if(run.at("results").begin(), run.at("results").end(), [&](const Json& r) {
                return r.at("technique") == technique && r.at("scene") == figure.at("scene") &&
                       r.at("view") == figure.at("view") && r.at("light") == figure.at("light");
            });
            ASSERT_NE(row, run.at("results").end()) << figure.dump();
            const std::string file = row->at("pictures").at("shaded");
            EXPECT_TRUE(files.insert(file).second) << file << " is of several frames";
            const auto picture = readPng(out() / file);
            const Json& square = figure.at("enlarged");
            EXPECT_LE(square.at("left").get<int>() + square.at("side").get<int>(), picture.width());
            EXPECT_LE(square.at("top").get<int>() + square.at("side").get<int>(), picture.height());
        }
    }
}

TEST_F(ReproduceLixelFig7, MeansAndWorstFramesAreThoseOfTheRows)
{
    const Json run = results();
    double sum = 0, most = 0;
    int count = 0;
    for (const Json& row : run.at("results")) {
        if (row.at("technique") != "psm" || row.at("scene") != "objects") continue;
        const double percent = row.at("misclassified_percent");
        sum += percent, most = std::max(most, percent), ++count;
    }
    int checked = 0;
    for (const Json& number : run.at("reproduction").at("numbers")) {
        const bool isMean = number.at("key") == "objects: psm, mean";
        if (!isMean && number.at("key") != "objects: psm, worst") continue;
        EXPECT_NEAR(number.at("ours").get<double>(), isMean ? sum / count : most, 1e-12);
        ++checked;
    }
    EXPECT_EQ(checked, 2);
}

} // namespace
} // namespace lixel::test
