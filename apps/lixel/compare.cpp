// SPDX-License-Identifier: MIT
#include "commands.h"
#include "comparison.h"
#include "exit_code.h"
#include "lixel/report/html.h"
#include "lixel/report/json.h"
#include "lixel/report/write_file.h"
#include "output.h"
#include "run_results.h"
#include "text.h"

#include <algorithm>
#include <cstdio>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace lixel::app {
namespace {

struct CompareOptions
{
    PictureOptions picture;
    std::string techniques = "uniform,focused";
    std::string lixels = "512x512";
    std::string output;
    std::string json;
    std::string executor = "gl";
    int timingFrames = 5;
    bool withoutPictures = false;
};

std::vector<std::unique_ptr<Executor>> makeExecutors(const std::string& word)
{
    std::vector<std::unique_ptr<Executor>> executors;
    for (const char* name : {"gl", "trace"})
        if (word == name || word == "both") executors.push_back(makeExecutor(name));
    return executors;
}

// Exact visibility stands beside every comparison, so that pictures can be held against it.
std::vector<TechniqueChoice> withExact(std::vector<TechniqueChoice> techniques)
{
    for (const TechniqueChoice& choice : techniques)
        if (std::holds_alternative<ExactTechnique>(choice.technique)) return techniques;
    techniques.push_back({"exact", ExactTechnique{}});
    return techniques;
}

void printSummary(const RunResults& results, std::FILE* to)
{
    fmt::print(to, "{:<24} {:<14} {:<34} {:<6} {:>14} {:>12} {:>10}\n", "view", "light", "technique", "by",
               "misclassified", "interior", "frame");
    for (const ResultRow& row : results.rows) {
        fmt::print(to, "{:<24} {:<14} {:<34} {:<6} ", row.view, row.light, row.technique, row.executor);
        if (const Refusal* refusal = row.refused()) {
            fmt::print(to, "refused: {}\n", refusal->message);
            continue;
        }
        const Measurement& m = *row.measured();
        const auto percent = [](std::int64_t part, std::int64_t whole) {
            return whole > 0 ? fmt::format("{:.4f} %", 100.0 * double(part) / double(whole)) : "no samples";
        };
        fmt::print(to, "{:>14} {:>12} {:>10}\n", percent(m.misclassified, m.lightFacing),
                   percent(m.interior.misclassified, m.interior.samples),
                   m.timing.frameMs ? fmt::format("{:.1f} ms", *m.timing.frameMs) : "");
    }
}

// The folder of the report and what it will hold, asked for before the work begins.
struct ReportFolder
{
    ReportFolder(const std::filesystem::path& path, bool withPictures) : folder(path)
    {
        if (withPictures) pictures.emplace(path / "pictures");
        for (const char* name : {"results.json", "report.html"}) expectWritable(path / name);
    }
    OutputFolder folder;
    std::optional<OutputFolder> pictures;
};

std::vector<ResultRow> compareAll(const Shooting& shooting, std::span<const std::unique_ptr<Executor>> executors,
                                  const ComparisonOptions& options)
{
    std::vector<ResultRow> all;
    Progress progress("compare", int(shooting.shots.size()) * stepsPerShot(executors.size(), options));
    std::optional<Stage> stage;
    for (const Shot& shot : shooting.shots) {
        const Vec3d origin = originOf(shooting, shot);
        if (!stage || !(stage->buffers.triangles.originWorld == origin))
            stage = makeStage(shooting.scene, shooting.evaluateOptions, origin);
        std::vector<ResultRow> rows = compareShot(shooting, shot, *stage, viewOf(shooting, shot), executors, options,
                                                  [&](std::string_view now) { progress.step(now); });
        all.insert(all.end(), std::make_move_iterator(rows.begin()), std::make_move_iterator(rows.end()));
    }
    return all;
}

// Refused as a whole: there were maps to make, and none could be made.
int exitCodeOf(const RunResults& results)
{
    const auto isMap = [](const ResultRow& row) { return row.measured() && row.measured()->lixelsUsed > 0; };
    const auto isRefused = [](const ResultRow& row) { return row.refused() != nullptr; };
    return std::ranges::any_of(results.rows, isRefused) && std::ranges::none_of(results.rows, isMap) ? kRefused : kDone;
}

int runCompare(const CompareOptions& options, const std::string& commandLine)
{
    ComparisonOptions comparison;
    comparison.techniques = withExact(readTechniques(options.techniques));
    comparison.lixels = readSize(options.lixels, "--lixels", kMostLixelsASide);
    comparison.timingFrames = options.timingFrames;
    if (options.output.empty() && options.json.empty())
        throw UsageError("compare: give -o FOLDER for the report, or --json FILE (or -)");
    if (options.output == "-") throw UsageError("compare -o -: expected the name of a folder");
    const std::filesystem::path output = options.output;
    std::optional<ReportFolder> report;
    if (!options.output.empty()) report.emplace(output, !options.withoutPictures);
    if (report && report->pictures) comparison.pictures = output;
    if (!options.json.empty()) expectWritable(options.json);
    const Shooting shooting = prepare(options.picture, true);
    const auto executors = makeExecutors(options.executor);

    RunResults results;
    const Stopwatch total;
    results.rows = compareAll(shooting, executors, comparison);
    finishResults(results, commandLine, total.seconds(), executors.front()->host());

    const std::string json = toJson(results);
    if (!options.json.empty()) writeOrPrint(options.json, json);
    if (report) {
        writeFileAtomically(output / "results.json", json);
        writeReport(output, results);
    }
    tellWarnings(*shooting.scene);
    // With JSON on standard output the table goes beside it.
    std::FILE* const told = options.json == "-" ? stderr : stdout;
    printSummary(results, told);
    if (report) fmt::print(told, "report: {}\n", (output / "report.html").string());
    return exitCodeOf(results);
}

} // namespace

Command addCompare(CLI::App& parent, const std::string& commandLine)
{
    auto o = std::make_shared<CompareOptions>();
    CLI::App* app =
        parent.add_subcommand("compare", "how wrong techniques are against exact visibility, and what they cost");
    addPictureOptions(*app, o->picture);
    app->add_option("--techniques", o->techniques, "comma-separated (lixel techniques)")->capture_default_str();
    app->add_option("--lixels", o->lixels, "budget of each light, WIDTHxHEIGHT")->capture_default_str();
    app->add_option("-o,--output", o->output, "folder for results.json, report.html and pictures");
    app->add_option("--json", o->json, "results as JSON to this file, or - for standard output");
    app->add_option("--executor", o->executor, "gl, trace, or both on the same view samples")
        ->check(CLI::IsMember({"gl", "trace", "both"}))
        ->capture_default_str();
    app->add_option("--timing-frames", o->timingFrames, "frames to take the median time of; 0: none")
        ->check(CLI::Range(0, 1000))
        ->capture_default_str();
    app->add_flag("--no-pictures", o->withoutPictures, "only numbers in the report");
    return {app, [o, commandLine] { return runCompare(*o, commandLine); }};
}

} // namespace lixel::app
