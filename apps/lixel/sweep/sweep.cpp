// SPDX-License-Identifier: MIT
#include "sweep/sweep.h"

#include "exit_code.h"
#include "lixel/report/html.h"
#include "lixel/report/sweep.h"
#include "lixel/report/write_file.h"
#include "lixel/scene/load.h"
#include "output.h"
#include "progress.h"
#include "run_results.h"
#include "sweep/sweep_run.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace fs = std::filesystem;

namespace lixel::app {
namespace {

constexpr std::array kResultFiles{"results.jsonl", "results.csv", "report.html"};
constexpr std::size_t kMostShards = 1'000'000;

Shard readShard(const std::string& text)
{
    Shard shard;
    const char *begin = text.data(), *end = begin + text.size();
    const auto number = std::from_chars(begin, end, shard.number);
    const bool hasSlash = number.ec == std::errc{} && number.ptr != end && *number.ptr == '/';
    const auto of = hasSlash ? std::from_chars(number.ptr + 1, end, shard.of) : number;
    if (!hasSlash || of.ec != std::errc{} || of.ptr != end || shard.number < 1 || shard.number > shard.of ||
        shard.of > kMostShards)
        throw UsageError(fmt::format("--shard \"{}\": expected k/n, k from 1 to n", text));
    return shard;
}

// What is in the folder belongs to another study, or to another part of it.
void expectSame(const RowFile& known, const SweepFile& file, const Shard& shard, const fs::path& path)
{
    const auto refuse = [&](const std::string& what) {
        throw UsageError(fmt::format("{}: {}; --restart begins anew, and its rows are lost", path.string(), what));
    };
    if (known.plan.hash != file.hash)
        refuse(fmt::format("its rows are of a file that says something else than {}", file.path.string()));
    if (known.plan.lixelVersion != LIXEL_VERSION)
        refuse(fmt::format("its rows are by lixel {}, this is {}", known.plan.lixelVersion, LIXEL_VERSION));
    if (!(known.shard == shard))
        refuse(fmt::format("its rows are of shard {}, not of {}", toString(known.shard), toString(shard)));
    if (!known.doubled.empty()) throw InputError(path.string() + ": has a row twice: " + known.doubled.front());
}

std::vector<std::size_t> cellsToDo(const RowFile& file)
{
    std::vector<std::size_t> out;
    for (std::size_t cell = 0; cell < file.cells.size(); ++cell)
        if (file.shard.holds(cell, file.cells.size()) && !file.rows.contains(file.cells[cell].firstRow))
            out.push_back(cell);
    return out;
}

std::string nameOf(const SweepPlan& plan, const SweepCell& cell)
{
    const SweepGroup& group = plan.groups[cell.group];
    return fmt::format("{} {} {} {}", plan.scenes[group.scene], group.view, plan.techniques[cell.technique].typed,
                       cell.lixels);
}

// What a run left that was killed while it wrote its results; no other is at work here.
void removeUnfinishedResults(const fs::path& folder)
{
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        const auto isOf = [&](const char* result) { return name.starts_with("." + std::string(result) + "."); };
        if (name.ends_with(".part") && std::ranges::any_of(kResultFiles, isOf)) found.push_back(entry.path());
    }
    for (const fs::path& path : found) fs::remove(path);
}

// What is left to do is done, and added to the file and to `file`. The host.
std::string measureRest(const SweepFile& study, SceneShelf& shelf, RowLog& log, RowFile& file)
{
    const std::vector<std::size_t> rest = cellsToDo(file);
    if (rest.empty()) return "";
    SweepRun run(study, file.plan, shelf);
    Progress progress("study", int(rest.size()));
    for (const std::size_t number : rest) {
        const SweepCell& cell = file.cells[number];
        progress.step(nameOf(file.plan, cell));
        const std::vector<std::string> lines = run.measure(cell);
        log.append(lines);
        for (std::size_t i = 0; i < lines.size(); ++i) file.rows.emplace(cell.firstRow + i, lines[i]);
    }
    return run.host();
}

} // namespace

void addSweepOptions(CLI::App& app, SweepOptions& o)
{
    app.add_option("FILE", o.file, "a study of your own (JSON, docs/studies.md; its name has a / or a .)");
    app.add_option("-o,--output", o.output,
                   "of a FILE: folder for rows.jsonl, and at the end results.jsonl, results.csv and report.html; where "
                   "it has rows of the same study, they are kept");
    app.add_option("--shard", o.shard, "of a FILE: k/n, the k-th of n parts only (lixel merge puts them together)")
        ->capture_default_str();
    app.add_flag("--restart", o.restart, "of a FILE: throw away what rows the folder has");
    app.add_flag("--no-timing", o.withoutTiming, "of a FILE: results without times and machines");
}

int runSweep(const SweepOptions& options)
{
    if (options.output.empty() || options.output == "-")
        throw UsageError("study FILE: give -o FOLDER for its rows and the report");
    const Stopwatch total;
    const Shard shard = readShard(options.shard);
    const SweepFile study = readSweepFile(options.file);
    const OutputFolder folder(options.output);
    for (const char* name : kResultFiles) expectWritable(folder.path() / name);
    const fs::path path = folder.path() / kRowFileName;
    RowLog log(path);
    removeUnfinishedResults(folder.path());
    SceneShelf shelf;
    std::optional<RowFile> file = options.restart ? std::nullopt : readRowFile(path);
    if (file) {
        expectSame(*file, study, shard, path);
        log.goOn(*file);
    } else {
        SweepPlan plan = planSweep(study, shelf);
        log.begin(plan, shard);
        file = RowFile{plan, plan.cells(), shard, {}, 0, {}};
    }
    const std::size_t kept = file->rows.size();
    if (!cellsToDo(*file).empty())
        for (const char* name : kResultFiles) fs::remove(folder.path() / name); // they are of other rows
    const std::string host = measureRest(study, shelf, log, *file);
    writeSweepResults(folder.path(), {*file, options.commandLine, host, total.seconds(), !options.withoutTiming});
    const std::size_t rows = file->rows.size();
    fmt::print("{}: {} rows{}, {} measured now, {} kept, {} refused\nreport: {}\n", file->plan.study, rows,
               shard.of > 1 ? " of shard " + toString(shard) : "", rows - kept, kept, refusedIn(*file),
               (folder.path() / "report.html").string());
    return kDone;
}

void writeSweepResults(const fs::path& folder, const SweepEnd& end)
{
    SweepResults results{end.file.plan.study,
                         end.file.plan.question,
                         end.file.plan.lixelVersion,
                         end.commandLine,
                         end.file.plan.seed,
                         {},
                         timingNow(end.seconds, end.host)};
    for (const auto& [number, line] : end.file.rows) results.lines.push_back(line);
    writeFileAtomically(folder / "results.jsonl", toJsonLines(results.lines, end.withTiming));
    writeFileAtomically(folder / "results.csv", toCsv(results.lines, end.withTiming));
    writeReport(folder, results);
}

std::size_t refusedIn(const RowFile& file)
{
    return std::size_t(std::ranges::count_if(file.rows, [](const auto& row) {
        const auto name = nameOfSweepRow(row.second);
        return name && name->isRefused;
    }));
}

} // namespace lixel::app
