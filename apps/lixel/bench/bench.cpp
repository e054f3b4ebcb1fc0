// SPDX-License-Identifier: MIT
#include "bench/bench_axes.h"
#include "bench/bench_point.h"
#include "bench/memory.h"
#include "commands.h"
#include "exit_code.h"
#include "lixel/report/html.h"
#include "lixel/report/write_file.h"
#include "option_checks.h"
#include "output.h"
#include "progress.h"
#include "run_results.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

// `lixel bench`: how the cost of techniques grows with triangles, pixels, lixels and lights.
namespace lixel::app {
namespace {

constexpr const char* kTechniques =
    "uniform,focused,focused+pcf(9),focused+depths(4),focused+vsm,lispsm,pssm(4),sdsm(4),"
    "planes(floor)+plane-optimal,scene-optimal,rtw,now,shadow-volumes";
constexpr const char* kQuickTechniques = "focused,focused+pcf(9),pssm(4),scene-optimal,now";
constexpr int kFrames = 9, kQuickFrames = 3;
constexpr double kMemoryShare = 0.8; // of what is left, that a row may be expected to take

struct BenchOptions
{
    std::string techniques, axes, output, json, executor = "gl";
    int frames = 0; // 0: the run's own
    double rowSeconds = 120;
    bool isQuick = false;
};

// What a technique took at the point before, from which the next one is foretold.
struct Before
{
    double size = 0, seconds = 0;
    std::uint64_t bytes = 0; // in the process at once
};

// Why a row is left out: if cost grows in proportion, which is as fast as any of this does, it would be too much.
std::string whyTooMuch(const Before& before, double size, double mostSeconds)
{
    if (before.size == 0) return "";
    const double times = size / before.size, seconds = before.seconds * times, bytes = double(before.bytes) * times;
    if (seconds > mostSeconds)
        return fmt::format("would take about {:.0f} s, more than --row-seconds {:g}", seconds, mostSeconds);
    const auto left = memoryLeft(), resident = residentMemory();
    if (!left || !resident) return "";
    const double most = kMemoryShare * (double(*left) + double(*resident));
    if (bytes > most)
        return fmt::format("would take about {:.1f} GiB of memory, there are {:.1f}", bytes / (1 << 30),
                           most / (1 << 30));
    return "";
}

std::vector<BenchRow> rowsOf(const BenchSeries& series, std::span<const TechniqueChoice> techniques,
                             const BenchOptions& options, Progress& progress)
{
    std::map<std::string, Before> before;
    std::vector<BenchRow> rows;
    Before staging; // the scene itself
    for (const BenchPoint& point : series.points) {
        const double size = sizeOn(series.axis.name, point, std::uint64_t(point.triangles));
        const std::string wholeTooMuch = whyTooMuch(staging, size, options.rowSeconds);
        const Stopwatch stagingTime;
        const PeakMemory stagingPeak;
        std::optional<BenchStage> stage;
        if (wholeTooMuch.empty()) {
            stage.emplace(point, options.executor);
            staging = {size, stagingTime.seconds(), stagingPeak.bytes().value_or(0)};
        }
        for (const TechniqueChoice& technique : techniques) {
            progress.step(fmt::format("{} {:.3g}: {}", series.axis.name, size, technique.typed));
            const std::uint64_t triangles = stage ? stage->triangles() : std::uint64_t(point.triangles);
            BenchRow& row = rows.emplace_back(BenchRow{series.axis.name,
                                                       technique.typed,
                                                       sizeOn(series.axis.name, point, triangles),
                                                       triangles,
                                                       std::uint64_t(point.side) * std::uint64_t(point.side),
                                                       std::uint64_t(point.mapSide) * std::uint64_t(point.mapSide),
                                                       std::uint64_t(point.lights),
                                                       {},
                                                       wholeTooMuch});
            Before& known = before[technique.typed];
            if (row.skipped.empty()) row.skipped = whyTooMuch(known, row.size, options.rowSeconds);
            if (!row.skipped.empty()) continue;
            const Stopwatch time;
            const BenchStage::Outcome outcome = stage->measure(technique, options.frames);
            row.measured = outcome.measured;
            row.skipped = outcome.whyNot;
            if (row.measured) known = {row.size, time.seconds(), row.measured->peakResidentBytes.value_or(0)};
        }
    }
    // By technique, so that a line's points stand together.
    std::ranges::stable_sort(rows, {}, [&](const BenchRow& row) {
        return std::ranges::find(techniques, row.technique, &TechniqueChoice::typed) - techniques.begin();
    });
    return rows;
}

// Exponents of all axes, a technique a line.
void printGrowth(const BenchResults& bench, std::FILE* to)
{
    const std::vector<BenchGrowth> growths = growthsOf(bench);
    std::vector<std::string> techniques;
    for (const BenchRow& row : bench.rows)
        if (std::ranges::find(techniques, row.technique) == techniques.end()) techniques.push_back(row.technique);
    for (const BenchAxis& axis : bench.axes) {
        fmt::print(to, "by {} ({}): exponents of the upper half\n{:<36} {:>10} {:>10} {:>14} {:>14} {:>16}\n",
                   axis.name, axis.others, "", "frame", "plan", "peak memory", "device memory", "frame of most");
        for (const std::string& technique : techniques) {
            fmt::print(to, "{:<36}", technique);
            for (const char* quantity : kBenchQuantities) {
                const auto found = std::ranges::find_if(growths, [&](const BenchGrowth& g) {
                    return g.axis == axis.name && g.technique == technique && g.quantity == std::string(quantity);
                });
                const bool isBytes = std::string_view(quantity).ends_with("bytes");
                fmt::print(to, " {:>{}}", found == growths.end() ? "-" : fmt::format("{:.2f}", found->growth.exponent),
                           isBytes ? 14 : 10);
            }
            const BenchRow* last = nullptr;
            for (const BenchRow& row : bench.rows)
                if (row.axis == axis.name && row.technique == technique && row.measured) last = &row;
            fmt::print(to, " {:>16}\n",
                       last ? fmt::format("{:.1f} ms", last->measured->timing.frameMs.value_or(0)) : "-");
        }
    }
    for (const BenchRow& row : bench.rows)
        if (!row.measured)
            fmt::print(to, "left out: {} at {:.4g} {}: {}\n", row.technique, row.size, row.axis, row.skipped);
}

int runBench(BenchOptions options, const std::string& commandLine)
{
    if (options.output.empty() && options.json.empty())
        throw UsageError("bench: give -o FOLDER for the report, or --json FILE (or -)");
    if (options.output == "-") throw UsageError("bench -o -: expected the name of a folder");
    if (options.techniques.empty()) options.techniques = options.isQuick ? kQuickTechniques : kTechniques;
    if (options.frames == 0) options.frames = options.isQuick ? kQuickFrames : kFrames;
    const std::vector<TechniqueChoice> techniques = readTechniques(options.techniques);
    const std::vector<BenchSeries> series = benchSeries(options.axes, options.isQuick);
    std::optional<ReportFolder> report;
    if (!options.output.empty()) report.emplace(options.output, false);
    if (!options.json.empty()) expectWritable(options.json);
    {
        PictureOptions planes;
        planes.scene = BenchPoint().scene();
        expectPlanes(techniques, prepare(planes, false));
    }
    BenchResults bench{LIXEL_VERSION, commandLine, options.executor, options.isQuick, options.frames, {}, {}, {}};
    const std::string host = makeExecutor(options.executor)->host();
    const Stopwatch total;
    {
        std::size_t points = 0;
        for (const BenchSeries& one : series) points += one.points.size();
        Progress progress("bench", int(points * techniques.size()));
        for (const BenchSeries& one : series) {
            bench.axes.push_back(one.axis);
            const std::vector<BenchRow> rows = rowsOf(one, techniques, options, progress);
            bench.rows.insert(bench.rows.end(), rows.begin(), rows.end());
        }
    }
    bench.timing = timingNow(total.seconds(), host);
    const std::string json = toJson(bench);
    if (!options.json.empty()) writeOrPrint(options.json, json);
    std::FILE* const told = options.json == "-" ? stderr : stdout;
    printGrowth(bench, told);
    if (report) {
        const std::filesystem::path folder = options.output;
        writeFileAtomically(folder / "results.json", json);
        writeReport(folder, bench);
        fmt::print(told, "report: {}\n", (folder / "report.html").string());
    }
    return kDone;
}

} // namespace

Command addBench(CLI::App& parent, const std::string& commandLine)
{
    auto o = std::make_shared<BenchOptions>();
    CLI::App* app =
        parent.add_subcommand("bench", "how the cost of techniques grows with triangles, pixels, lixels and lights");
    app->add_option("--techniques", o->techniques, "comma-separated (lixel techniques); by default one of each kind");
    app->add_option("--axes", o->axes, "of triangles, pixels, lixels and lights, comma-separated; by default all");
    app->add_option("--executor", o->executor, "gl or trace")
        ->check(CLI::IsMember({"gl", "trace"}))
        ->capture_default_str();
    app->add_option("--timing-frames", o->frames,
                    fmt::format("frames to take the median time of, after two more ({}, with --quick {})", kFrames,
                                kQuickFrames))
        ->check(CLI::Range(1, 1000));
    app->add_option("--row-seconds", o->rowSeconds, "what would take longer is left out, and says so")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app->add_flag("--quick", o->isQuick, "fewer and smaller cases, fewer techniques");
    app->add_option("-o,--output", o->output, "folder for results.json and report.html");
    app->add_option("--json", o->json, "what was measured as JSON to this file, or - for standard output");
    return {app, [o, commandLine] { return runBench(*o, commandLine); }};
}

} // namespace lixel::app
