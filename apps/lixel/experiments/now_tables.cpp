// SPDX-License-Identifier: MIT
#include "experiments/now_race.h"

#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

// Milet, Navratil and Zemcik 2015, Tables 1 to 3: times of the methods against each other, of one run, and what the paper shows as red
// pixels only: how many samples each gets wrong. Pictures of 1024x1024, maps of 512x512.
namespace lixel::app {
namespace {

constexpr const char* kOutdoors[] = {"Observatory"};
constexpr double kPaperVolumesMs = 8.750; // Table 1, SV

void addErrors(const NowRace& race, const NowScene& scene, Reproduction& out)
{
    const NowOutcomes& outcomes = race.of(scene);
    for (std::size_t i = 0; i < kNowMethods.size(); ++i)
        out.numbers.push_back(
            {fmt::format("{} ({}): {}, misclassified", scene.title(), scene.paperName, kNowMethods[i].title), "percent",
             outcomes[i].percent(), std::nullopt, "shown as red pixels"});
    if (const NowOutcome* volumes = race.volumesOf(scene))
        out.numbers.push_back({fmt::format("{} ({}): SV, misclassified", scene.title(), scene.paperName), "percent",
                               volumes->percent(), 0.0, "section 4: the ground truth"});
}

// Passes that every method has alike: the view with its surfaces.
bool isOfView(std::string_view pass) { return pass == "view" || pass == "gather"; }

double shadowMs(const NowOutcome& outcome)
{
    double sum = outcome.planMs;
    for (const auto& [name, ms] : outcome.passMs) sum += isOfView(name) ? 0 : ms;
    return sum;
}

// Table 2's steps.
struct Steps
{
    double desiredView = 0, importance = 0, shadowMap = 0, finalPass = 0; // ms
    double sum() const { return desiredView + importance + shadowMap + finalPass; }
};

Steps stepsOf(const NowOutcome& outcome, const NowOutcome& withoutWarp)
{
    Steps steps;
    steps.desiredView = std::min(outcome.planMs, withoutWarp.planMs);
    steps.importance = outcome.planMs - steps.desiredView; // with the functions
    for (const auto& [name, ms] : outcome.passMs) {
        if (isOfView(name)) continue;
        (name == "light depth"                 ? steps.shadowMap
         : name == "lookup" || name == "shade" ? steps.finalPass
                                               : steps.importance) += ms;
    }
    return steps;
}

struct PaperSteps
{
    const char* scene;
    double oursDesiredView, oursImportance, oursMap, oursFinal, rtwBoth, rtwMap, rtwFinal; // percent
};
constexpr PaperSteps kPaperSteps[] = {{"Conf. room", 13.9, 68.4, 14.4, 3.3, 89.1, 7.3, 3.5},
                                      {"Sponza", 15.4, 61.0, 19.9, 3.7, 82.5, 14.1, 3.2},
                                      {"Observatory", 18.4, 69.0, 8.2, 4.4, 86.8, 9.3, 3.8}};

struct PaperTimes
{
    const char* scene;
    double volumes, sm, rtw, ours; // ms, without the G-buffer
};
constexpr PaperTimes kPaperTimes[] = {{"Conf. room", 9.64, 0.21, 3.14, 3.63},
                                      {"Sponza", 18.41, 0.40, 3.47, 3.84},
                                      {"Observatory", 14.96, 0.16, 3.02, 3.23}};

template <typename Row, std::size_t N>
const Row& rowFor(const Row (&rows)[N], std::string_view scene)
{
    for (const Row& row : rows)
        if (row.scene == scene) return row;
    return rows[0];
}

void addSteps(const NowScene& scene, const NowOutcomes& all, Reproduction& out)
{
    const PaperSteps& paper = rowFor(kPaperSteps, scene.paperName);
    const auto add = [&](std::string_view method, std::string_view step, double share, std::optional<double> papers) {
        out.timingNumbers.push_back({fmt::format("{}: {}, {}", scene.title(), method, step), "percent", 100 * share,
                                     papers, papers ? "Table 2" : ""});
    };
    const auto addMethod = [&](std::size_t method, bool isRtw, bool hasPaper) {
        const Steps steps = stepsOf(all[method], all[NowOursDv]);
        const double sum = steps.sum();
        const char* const title = kNowMethods[method].title;
        const auto papers = [&](double value) { return hasPaper ? std::optional(value) : std::nullopt; };
        if (isRtw) {
            add(title, "desired view and importance map", (steps.desiredView + steps.importance) / sum,
                papers(paper.rtwBoth));
        } else {
            add(title, "desired view", steps.desiredView / sum, papers(paper.oursDesiredView));
            add(title, "importance map", steps.importance / sum, papers(paper.oursImportance));
        }
        add(title, "shadow map", steps.shadowMap / sum, papers(isRtw ? paper.rtwMap : paper.oursMap));
        add(title, "final pass", steps.finalPass / sum, papers(isRtw ? paper.rtwFinal : paper.oursFinal));
    };
    addMethod(NowOurs, false, true);
    addMethod(NowRtw, true, true);
    addMethod(NowOfLixel, false, false);
}

} // namespace

Reproduction reproduceNowTable1(const ExperimentOptions& options)
{
    NowRace race(options);
    race.run(kOutdoors);
    Reproduction out = race.finished();
    for (const NowScene& scene : race.scenes()) {
        if (!race.has(scene)) continue;
        const NowOutcomes& all = race.of(scene);
        addErrors(race, scene, out);
        for (std::size_t i = 1; i < kNowMethods.size(); ++i)
            out.timingNumbers.push_back({fmt::format("{} over SM, frame with its plan", kNowMethods[i].title), "ratio",
                                         all[i].wholeMs() / all[NowSm].wholeMs(),
                                         kNowMethods[i].tableOneMs > 0
                                             ? std::optional(kNowMethods[i].tableOneMs / kNowMethods[NowSm].tableOneMs)
                                             : std::nullopt,
                                         "Table 1"});
        if (const NowOutcome* volumes = race.volumesOf(scene))
            out.timingNumbers.push_back({"SV over SM, frame", "ratio", volumes->wholeMs() / all[NowSm].wholeMs(),
                                         kPaperVolumesMs / kNowMethods[NowSm].tableOneMs, "Table 1"});
        for (std::size_t i = 0; i < kNowMethods.size(); ++i) {
            out.timingNumbers.push_back({fmt::format("{}: frame", kNowMethods[i].title), "ms, of all pictures",
                                         all[i].frameMs, std::nullopt, ""});
            out.timingNumbers.push_back({fmt::format("{}: plan", kNowMethods[i].title), "ms, of all pictures",
                                         all[i].planMs, std::nullopt, ""});
        }
    }
    return out;
}

Reproduction reproduceNowTable2(const ExperimentOptions& options)
{
    NowRace race(options);
    race.run();
    Reproduction out = race.finished();
    for (const NowScene& scene : race.scenes())
        if (race.has(scene)) addSteps(scene, race.of(scene), out);
    return out;
}

Reproduction reproduceNowTable3(const ExperimentOptions& options)
{
    NowRace race(options);
    race.run();
    Reproduction out = race.finished();
    for (const NowScene& scene : race.scenes()) {
        if (!race.has(scene)) continue;
        const NowOutcomes& all = race.of(scene);
        const PaperTimes& paper = rowFor(kPaperTimes, scene.paperName);
        addErrors(race, scene, out);
        const auto ratio = [&](std::size_t a, std::size_t b, std::optional<double> papers) {
            out.timingNumbers.push_back({fmt::format("{}: {} over {}, shadows alone", scene.title(),
                                                     kNowMethods[a].title, kNowMethods[b].title),
                                         "ratio", shadowMs(all[a]) / shadowMs(all[b]), papers,
                                         papers ? "Table 3" : ""});
        };
        if (const NowOutcome* volumes = race.volumesOf(scene)) {
            out.timingNumbers.push_back({fmt::format("{}: SV over SM, shadows alone", scene.title()), "ratio",
                                         shadowMs(*volumes) / shadowMs(all[NowSm]), paper.volumes / paper.sm,
                                         "Table 3"});
            out.timingNumbers.push_back({fmt::format("{}: Ours over SV, shadows alone", scene.title()), "ratio",
                                         shadowMs(all[NowOurs]) / shadowMs(*volumes), paper.ours / paper.volumes,
                                         "Table 3"});
        }
        ratio(NowRtw, NowSm, paper.rtw / paper.sm);
        ratio(NowOurs, NowSm, paper.ours / paper.sm);
        ratio(NowOurs, NowRtw, paper.ours / paper.rtw);
        ratio(NowOfLixel, NowSm, std::nullopt);
        ratio(NowOfLixel, NowRtw, std::nullopt);
    }
    return out;
}

} // namespace lixel::app
