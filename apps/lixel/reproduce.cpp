// SPDX-License-Identifier: MIT
#include "commands.h"
#include "exit_code.h"
#include "experiment.h"
#include "experiments/claims.h"
#include "lixel/report/html.h"
#include "lixel/report/reproductions.h"
#include "lixel/report/write_file.h"
#include "option_checks.h"
#include "output.h"
#include "run_results.h"

#include <cstdio>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

// `lixel reproduce`: the papers' experiments by name, the paper's numbers beside ours.
namespace lixel::app {
namespace {

constexpr int kMostLights = 100'000;

struct ReproduceOptions
{
    std::string name, json, output;
    ExperimentOptions experiment;
};

void printList()
{
    for (const Experiment& experiment : experiments())
        fmt::print("{}\n  {}\n  {}\n", experiment.name, experiment.question, experiment.paper);
}

// "3774.1 (3772.1)" in the first column, "+27.7 (+27.7)" in others: ours, the paper's in parentheses.
std::string cellText(const ReproducedTable::Row& row, std::size_t column)
{
    const auto text = [&](std::optional<double> value) {
        return !value ? "" : column == 0 ? fmt::format("{:.1f}", *value) : fmt::format("{:+.1f}", *value);
    };
    const ReproducedTable::Cell& cell = row.cells[column];
    const std::string ours = text(column == 0 ? cell.ours : percentMore(row, column));
    const std::string papers = text(column == 0 ? cell.papers : papersPercentMore(row, column));
    return papers.empty() ? ours : fmt::format("{} ({})", ours, papers);
}

// Methods below each other, which are many; of the rows those that the paper has. The report has all.
void printTable(const ReproducedTable& table, std::FILE* to)
{
    std::vector<const ReproducedTable::Row*> shown;
    for (const auto& row : table.rows)
        if (row.cells.front().papers) shown.push_back(&row);
    fmt::print(to, "{}: {}, then percent more than {} (the paper's, {})\n", table.title, table.unit,
               table.columns.front().title, table.source);
    fmt::print(to, "{:<24}", "");
    for (const auto* row : shown) fmt::print(to, " {:>20}", row->title);
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
        fmt::print(to, "\n{:<24}", table.columns[column].title);
        for (const auto* row : shown) fmt::print(to, " {:>20}", cellText(*row, column));
    }
    fmt::print(to, "\n");
}

void printNumbers(const Reproduction& reproduction, std::FILE* to)
{
    fmt::print(to, "{}: {}\n{}\n", reproduction.name, reproduction.question, reproduction.paper);
    for (const auto& [name, value] : reproduction.parameters) fmt::print(to, "  {} = {}\n", name, value);
    for (const ReproducedTable& table : reproduction.tables) printTable(table, to);
    fmt::print(to, "{:<58} {:>12} {:>12}  {}\n", "", "ours", "paper", "");
    for (const auto* numbers : {&reproduction.numbers, &reproduction.timingNumbers})
        for (const ReproducedNumber& n : *numbers)
            fmt::print(to, "{:<58} {:>12.4f} {:>12}  {}\n", n.key, n.ours,
                       n.papers ? fmt::format("{:.4f}", *n.papers) : "-", n.source);
}

void printClaims(const std::vector<ReproducedClaim>& claims, std::FILE* to)
{
    for (const ReproducedClaim& claim : claims)
        fmt::print(to, "{} \"{}\" ({}): {}\n",
                   !claim.holds   ? "open:     "
                   : *claim.holds ? "holds:    "
                                  : "holds not:",
                   claim.sentence, claim.source, claim.measured);
}

void expectTakes(const Experiment& experiment, const ExperimentOptions& asked)
{
    if (!experiment.isOfLights && (asked.lights || asked.size || asked.lixels))
        throw UsageError(
            fmt::format("reproduce {}: --lights, --size and --lixels are for experiments with many lights in one view",
                        experiment.name));
}

Reproduction reproduced(const Experiment& experiment, ExperimentOptions asked, const std::string& commandLine)
{
    if (asked.executor.empty()) asked.executor = experiment.executor;
    const Stopwatch total;
    Reproduction reproduction = experiment.run(asked);
    reproduction.name = experiment.name;
    reproduction.paper = experiment.paper;
    reproduction.question = experiment.question;
    reproduction.isQuick = asked.isQuick;
    reproduction.run.seed = asked.seed;
    reproduction.claims = claimsOf(experiment.name, reproduction);
    finishResults(reproduction.run, commandLine, total.seconds(), reproduction.run.timing.host);
    return reproduction;
}

void writeInto(ReportFolder& report, const Reproduction& reproduction)
{
    writeFileAtomically(report.writeTo() / "results.json", toJson(reproduction));
    writeReport(report.writeTo(), reproduction);
    report.finish();
}

int runOne(const Experiment& experiment, const ReproduceOptions& options, const std::string& commandLine)
{
    if (options.output == "-") throw UsageError("reproduce -o -: expected the name of a folder");
    ExperimentOptions asked = options.experiment;
    expectTakes(experiment, asked);
    std::optional<ReportFolder> report;
    if (!options.output.empty()) {
        report.emplace(options.output, true);
        asked.pictures = report->writeTo();
    }
    if (!options.json.empty()) expectWritable(options.json);
    const Reproduction reproduction = reproduced(experiment, asked, commandLine);
    if (!options.json.empty()) writeOrPrint(options.json, toJson(reproduction));
    std::FILE* const told = options.json == "-" ? stderr : stdout;
    if (report) writeInto(*report, reproduction);
    printNumbers(reproduction, told);
    printClaims(reproduction.claims, told);
    if (report) fmt::print(told, "report: {}\n", (std::filesystem::path(options.output) / "report.html").string());
    return kDone;
}

// One after the other, each into a folder of its name. What cannot be run here is left out, with the reason.
int runAll(const ReproduceOptions& options, const std::string& commandLine)
{
    const ExperimentOptions& given = options.experiment;
    if (options.output.empty() || options.output == "-")
        throw UsageError("reproduce all: give -o FOLDER for the reports");
    if (given.lights || given.size || given.lixels || !given.executor.empty())
        throw UsageError("reproduce all: --lights, --size, --lixels and --executor are of single experiments");
    const OutputFolder folder(options.output);
    if (!options.json.empty()) expectWritable(options.json);
    std::FILE* const told = options.json == "-" ? stderr : stdout;
    const Stopwatch total;
    Reproductions all{LIXEL_VERSION, commandLine, given.isQuick, {}, {}};
    std::string host;
    for (const Experiment& experiment : experiments()) {
        fmt::print(told, "[{}/{}] {}\n", all.entries.size() + 1, experiments().size(), experiment.name);
        std::fflush(told);
        Reproductions::Entry& entry = all.entries.emplace_back(
            Reproductions::Entry{experiment.name, experiment.paper, experiment.question, {}, 0, {}});
        const Stopwatch one;
        try {
            ExperimentOptions asked = given;
            ReportFolder report(folder.path() / experiment.name, true);
            asked.pictures = report.writeTo();
            const Reproduction reproduction = reproduced(experiment, asked, commandLine);
            writeInto(report, reproduction);
            entry.claims = reproduction.claims;
            host = reproduction.run.timing.host;
        } catch (const UsageError& error) { // scenes that are not there
            entry.leftOut = error.what();
            fmt::print(told, "left out: {}\n", entry.leftOut);
        }
        entry.seconds = one.seconds();
        printClaims(entry.claims, told);
    }
    all.timing = timingNow(total.seconds(), host);
    const std::string json = toJson(all);
    writeFileAtomically(folder.path() / "results.json", json);
    if (!options.json.empty()) writeOrPrint(options.json, json);
    writeReport(folder.path(), all);
    fmt::print(told, "report: {}\n", (folder.path() / "report.html").string());
    return kDone;
}

int runReproduce(const ReproduceOptions& options, const std::string& commandLine)
{
    if (options.name.empty()) {
        printList();
        return kDone;
    }
    if (options.name == "all") return runAll(options, commandLine);
    for (const Experiment& experiment : experiments())
        if (experiment.name == options.name) return runOne(experiment, options, commandLine);
    std::string known = "all";
    for (const Experiment& experiment : experiments()) known += fmt::format(", {}", experiment.name);
    throw UsageError(fmt::format("reproduce \"{}\": no such experiment (known: {})", options.name, known));
}

} // namespace

