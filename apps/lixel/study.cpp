// SPDX-License-Identifier: MIT
#include "study.h"

#include "commands.h"
#include "exit_code.h"
#include "option_checks.h"
#include "output.h"
#include "sweep/sweep.h"

#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

// `lixel study`: questions about the techniques themselves. Each is a command of its own, with the options that it takes.
namespace lixel::app {
namespace {

constexpr int kMostLights = 100'000;

struct StudyCommand
{
    const Study& study;
    CLI::App* app = nullptr;
    std::shared_ptr<StudyOptions> options;
};

void addOptions(CLI::App& app, const Study& study, StudyOptions& o)
{
    if (study.cases == StudiedCases::Scene) {
        addPictureOptions(app, o.picture);
        app.add_option("--tolerance", o.tolerance, "misclassified percent that a map may have: 0.5% or 0.5")
            ->required();
        app.add_option("--technique", o.technique, "whose maps (lixel techniques)")->capture_default_str();
    } else if (study.cases == StudiedCases::Pictures) {
        addPictureOptions(app, o.picture);
        app.add_option("--lixels", o.lixels, "lixels of a light, in all")->capture_default_str();
    } else if (study.cases == StudiedCases::Views) {
        app.add_option("--count", o.count, "views of each scene, at most")->check(CLI::Range(1, 1000));
        app.add_flag("--quick", o.isQuick, "a view of each scene, small, the same question");
        app.add_option("--timing-frames", o.timingFrames, "frames of each that are timed; 0: none")
            ->check(CLI::Range(0, 1000))
            ->capture_default_str();
    } else {
        if (study.cases == StudiedCases::Lights)
            app.add_option("--lights", o.count, "how many lights")->check(CLI::Range(1, kMostLights));
        else app.add_option("--count", o.count, "how many cases")->check(CLI::Range(1, 100000000));
        app.add_flag("--quick", o.isQuick, "fewer cases, the same question");
        app.add_option("--seed", o.seed, "of everything random")->check(wholeNumber())->capture_default_str();
    }
    app.add_option("--executor", o.executor, "gl or trace")
        ->check(CLI::IsMember({"gl", "trace"}))
        ->capture_default_str();
    if (study.hasReport) app.add_option("-o,--output", o.output, "folder for results.json and report.html");
    app.add_option("--json", o.json, "what was found as JSON to this file, or - for standard output");
}

int runStudy(const StudyCommand& command)
{
    const StudyOptions& options = *command.options;
    if (options.output == "-") throw UsageError("study -o -: expected the name of a folder");
    std::optional<ReportFolder> report;
    if (!options.output.empty()) report.emplace(options.output, false);
    if (!options.json.empty()) expectWritable(options.json);
    return command.study.run(options);
}

// A file's name has a / or a .; what else it may be, no study has that name.
bool isFile(const std::string& name) { return name.find_first_of("/.") != name.npos; }

int listOrRefuse(const std::string& name)
{
    std::string known;
    for (const Study& study : studies()) {
        if (name.empty()) fmt::print("{}\n  {}\n", study.name, study.question);
        known += fmt::format("{}{}", known.empty() ? "" : ", ", study.name);
    }
    if (!name.empty())
        throw UsageError(
            fmt::format("study \"{}\": no such study (known: {}); a file's name has a / or a .", name, known));
    fmt::print("FILE.json\n  A study of your own: scenes, views, lights, techniques, budgets and sizes "
               "(docs/studies.md).\n");
    return kDone;
}

} // namespace

std::span<const Study> studies()
{
    static const std::array<Study, 8> kAll{{
        {"one-to-one",
         "How far from the pixel that sees a point of the plane is the lixel that samples it, in plane-optimal maps?",
         StudiedCases::Counted, false, studyOneToOne},
        {"plane-budget",
         "How does error fall with the lixels of maps for planes, on planes and off them, and where is there none?",
         StudiedCases::Counted, true, studyPlaneBudget},
        {"resolution",
         "How small may the maps of a scene's lights be for errors under a tolerance, and how small focused ones?",
         StudiedCases::Scene, false, studyResolution},
        {"scene-optimal-metrics", "Which metric of scene-optimal predicts the measured errors of maps best?",
         StudiedCases::Lights, false, studySceneOptimalMetrics},
        {"scene-optimal-search",
         "How near are the light images that scene-optimal finds to the best of very many, by each metric?",
         StudiedCases::Counted, false, studySceneOptimalSearch},
        {"scene-optimal-sensitivity", "How do the errors of scene-optimal change with each of its parameters?",
         StudiedCases::Lights, false, studySceneOptimalSensitivity},
        {"warps", "How do the errors of texture warps change with each of their parameters, and how even are they?",
         StudiedCases::Pictures, false, studyWarps},
        {"lookups",
         "What do the errors of every lookup cost in bytes and in time, over the built-in scenes, and which does none "
         "beat?",
         StudiedCases::Views, true, studyLookups},
    }};
    return kAll;
}

Command addStudy(CLI::App& parent, const std::string& commandLine)
{
    auto sweep = std::make_shared<SweepOptions>();
    sweep->commandLine = commandLine;
    auto commands = std::make_shared<std::vector<StudyCommand>>();
    CLI::App* app = parent.add_subcommand(
        "study", "questions about the techniques: by name, or by a file of your own; without either, the list of them");
    app->require_subcommand(0, 1);
    addSweepOptions(*app, *sweep);
    for (const Study& study : studies()) {
        auto options = std::make_shared<StudyOptions>();
        options->commandLine = commandLine;
        CLI::App* own = app->add_subcommand(study.name, study.question);
        addOptions(*own, study, *options);
        commands->push_back({study, own, std::move(options)});
    }
    return {app, [app, sweep, commands] {
                for (const StudyCommand& command : *commands)
                    if (command.app->parsed()) return runStudy(command);
                if (isFile(sweep->file)) return runSweep(*sweep);
                if (sweep->file.empty() && app->count_all() > 1)
                    throw UsageError("study: its options are for a FILE (lixel study --help)");
                return listOrRefuse(sweep->file);
            }};
}

} // namespace lixel::app
