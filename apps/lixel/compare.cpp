// SPDX-License-Identifier: MIT
#include "commands.h"
#include "comparison.h"
#include "exit_code.h"
#include "lixel/report/html.h"
#include "lixel/report/json.h"
#include "lixel/report/write_file.h"
#include "option_checks.h"
#include "output.h"
#include "path_comparison.h"
#include "run_results.h"
#include "text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace lixel::app {
namespace {

struct CompareOptions
{
    PictureOptions picture;
    PathOptions path;
    std::string techniques = "uniform,focused";
    std::string lixels = "512x512";
    std::string output;
    std::string json;
    std::string executor = "gl";
    int timingFrames = 5;
    bool withoutPictures = false;
    bool withShades = false;
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

std::string percent(std::int64_t part, std::int64_t whole)
{
    return whole > 0 ? fmt::format("{:.4f} %", 100.0 * double(part) / double(whole)) : "no samples";
}

// Steadiness, and what it costs in sharpness.
std::string temporalColumns(const Measurement& m)
{
    const auto number = [](const std::optional<Percentiles>& of, double Percentiles::*which) {
        return of ? fmt::format("{:.2f}", *of.*which) : "";
    };
    return fmt::format("{:>12} {:>14} {:>14}", percent(m.temporal->all.flips, m.temporal->all.samples),
                       number(m.footprintPixelsPerLixel, &Percentiles::p50),
                       number(m.footprintPixelsPerLixel, &Percentiles::p90));
}

std::string shadeColumns(const ShadeQuality& shades)
{
    return fmt::format("{:>7} {:>10.2f} {:>10.4f} {:>13} {:>10}", shades.distinct, shades.transitionPixels,
                       shades.area.rmse, shades.filtered ? fmt::format("{:.4f}", shades.filtered->rmse) : "",
                       fmt::format("{:.4f} %", shades.bleedingPercent));
}

void printSummary(const RunResults& results, bool isPath, std::FILE* to)
{
    const bool hasShades = std::ranges::any_of(
        results.rows, [](const ResultRow& row) { return row.measured() && row.measured()->shades; });
    fmt::print(to, "{:<24} {:<14} {:<34} {:<6} {:>14} {:>12} {:>10}", "view", "light", "technique", "by",
               "misclassified", "interior", "frame");
    fmt::print(to, "{}\n",
               isPath      ? fmt::format(" {:>12} {:>14} {:>14}", "flips", "footprint p50", "footprint p90")
               : hasShades ? fmt::format(" {:>7} {:>10} {:>10} {:>13} {:>10}", "shades", "transition", "area RMSE",
                                         "filtered RMSE", "bleeding")
                           : "");
    for (const ResultRow& row : results.rows) {
        fmt::print(to, "{:<24} {:<14} {:<34} {:<6} ", row.view, row.light, row.technique, row.executor);
        if (const Refusal* refusal = row.refused()) {
            fmt::print(to, "refused: {}\n", refusal->message);
            continue;
        }
        const Measurement& m = *row.measured();
        fmt::print(to, "{:>14} {:>12} {:>10}{}{}\n", percent(m.misclassified, m.lightFacing),
                   percent(m.interior.misclassified, m.interior.samples),
                   m.timing.frameMs ? fmt::format("{:.1f} ms", *m.timing.frameMs) : "",
                   m.temporal ? " " + temporalColumns(m) : "", m.shades ? " " + shadeColumns(*m.shades) : "");
    }
}

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

std::vector<ResultRow> compareFrames(const PathShooting& path, std::span<const std::unique_ptr<Executor>> executors,
                                     const ComparisonOptions& options)
{
    Progress progress("compare", stepsOfPath(path, executors.size(), options));
    return comparePath(path, executors, options, [&](std::string_view now) { progress.step(now); });
}

// --path alone is the whole of it; with --time one picture, unless frames are asked for too.
bool isPathOfFrames(const CompareOptions& options)
{
    const bool asksForFrames = options.path.frames || options.path.fps || options.path.isStill;
    if (asksForFrames && !options.picture.alongPath)
        throw UsageError("--frames, --fps and --still go with --path, the scene's or the view file's");
    if (options.path.fps && !(*options.path.fps > 0 && std::isfinite(*options.path.fps)))
        throw UsageError("--fps: a number above 0 is expected");
    return options.picture.alongPath && (asksForFrames || !options.picture.time);
}

// Refused as a whole: there were maps to make, and none could be made.
int exitCodeOf(const RunResults& results)
{
    // Exact visibility stands beside every comparison.
    const auto isServed = [](const ResultRow& row) { return row.measured() && row.techniqueFull != "exact"; };
    const auto isRefused = [](const ResultRow& row) { return row.refused() != nullptr; };
    return std::ranges::any_of(results.rows, isRefused) && std::ranges::none_of(results.rows, isServed) ? kRefused
                                                                                                        : kDone;
}

int runCompare(const CompareOptions& options, const std::string& commandLine)
{
    ComparisonOptions comparison;
    comparison.techniques = withExact(readTechniques(options.techniques));
    comparison.lixels = readBudget(options.lixels, "--lixels", kMostLixelsASide);
    comparison.timingFrames = options.timingFrames;
    comparison.withShades = options.withShades;
    const bool isPath = isPathOfFrames(options);
    for (const TechniqueChoice& choice : comparison.techniques)
        if (isPath && std::holds_alternative<ShadowVolumesTechnique>(choice.technique))
            throw UsageError(
                "shadow-volumes: samples that are followed from frame to frame do not stand at pixel centres, "
                "which is where volumes are counted; --path takes the other techniques");
    if (isPath && options.withShades) throw UsageError("--shades is of pictures, not of the frames of a path");
    if (options.output.empty() && options.json.empty())
        throw UsageError("compare: give -o FOLDER for the report, or --json FILE (or -)");
    if (options.output == "-") throw UsageError("compare -o -: expected the name of a folder");
    const std::filesystem::path output = options.output;
    std::optional<ReportFolder> report;
    if (!options.output.empty()) report.emplace(output, !options.withoutPictures);
    if (report && !options.withoutPictures) comparison.pictures = report->writeTo();
    if (!options.json.empty()) expectWritable(options.json);
    const PathShooting path = isPath ? preparePath(options.picture, options.path) : PathShooting();
    const Shooting shooting = isPath ? path.shooting : prepare(options.picture, true);
    expectPlanes(comparison.techniques, shooting);
    const auto executors = makeExecutors(options.executor);

    RunResults results;
    const Stopwatch total;
    results.rows = isPath ? compareFrames(path, executors, comparison) : compareAll(shooting, executors, comparison);
    finishResults(results, commandLine, total.seconds(), executors.front()->host());

    const std::string json = toJson(results);
    if (!options.json.empty()) writeOrPrint(options.json, json);
    if (report) {
        writeFileAtomically(report->writeTo() / "results.json", json);
        writeReport(report->writeTo(), results);
        report->finish();
    }
    tellWarnings(*shooting.scene);
    // With JSON on standard output the table goes beside it.
    std::FILE* const told = options.json == "-" ? stderr : stdout;
    printSummary(results, isPath, told);
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
    app->get_option("--path")->description(
        "along the path of the scene or the view file, frame by frame, with the samples that flip between frames; "
        "with --time alone one picture of it");
    app->add_option("--frames", o->path.frames,
                    fmt::format("with --path: how many frames of it, evenly from its begin, or --time, to its end; "
                                "{} where neither --time nor --fps is given",
                                kFramesOfPath))
        ->check(CLI::Range(2, kMostFramesOfPath));
    app->add_option("--fps", o->path.fps,
                    "with --path: frames a second; with --frames only so many, from its begin or --time")
        ->check(notEmpty());
    app->add_flag("--still", o->path.isStill, "with --path: casters and light stay, only the camera moves");
    app->add_option("--techniques", o->techniques, "comma-separated (lixel techniques)")->capture_default_str();
    app->add_option("--lixels", o->lixels,
                    "budget of each light, WIDTHxHEIGHT; several, split at commas: of its regions")
        ->capture_default_str();
    app->add_option("-o,--output", o->output, "folder for results.json, report.html and pictures");
    app->add_option("--json", o->json, "results as JSON to this file, or - for standard output");
    app->add_option("--executor", o->executor, "gl, trace, or both on the same view samples")
        ->check(CLI::IsMember({"gl", "trace", "both"}))
        ->capture_default_str();
    app->add_option("--timing-frames", o->timingFrames, "frames to take the median time of; 0: none")
        ->check(CLI::Range(0, 1000))
        ->capture_default_str();
    app->add_flag(
        "--shades", o->withShades,
        "how good partial shadows are: their number, width and error over the edge band, against the share of "
        "the pixel and of the filter's footprint that is lit");
    app->add_flag("--no-pictures", o->withoutPictures, "only numbers in the report");
    return {app, [o, commandLine] { return runCompare(*o, commandLine); }};
}

} // namespace lixel::app
