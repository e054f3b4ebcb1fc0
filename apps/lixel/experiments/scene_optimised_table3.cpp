// SPDX-License-Identifier: MIT
#include "experiments/scene_optimised_loops.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

// Chong and Gortler 2007, Table 3: where the time of a frame goes, for four lights and maps of 750x750. Normal maps of this
// section are limited to the view's frustum, that is, focused.
namespace lixel::app {
namespace {

constexpr int kLights = 4, kMap = 750;
constexpr int kPassFrames = 12, kQuickPassFrames = 6; // whole rounds of three

struct Profile
{
    double total, optimisation, hull, render; // ms
};
constexpr Profile kPaperOptimal{56.0, 6.96, 1.10, 49.03}, kPaperNormal{41.4, 0.16, 0.16, 41.23};

class Table3
{
public:
    explicit Table3(const ExperimentOptions& options)
        : experiment_(options, 3), progress_("reproduce", experiment_.stepsOf(3, passFrames()))
    {
    }
    Reproduction run();

private:
    int passFrames() const { return experiment_.isQuick() ? kQuickPassFrames : kPassFrames; }
    // `hull`: of a frame, ms.
    void addProfile(const std::string& name, const LoopTimes& times, double hull, const std::optional<Profile>& paper);

    LoopExperiment experiment_;
    Progress progress_;
    std::vector<ReproducedNumber> times_;
};

void Table3::addProfile(const std::string& name, const LoopTimes& times, double hull,
                        const std::optional<Profile>& paper)
{
    const double total = mean(times.frameMs), planning = mean(times.planMs);
    const auto add = [&](const char* stage, double ms, double Profile::*papers) {
        const char* const source = paper ? "Table 3" : "";
        const auto paperMs = paper ? std::optional((*paper).*papers) : std::nullopt;
        const auto paperPercent = paper ? std::optional(100 * *paperMs / paper->total) : std::nullopt;
        times_.push_back({fmt::format("{}: {}", name, stage), "ms", ms, paperMs, source});
        times_.push_back({fmt::format("{}: {}, share", name, stage), "percent of the frame", 100 * ms / total,
                          paperPercent, source});
    };
    add("total scene", total, &Profile::total);
    add("optimisation", planning, &Profile::optimisation);
    add("convex hull, which is part of it", hull, &Profile::hull);
    add("render and wait", total - planning, &Profile::render);
    const double longest = *std::max_element(times.planMs.begin(), times.planMs.end());
    times_.push_back({fmt::format("{}: optimisation, longest", name), "ms", longest, {}, ""});
    for (const PassTime& pass : times.passes)
        times_.push_back({fmt::format("{}: pass \"{}\", of frames apart", name, pass.name), "ms", pass.ms, {}, ""});
}

Reproduction Table3::run()
{
    const LixelSize lixels = experiment_.map(kMap);
    const std::array<TimedLoop, 3> loops{LoopExperiment::loop(kOptimal, lixels), LoopExperiment::loop(kFocused, lixels),
                                         LoopExperiment::loop(kOurs, lixels)};
    const std::vector<Light> suns = sunsAround(kLights);
    const std::vector<LoopTimes> times = experiment_.time(loops, suns, passFrames(), progress_);
    const Judged percent = experiment_.judge(loops, times, suns, 1);
    const double hull = experiment_.hullMs(suns, lixels);
    addProfile("optimal", times[0], hull, kPaperOptimal);
    addProfile("normal", times[1], mean(times[1].planMs), kPaperNormal); // its planning is all hull and frustum
    addProfile("ours", times[2], hull, std::nullopt);
    const TimeRatio optimal = timeRatio(times[0], times[1]), ours = timeRatio(times[2], times[1]);
    times_.push_back({"optimal over normal, mean", "ratio of frame times", optimal.mean,
                      kPaperOptimal.total / kPaperNormal.total, "Table 3"});
    times_.push_back({"optimal over normal, worst frame", "ratio of frame times", optimal.worst, {}, ""});
    times_.push_back({"ours over normal, mean", "ratio of frame times", ours.mean, {}, ""});
    times_.push_back({"ours over normal, worst frame", "ratio of frame times", ours.worst, {}, ""});
    Reproduction out = experiment_.finished();
    out.parameters.insert(out.parameters.end(), {{"optimal", kOptimal},
                                                 {"normal", kFocused},
                                                 {"ours", kOurs},
                                                 {"lights", fmt::format("{}", kLights)},
                                                 {"lixels", toString(lixels)}});
    out.numbers = {{"optimal over normal, misclassified of the last frame", "ratio", percent[0] / percent[1], {}, ""},
                   {"ours over normal, misclassified of the last frame", "ratio", percent[2] / percent[1], {}, ""}};
    out.timingNumbers = std::move(times_);
    return out;
}

} // namespace

Reproduction reproduceSceneOptimisedTable3(const ExperimentOptions& options) { return Table3(options).run(); }

} // namespace lixel::app
