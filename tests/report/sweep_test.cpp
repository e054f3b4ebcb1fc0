// SPDX-License-Identifier: MIT
#include "lixel/report/sweep.h"

#include "sample_results.h"
#include "schema_check.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

namespace lixel::test {
namespace {

using Json = nlohmann::json;

std::vector<std::string> linesOf(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

// RFC 4180: quotes around what holds commas, quotes in it twice.
std::vector<std::string> cellsOf(const std::string& line)
{
    std::vector<std::string> cells{""};
    bool isQuoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"' && isQuoted && i + 1 < line.size() && line[i + 1] == '"') cells.back() += line[i++];
        else if (line[i] == '"') isQuoted = !isQuoted;
        else if (line[i] == ',' && !isQuoted) cells.emplace_back();
        else cells.back() += line[i];
    }
    return cells;
}

TEST(SweepRows, EndInTheirTimingWhichCanBeCutOff)
{
    const SweepResults sweep = sampleSweep({}, 0);
    const std::string with = toJsonLines(sweep.lines, true), without = toJsonLines(sweep.lines, false);
    const auto lines = linesOf(with), cut = linesOf(without);
    ASSERT_EQ(lines.size(), sweep.lines.size());
    ASSERT_EQ(cut.size(), sweep.lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        EXPECT_EQ(schemaError(lines[i], "study-row.schema.json"), "") << lines[i];
        Json row = Json::parse(lines[i]);
        ASSERT_TRUE(row.contains("timing"));
        row.erase("timing");
        EXPECT_EQ(Json::parse(cut[i]), row);
        const auto name = nameOfSweepRow(lines[i]);
        ASSERT_TRUE(name);
        EXPECT_EQ(name->number, i);
        EXPECT_EQ(name->isRefused, row.contains("refused"));
    }
}

TEST(SweepRows, AreTheSameAsATable)
{
    const SweepResults sweep = sampleSweep({}, 0);
    const auto table = linesOf(toCsv(sweep.lines, true)), cut = linesOf(toCsv(sweep.lines, false));
    ASSERT_EQ(table.size(), 1 + sweep.lines.size());
    const std::vector<std::string> heads = cellsOf(table.front());
    const auto column = [&](const char* name) { return std::size_t(std::ranges::find(heads, name) - heads.begin()); };
    for (std::size_t i = 0; i < sweep.lines.size(); ++i) {
        const Json row = Json::parse(sweep.lines[i]);
        const std::vector<std::string> cells = cellsOf(table[i + 1]);
        ASSERT_EQ(cells.size(), heads.size());
        EXPECT_EQ(cells[column("view")], row.at("view").get<std::string>());
        EXPECT_EQ(cells[column("row")], row.at("row").dump());
        EXPECT_EQ(cells[column("misclassified")], row.contains("refused") ? "" : row.at("misclassified").dump());
        EXPECT_EQ(cells[column("timing_host")], "nowhere");
        EXPECT_EQ(table[i + 1].substr(0, cut[i + 1].size()), cut[i + 1]) << "times are the last columns";
    }
    EXPECT_EQ(cut.front().find("timing"), std::string::npos);
}

TEST(SweepRows, AnythingElseIsNoRow)
{
    for (const char* text : {"", "{", "[]", "{}", R"({"row": -1, "key": "a"})", R"({"row": 1, "key": 2})", "null"})
        EXPECT_FALSE(nameOfSweepRow(text)) << text;
}

} // namespace
} // namespace lixel::test
