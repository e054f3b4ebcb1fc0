// SPDX-License-Identifier: MIT
#include "study.h"

#include "commands.h"
#include "exit_code.h"
#include "option_checks.h"
#include "output.h"

#include <array>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

// `lixel study`: questions about the techniques themselves.
namespace lixel::app {
namespace {

int runStudy(const std::string& name, const StudyOptions& options)
{
    if (name.empty()) {
        for (const Study& study : studies()) fmt::print("{}\n  {}\n", study.name, study.question);
        return kDone;
    }
    std::string known;
    for (const Study& study : studies()) {
        if (study.name == name) {
            if (!options.output.empty() && !study.hasReport)
                throw UsageError(fmt::format("study {} -o: it has no report, --json tells what it finds", name));
            if (options.output == "-") throw UsageError("study -o -: expected the name of a folder");
            std::optional<ReportFolder> report;
            if (!options.output.empty()) report.emplace(options.output, false);
            if (!options.json.empty()) expectWritable(options.json);
            return study.run(options);
        }
        known += fmt::format("{}{}", known.empty() ? "" : ", ", study.name);
    }
    throw UsageError(fmt::format("study \"{}\": no such study (known: {})", name, known));
}

} // namespace

std::span<const Study> studies()
{
    static const std::array<Study, 3> kAll{{
        {"one-to-one",
         "How far from the pixel that sees a point of the plane is the lixel that samples it, in plane-optimal maps?",
         false, studyOneToOne},
        {"plane-budget",
         "How does error fall with the lixels of maps for planes, on planes and off them, and where is there none?",
         true, studyPlaneBudget},
        {"scene-optimal-search",
         "How near are the light images that scene-optimal finds to the best of very many, by each metric?", false,
         studySceneOptimalSearch},
    }};
    return kAll;
}

Command addStudy(CLI::App& parent, const std::string& commandLine)
{
    auto name = std::make_shared<std::string>();
    auto o = std::make_shared<StudyOptions>();
    o->commandLine = commandLine;
    CLI::App* app = parent.add_subcommand("study", "questions about the techniques; without a name, the list of them");
    app->add_option("NAME", *name, "which");
    app->add_option("--count", o->count, "how many cases")->check(CLI::Range(1, 100000000));
    app->add_flag("--quick", o->isQuick, "fewer cases, the same question");
    app->add_option("--seed", o->seed, "of everything random")->check(wholeNumber())->capture_default_str();
    app->add_option("--executor", o->executor, "gl or trace")
        ->check(CLI::IsMember({"gl", "trace"}))
        ->capture_default_str();
    app->add_option("-o,--output", o->output, "folder for results.json and report.html");
    app->add_option("--json", o->json, "what was found as JSON to this file, or - for standard output");
    return {app, [name, o] { return runStudy(*name, *o); }};
}

} // namespace lixel::app
