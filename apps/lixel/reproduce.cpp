// SPDX-License-Identifier: MIT
#include "commands.h"
#include "exit_code.h"
#include "experiment.h"
#include "option_checks.h"
#include "output.h"
#include "run_results.h"

#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

// `lixel reproduce`: the papers' experiments by name, the paper's numbers beside ours.
namespace lixel::app {
namespace {

struct ReproduceOptions
{
    std::string name, json;
    ExperimentOptions experiment;
};

void printList()
{
    for (const Experiment& experiment : experiments())
        fmt::print("{}\n  {}\n  {}\n", experiment.name, experiment.question, experiment.paper);
}

void printNumbers(const Reproduction& reproduction, std::FILE* to)
{
    fmt::print(to, "{}: {}\n{}\n", reproduction.name, reproduction.question, reproduction.paper);
    for (const auto& [name, value] : reproduction.parameters) fmt::print(to, "  {} = {}\n", name, value);
    fmt::print(to, "{:<52} {:>12} {:>12}  {}\n", "", "ours", "paper", "");
    for (const ReproducedNumber& n : reproduction.numbers)
        fmt::print(to, "{:<52} {:>12.4f} {:>12}  {}\n", n.key, n.ours,
                   n.papers ? fmt::format("{:.4f}", *n.papers) : "-", n.source);
}

int runReproduce(const ReproduceOptions& options, const std::string& commandLine)
{
    if (options.name.empty()) {
        printList();
        return kDone;
    }
    for (const Experiment& experiment : experiments()) {
        if (experiment.name != options.name) continue;
        if (!options.json.empty()) expectWritable(options.json);
        const Stopwatch total;
        Reproduction reproduction = experiment.run(options.experiment);
        reproduction.name = experiment.name;
        reproduction.paper = experiment.paper;
        reproduction.question = experiment.question;
        reproduction.isQuick = options.experiment.isQuick;
        reproduction.run.seed = options.experiment.seed;
        finishResults(reproduction.run, commandLine, total.seconds(), reproduction.run.timing.host);
        if (!options.json.empty()) writeOrPrint(options.json, toJson(reproduction));
        printNumbers(reproduction, options.json == "-" ? stderr : stdout);
        return kDone;
    }
    std::string known;
    for (const Experiment& experiment : experiments())
        known += fmt::format("{}{}", known.empty() ? "" : ", ", experiment.name);
    throw UsageError(fmt::format("reproduce \"{}\": no such experiment (known: {})", options.name, known));
}

} // namespace

Command addReproduce(CLI::App& parent, const std::string& commandLine)
{
    auto o = std::make_shared<ReproduceOptions>();
    CLI::App* app = parent.add_subcommand("reproduce", "the papers' experiments; without a name, the list of them");
    app->add_option("NAME", o->name, "which");
    app->add_flag("--quick", o->experiment.isQuick, "fewer cases, the same question");
    app->add_option("--seed", o->experiment.seed, "of everything random")->check(wholeNumber())->capture_default_str();
    app->add_option("--executor", o->experiment.executor, "gl or trace")
        ->check(CLI::IsMember({"gl", "trace"}))
        ->capture_default_str();
    app->add_option("--json", o->json, "numbers and rows as JSON to this file, or - for standard output");
    return {app, [o, commandLine] { return runReproduce(*o, commandLine); }};
}

} // namespace lixel::app
