// SPDX-License-Identifier: MIT
#include "commands.h"
#include "exit_code.h"
#include "lixel/report/write_file.h"
#include "lixel/scene/load.h"
#include "output.h"
#include "run_results.h"
#include "sweep/sweep.h"

#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

// `lixel merge`: the shards of a study, put together as one run would have made it.
namespace lixel::app {
namespace {

namespace fs = std::filesystem;

struct MergeOptions
{
    std::vector<std::string> folders;
    std::string output;
    bool withoutTiming = false;
};

// A part, with the file that says where it comes from.
struct Part
{
    fs::path path;
    RowFile file;
};

std::vector<Part> readParts(const std::vector<std::string>& folders)
{
    std::vector<Part> parts;
    for (const std::string& folder : folders) {
        const fs::path path = fs::path(folder) / kRowFileName;
        auto file = readRowFile(path);
        if (!file) throw InputError(path.string() + ": expected the rows of a study, there are none");
        parts.push_back({path, std::move(*file)});
        const SweepPlan &first = parts.front().file.plan, &plan = parts.back().file.plan;
        const std::string other = parts.front().path.string();
        if (plan.hash != first.hash)
            throw InputError(fmt::format("{}: is of another study than {}", path.string(), other));
        if (toJson(plan) != toJson(first))
            throw InputError(fmt::format("{}: has other rows in its plan than {}", path.string(), other));
    }
    return parts;
}

void addRows(const Part& part, std::vector<std::string>& from, RowFile& all)
{
    if (!part.file.doubled.empty())
        throw InputError(fmt::format("{}: has a row twice: {}", part.path.string(), part.file.doubled.front()));
    for (const auto& [number, line] : part.file.rows) {
        const auto [at, isNew] = all.rows.emplace(number, line);
        if (isNew) from[number] = part.path.string();
        else throw InputError(fmt::format("{}: has row {} that {} has too", part.path.string(), number, from[number]));
    }
}

// Where the first of the missing rows should have come from.
std::string hintAbout(std::size_t cell, const std::vector<Part>& parts)
{
    const std::size_t cells = parts.front().file.cells.size();
    for (const Part& part : parts)
        if (part.file.shard.holds(cell, cells))
            return fmt::format("{} is not finished: run its shard {} again", part.path.string(),
                               toString(part.file.shard));
    return "no folder given has the shard that holds it";
}

void expectAll(const RowFile& all, const std::vector<Part>& parts)
{
    std::size_t missing = 0, rows = 0, first = all.cells.size();
    for (std::size_t cell = 0; cell < all.cells.size(); ++cell) {
        rows += all.cells[cell].rows;
        if (all.rows.contains(all.cells[cell].firstRow)) continue;
        missing += all.cells[cell].rows;
        first = std::min(first, cell);
    }
    if (missing == 0) return;
    throw InputError(fmt::format("{} of {} rows are missing, first \"{}\"; {}", missing, rows,
                                 all.plan.keyOf(all.cells[first], 0), hintAbout(first, parts)));
}

int runMerge(const MergeOptions& options, const std::string& commandLine)
{
    if (options.output.empty() || options.output == "-") throw UsageError("merge: give -o FOLDER for the whole");
    const Stopwatch total;
    const std::vector<Part> parts = readParts(options.folders);
    const RowFile& first = parts.front().file;
    RowFile all{first.plan, first.cells, {}, {}, 0, {}};
    std::vector<std::string> from(all.cells.empty() ? 0 : all.cells.back().firstRow + all.cells.back().rows);
    for (const Part& part : parts) addRows(part, from, all);
    expectAll(all, parts);

    const OutputFolder folder(options.output);
    std::string text = headLine(all.plan, all.shard);
    for (const auto& [number, line] : all.rows) text.append(line).append("\n");
    const fs::path path = folder.path() / kRowFileName;
    for (const Part& part : parts)
        if (std::error_code error; fs::equivalent(part.path, path, error))
            throw UsageError("merge -o " + options.output + ": is one of the folders to merge");
    writeFileAtomically(path, text);
    writeSweepResults(folder.path(), {all, commandLine, "", total.seconds(), !options.withoutTiming});
    fmt::print("{}: {} rows of {} folders, {} refused\nreport: {}\n", all.plan.study, all.rows.size(), parts.size(),
               refusedIn(all), (folder.path() / "report.html").string());
    return kDone;
}

} // namespace

Command addMerge(CLI::App& parent, const std::string& commandLine)
{
    auto o = std::make_shared<MergeOptions>();
    CLI::App* app = parent.add_subcommand("merge", "shards of a study, put together as one run would have made it");
    app->add_option("FOLDER", o->folders, "those that `lixel study FILE --shard k/n` wrote to")->required();
    app->add_option("-o,--output", o->output, "folder for rows.jsonl, results.jsonl, results.csv and report.html");
    app->add_flag("--no-timing", o->withoutTiming, "results without times and machines");
    return {app, [o, commandLine] { return runMerge(*o, commandLine); }};
}

} // namespace lixel::app
