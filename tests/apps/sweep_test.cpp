// SPDX-License-Identifier: MIT
// `lixel study FILE.json` and `lixel merge`: the same rows however often a run was killed, and however many made them.
#include "report/sample_results.h"
#include "report/schema_check.h"
#include "run_command.h"
#include "support/random_cases.h"
#include "support/scene_files.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

namespace lixel::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

constexpr int kKilled = 128 + SIGKILL, kInterrupted = 130, kBadUsage = 2, kBadInput = 3;

// Two scenes, one of them a file, refusals, a technique without a map and a picture with several lights: 42 rows in 30 cells.
const std::string kStudy = R"({
  "question": "Tiny?",
  "scenes": ["table", {"scene": "files/room.obj", "views": ["default"]}],
  "views": ["overview", "under-table"],
  "lights": ["own", {"name": "pair", "lights": [{"name": "a", "direction": [0.3, -1, 0.2]}, {"name": "b", "position": [0.4, 2.9, 0.1]}]}],
  "techniques": ["focused", "planes(floor)+plane-optimal", "exact"],
  "lixels": ["32x32", "64x64"],
  "sizes": ["32x32"],
  "executor": "trace",
  "timing_frames": 1
})";

std::vector<std::string> linesOf(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

// What two runs have in common.
std::string withoutTiming(const std::string& jsonLines)
{
    std::string all;
    for (const std::string& line : linesOf(jsonLines)) {
        Json row = Json::parse(line);
        row.erase("timing");
        all += row.dump() + "\n";
    }
    return all;
}

class Sweep : public ::testing::Test
{
protected:
    Sweep()
    {
        fs::create_directories(folder_.path() / "files");
        fs::copy_file(dataFolder() / "room.obj", folder_.path() / "files/room.obj");
        fs::copy_file(dataFolder() / "room.mtl", folder_.path() / "files/room.mtl");
        write("study.json", kStudy);
    }
    void write(const std::string& name, const std::string& text) const { std::ofstream(folder_.path() / name) << text; }
    CommandResult lixel(const Words& words, CommandOptions options = {}) const
    {
        options.folder = folder_.path();
        return runLixel(words, options);
    }
    void study(const std::string& output, const Words& more = {}) const
    {
        Words words{"study", "study.json", "-o", output};
        words.insert(words.end(), more.begin(), more.end());
        const CommandResult run = lixel(words);
        EXPECT_EQ(run.exitCode, 0) << asTyped(words) << "\n" << run.err;
    }
    std::string refusal(const Words& words, int exitCode) const
    {
        const CommandResult run = lixel(words);
        EXPECT_EQ(run.exitCode, exitCode) << asTyped(words) << "\n" << run.err;
        EXPECT_EQ(run.out, "");
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
        return run.err;
    }
    // In the folder; what is printed goes nowhere.
    int shell(const std::string& command) const
    {
        return std::system(("cd '" + folder_.path().string() + "' && (" + command + ") >printed.log 2>&1").c_str());
    }
    std::string text(const std::string& file) const { return readWhole(folder_.path() / file); }
    std::string results(const std::string& output) const { return withoutTiming(text(output + "/results.jsonl")); }

    TemporaryFolder folder_;
};

void expectMention(const std::string& line, const std::string& word)
{
    EXPECT_NE(line.find(word), std::string::npos) << "\"" << word << "\" is not in: " << line;
}

TEST_F(Sweep, EveryCombinationHasItsRowAndEveryRefusalItsReason)
{
    study("out");
    const std::vector<std::string> lines = linesOf(text("out/results.jsonl"));
    std::set<std::string> keys;
    std::size_t refused = 0, number = 0;
    for (const std::string& line : lines) {
        EXPECT_EQ(schemaError(line, "study-row.schema.json"), "") << line;
        const Json row = Json::parse(line);
        EXPECT_EQ(row.at("row"), number++);
        EXPECT_TRUE(keys.insert(row.at("key")).second) << row.at("key");
        EXPECT_EQ(row.at("technique") == "exact", row.at("lixels") == "");
        const std::size_t lights = row.at("lights") == "pair" ? 2 : 1;
        EXPECT_EQ(row.at("light_count"), lights);
        if (!row.contains("refused")) continue;
        ++refused;
        EXPECT_EQ(row.at("scene"), "files/room.obj");
        const bool isOfPlanes = row.at("technique") != "focused";
        EXPECT_EQ(row.at("refused").at("reason"), isOfPlanes ? "no-such-plane" : "extent-not-in-hemisphere");
    }
    EXPECT_EQ(lines.size(), 3u * (1 + 2) * 5);
    EXPECT_GE(refused, 6u);
    EXPECT_LT(refused, lines.size() / 2);
    EXPECT_EQ(linesOf(text("out/results.csv")).size(), 1 + lines.size());
    EXPECT_GT(fs::file_size(folder_.path() / "out/report.html"), 10'000u);
    EXPECT_EQ(text("out/report.html").find(folder_.path().string()), std::string::npos) << "no place of one machine";
    EXPECT_EQ(text("out/results.jsonl").find(folder_.path().string()), std::string::npos);
}

TEST_F(Sweep, IsCompareRowByRow)
{
    study("out");
    const CommandResult run =
        lixel({"compare", "table", "--view", "under-table", "--size", "32x32", "--lixels", "64x64", "--techniques",
               "focused,planes(floor)+plane-optimal", "--executor", "trace", "--timing-frames", "0", "--json", "-"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    std::size_t found = 0;
    const Json whole = Json::parse(run.out);
    for (const Json& compared : whole.at("results"))
        for (const std::string& line : linesOf(text("out/results.jsonl"))) {
            const Json row = Json::parse(line);
            const auto same = [&](const char* member) { return row.at(member) == compared.at(member); };
            if (row.at("lights") != "own" || !same("scene") || !same("view") || !same("technique_full")) continue;
            if (row.at("lixels") != "" && !same("lixels")) continue;
            ++found;
            for (const auto& [name, value] : compared.items())
                if (name != "timing" && name != "pictures" && name != "lixels") {
                    EXPECT_EQ(row.at(name), value) << name;
                }
        }
    EXPECT_EQ(found, 3u);
}

// Twenty times when thorough. A run is killed after a random time, begun again, and again, until one is done; what it had kept
// stays in place byte by byte.
TEST_F(Sweep, ARunKilledAtRandomMomentsGivesWhatAnUndisturbedOneGives)
{
    study("whole");
    const auto begin = std::chrono::steady_clock::now();
    study("again");
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    EXPECT_EQ(results("again"), results("whole"));

    const int kills = isThorough() ? 20 : 4;
    std::uint64_t seed = std::uint64_t(begin.time_since_epoch().count());
    if (const char* given = std::getenv("LIXEL_SEED")) seed = std::stoull(given);
    SCOPED_TRACE("LIXEL_SEED=" + std::to_string(seed));
    std::printf("seed %llu\n", static_cast<unsigned long long>(seed));
    Rng rng(seed);
    std::string kept;
    int killed = 0;
    for (int attempt = 0; killed < kills && attempt < 50 * kills; ++attempt) {
        const double lives = rng.uniform(0, 1.2 * seconds);
        const auto started = std::chrono::steady_clock::now();
        CommandOptions options;
        options.signal = SIGKILL;
        options.interruptWhen = [&] {
            return std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count() > lives;
        };
        const CommandResult run = lixel({"study", "study.json", "-o", "killed"}, options);
        if (run.exitCode == 0) {
            EXPECT_EQ(results("killed"), results("whole"));
            fs::remove_all(folder_.path() / "killed");
            kept.clear();
            continue;
        }
        ASSERT_EQ(run.exitCode, kKilled) << run.err;
        ++killed;
        const fs::path rows = folder_.path() / "killed/rows.jsonl";
        if (!fs::exists(rows)) continue;
        const std::string now = readWhole(rows), whole = now.substr(0, now.rfind('\n') + 1);
        EXPECT_EQ(now.substr(0, kept.size()), kept.substr(0, now.size())) << "what was kept is measured again";
        kept = whole.size() > kept.size() ? whole : kept;
    }
    EXPECT_EQ(killed, kills);
    study("killed");
    EXPECT_EQ(results("killed"), results("whole"));
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path() / "killed"))
        EXPECT_NE(entry.path().extension(), ".part") << "left behind";
}

// Wherever the file ends: in a line, in a cell of two rows, or in the head.
TEST_F(Sweep, AFileOfRowsCutAnywhereIsGoneOnWith)
{
    study("whole");
    const std::string rows = text("whole/rows.jsonl");
    forEachCase(4, [&](Rng& rng) {
        fs::create_directories(folder_.path() / "cut");
        write("cut/rows.jsonl", rows.substr(0, std::size_t(rng.integer(0, int(rows.size()) - 1))));
        study("cut");
        EXPECT_EQ(results("cut"), results("whole"));
        EXPECT_EQ(linesOf(text("cut/rows.jsonl")).size(), linesOf(rows).size());
        fs::remove_all(folder_.path() / "cut");
    });
}

TEST_F(Sweep, AFinishedRunMeasuresNothingAgain)
{
    study("out");
    const std::string rows = text("out/rows.jsonl"), table = text("out/results.csv");
    const CommandResult again = lixel({"study", "study.json", "-o", "out"});
    expectMention(again.out, "0 measured now, 45 kept");
    EXPECT_EQ(text("out/rows.jsonl"), rows);
    EXPECT_EQ(text("out/results.csv"), table);
    study("out", {"--no-timing"});
    EXPECT_EQ(text("out/results.jsonl").find("timing"), std::string::npos);
    EXPECT_EQ(text("out/results.csv").find("timing"), std::string::npos);
    EXPECT_EQ(text("out/rows.jsonl"), rows);
}

TEST_F(Sweep, InterruptedLeavesWhatGoesOn)
{
    study("whole");
    CommandOptions options;
    const fs::path rows = folder_.path() / "out/rows.jsonl";
    options.interruptWhen = [&] { return fs::exists(rows) && linesOf(readWhole(rows)).size() > 5; };
    const CommandResult run = lixel({"study", "study.json", "-o", "out"}, options);
    EXPECT_EQ(run.exitCode, kInterrupted) << run.err;
    const CommandResult again = lixel({"study", "study.json", "-o", "out"});
    EXPECT_EQ(again.exitCode, 0) << again.err;
    EXPECT_EQ(again.out.find(" 0 kept"), std::string::npos) << again.out;
    EXPECT_EQ(results("out"), results("whole"));
}

// By --no-timing byte for byte, table and lines.
TEST_F(Sweep, ThreeShardsMergedAreOneRun)
{
    study("whole", {"--no-timing"});
    for (const char* k : {"1", "2", "3"}) study(std::string("part") + k, {"--shard", std::string(k) + "/3"});
    const CommandResult merged = lixel({"merge", "part2", "part3", "part1", "-o", "merged", "--no-timing"});
    ASSERT_EQ(merged.exitCode, 0) << merged.err;
    EXPECT_EQ(text("merged/results.jsonl"), text("whole/results.jsonl"));
    EXPECT_EQ(text("merged/results.csv"), text("whole/results.csv"));
    EXPECT_GT(fs::file_size(folder_.path() / "merged/report.html"), 10'000u);
    const CommandResult goneOnWith = lixel({"study", "study.json", "-o", "merged"});
    expectMention(goneOnWith.out, "0 measured now");

    // More shards than there are cells: some have nothing to do.
    Words all{"merge", "-o", "many"};
    for (int k = 1; k <= 40; k += 13) all.push_back("few" + std::to_string(k));
    study("few1", {"--shard", "1/40"});
    expectMention(lixel({"study", "study.json", "-o", "few1", "--shard", "1/40"}).out, "0 rows of shard 1/40");
}

// The lines of docs/studies.md, where there is what they take (scripts/packages extra).
TEST_F(Sweep, GnuParallelRunsItsShards)
{
    if (shell("parallel --version") != 0) GTEST_SKIP() << "needs GNU parallel";
    study("whole", {"--no-timing"});
    ASSERT_EQ(shell("parallel -j 2 '" LIXEL_CLI "' study study.json -o out/{} --shard {}/3 ::: 1 2 3"), 0);
    ASSERT_EQ(shell("'" LIXEL_CLI "' merge out/? -o out/all --no-timing"), 0);
    EXPECT_EQ(text("out/all/results.csv"), text("whole/results.csv"));
}

TEST_F(Sweep, ASlurmJobArrayRunsItsShards)
{
    if (shell("sinfo --noheader --Format=available | grep -q up") != 0) GTEST_SKIP() << "needs a Slurm cluster at work";
    study("whole", {"--no-timing"});
    ASSERT_EQ(shell("sbatch --array=1-3 --wait --mem=1G --export=ALL,LIXEL='" LIXEL_CLI "' '" LIXEL_SOURCE_DIR
                    "/examples/study/array.sbatch' study.json out"),
              0);
    ASSERT_EQ(shell("'" LIXEL_CLI "' merge out/shard-* -o out/all --no-timing"), 0);
    EXPECT_EQ(text("out/all/results.csv"), text("whole/results.csv"));
}

TEST_F(Sweep, MergeNoticesMissingDoubledAndForeignRows)
{
    for (const char* k : {"1", "2", "3"}) study(std::string("part") + k, {"--shard", std::string(k) + "/3"});
    const std::string missing = refusal({"merge", "part1", "part3", "-o", "out"}, kBadInput);
    expectMention(missing, "of 45 rows are missing");
    expectMention(missing, "no folder given has the shard");
    expectMention(refusal({"merge", "part1", "part2", "part3", "part2", "-o", "out"}, kBadInput), "has too");
    expectMention(refusal({"merge", "part1", "nowhere", "-o", "out"}, kBadInput), "nowhere/rows.jsonl");

    const std::string rows = text("part2/rows.jsonl");
    const std::vector<std::string> lines = linesOf(rows);
    write("part2/rows.jsonl", rows.substr(0, rows.size() - lines.back().size() - 1));
    expectMention(refusal({"merge", "part1", "part2", "part3", "-o", "out"}, kBadInput), "run its shard 2/3 again");
    write("part2/rows.jsonl", rows + lines.back() + "\n");
    refusal({"merge", "part1", "part2", "part3", "-o", "out"}, kBadInput);
    Json foreign = Json::parse(lines.back());
    foreign["key"] = "something else";
    write("part2/rows.jsonl", rows + foreign.dump() + "\n");
    expectMention(refusal({"merge", "part1", "part2", "part3", "-o", "out"}, kBadInput), "something else");

    write("part2/rows.jsonl", rows);
    Json other = Json::parse(kStudy);
    other["seed"] = 7;
    write("study.json", other.dump());
    study("other", {"--shard", "2/3"});
    expectMention(refusal({"merge", "part1", "other", "part3", "-o", "out"}, kBadInput), "another study");
    EXPECT_FALSE(fs::exists(folder_.path() / "out"));
}

TEST_F(Sweep, WhatHasChangedIsNoticed)
{
    study("out");
    Json same = Json::parse(kStudy);
    write("study.json", same.dump(4)); // laid out otherwise, and its members in another order
    expectMention(lixel({"study", "study.json", "-o", "out"}).out, "0 measured now");
    const std::string rows = text("out/rows.jsonl");

    expectMention(refusal({"study", "study.json", "-o", "out", "--shard", "1/2"}, kBadUsage), "shard");
    Json changed = same;
    changed["lixels"].push_back("16x16");
    write("study.json", changed.dump());
    expectMention(refusal({"study", "study.json", "-o", "out"}, kBadUsage), "--restart");
    write("study.json", kStudy);
    std::ofstream(folder_.path() / "files/room.obj", std::ios::app) << "# changed\n";
    expectMention(refusal({"study", "study.json", "-o", "out"}, kBadUsage), "--restart");
    fs::copy_file(dataFolder() / "room.obj", folder_.path() / "files/room.obj", fs::copy_options::overwrite_existing);

    std::string older = rows;
    older.replace(older.find("\"lixel_version\":\"") + 17, 5, "0.0.9");
    write("out/rows.jsonl", older);
    expectMention(refusal({"study", "study.json", "-o", "out"}, kBadInput), "line 2");
    write("out/rows.jsonl", older.substr(0, older.find('\n') + 1));
    expectMention(refusal({"study", "study.json", "-o", "out"}, kBadUsage), "by lixel 0.0.9");
    write("out/rows.jsonl", "{}\n" + rows);
    expectMention(refusal({"study", "study.json", "-o", "out"}, kBadInput), "line 1");
    study("out", {"--restart"});
    EXPECT_EQ(withoutTiming(text("out/results.jsonl")).size(), results("out").size());
    EXPECT_EQ(linesOf(text("out/rows.jsonl")).size(), 46u);
}

TEST_F(Sweep, FilesAreReadToTheLetter)
{
    const struct
    {
        const char *place, *value, *mention;
    } wrong[] = {
        {"/scens", R"(["table"])", "\"scens\" is unknown"},
        {"/scenes", "[]", "/scenes: expected an array of at least 1"},
        {"/scenes", R"(["atlantis"])", "/scenes/0: scene \"atlantis\" is not built in"},
        {"/scenes", R"j(["table(things=0)"])j", "things"},
        {"/scenes", R"(["table", "table"])", "stands here twice"},
        {"/scenes", R"(["missing.glb"])", "missing.glb: no such file"},
        {"/scenes", R"(["/scenes/room.obj"])", "/scenes/0: expected a path relative"},
        {"/scenes", R"([{"scene": "table", "view": "all"}])", "\"view\" is unknown"},
        {"/views", R"(["nowhere"])", "\"nowhere\""},
        {"/views", R"(["all", "overview"])", "is asked for twice"},
        {"/views", R"(["missing.json"])", "missing.json: no such file"},
        {"/techniques", R"(["nope"])", "/techniques/0: technique \"nope\""},
        {"/techniques", R"(["focused", "whole+focused"])", "stands here twice"},
        {"/techniques", R"j(["planes(ceiling)+focused"])j", "no plane \"ceiling\""},
        {"/techniques", R"j(["matrix(/plan.json)"])j", "relative"},
        {"/lixels", R"(["0x5"])", "/lixels/0"},
        {"/lixels", "[512]", "/lixels/0: expected text"},
        {"/sizes", R"(["9000x1"])", "/sizes/0"},
        {"/times", "[-1]", "/times/0"},
        {"/lights", R"(["sun"])", "/lights/0"},
        {"/lights", R"([{"suns": 0}])", "/lights/0/suns"},
        {"/lights", R"([{"name": "x", "lights": [{}]}])", "/lights/0/lights/0"},
        {"/executor", R"("vulkan")", "/executor"},
        {"/seed", "-1", "/seed"},
        {"/timing_frames", "1.5", "/timing_frames"},
    };
    for (const auto& [place, value, mention] : wrong) {
        Json study = Json::parse(kStudy);
        study[Json::json_pointer(place)] = Json::parse(value);
        write("wrong.json", study.dump());
        expectMention(refusal({"study", "wrong.json", "-o", "out"}, kBadInput), mention);
        EXPECT_FALSE(fs::exists(folder_.path() / "out")) << "something is left behind by " << mention;
    }
    for (const char* missing : {"scenes", "techniques", "lixels", "sizes"}) {
        Json study = Json::parse(kStudy);
        study.erase(missing);
        write("wrong.json", study.dump());
        expectMention(refusal({"study", "wrong.json", "-o", "out"}, kBadInput), missing);
    }
    write("wrong.json", "{");
    expectMention(refusal({"study", "wrong.json", "-o", "out"}, kBadInput), "expected JSON");
    expectMention(refusal({"study", "missing.json", "-o", "out"}, kBadInput), "missing.json: no such file");
    expectMention(refusal({"study", "study.json"}, kBadUsage), "-o FOLDER");
    for (const char* shard : {"0/3", "4/3", "1", "1/", "a/b", "1/3x", "-1/3"})
        expectMention(refusal({"study", "study.json", "-o", "out", std::string("--shard=") + shard}, kBadUsage),
                      "--shard");
    expectMention(refusal({"study", "-o", "out"}, kBadUsage), "FILE");
    expectMention(refusal({"merge", "-o", "out"}, kBadUsage), "FOLDER");
    expectMention(refusal({"merge", "a"}, kBadUsage), "-o FOLDER");
}

} // namespace
} // namespace lixel::test