Command addReproduce(CLI::App& parent, const std::string& commandLine)
{
    auto o = std::make_shared<ReproduceOptions>();
    CLI::App* app = parent.add_subcommand("reproduce", "the papers' experiments; without a name, the list of them");
    app->add_option("NAME", o->name, "which; all: one after the other, each into a folder of its name");
    app->add_flag("--quick", o->experiment.isQuick, "fewer cases, the same question");
    app->add_option("--seed", o->experiment.seed, "of everything random")->check(wholeNumber())->capture_default_str();
    app->add_option("--executor", o->experiment.executor, "gl or trace; by default what the experiment is made for")
        ->check(CLI::IsMember({"gl", "trace"}));
    app->add_option("--lights", o->experiment.lights, "how many, where an experiment has many")
        ->check(CLI::Range(1, kMostLights));
    app->add_option("--size", o->experiment.size,
                    "of the picture, WIDTHxHEIGHT pixels, where an experiment has many lights");
    app->add_option("--lixels", o->experiment.lixels,
                    "budget of each light, WIDTHxHEIGHT, where an experiment has many");
    app->add_option("--scenes", o->experiment.scenes,
                    "folder with conference.glb and sponza_crytek.glb, for the experiments that have rooms")
        ->envname("LIXEL_SCENES");
    app->add_option("-o,--output", o->output, "folder for results.json, report.html and the pictures of figures");
    app->add_option("--json", o->json, "numbers and rows as JSON to this file, or - for standard output");
    return {app, [o, commandLine] { return runReproduce(*o, commandLine); }};
}

} // namespace lixel::app
