// SPDX-License-Identifier: MIT
#include "experiments/now_race.h"

#include "experiments/enlarged_square.h"
#include "lixel/base/median.h"
#include "lixel/report/png.h"
#include "lixel/scene/framing.h"
#include "run_results.h"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <optional>

#include <fmt/format.h>

namespace lixel::app {
namespace {

constexpr int kTimingFrames = 5, kQuickTimingFrames = 1;

std::string techniqueList()
{
    std::string list;
    for (const NowMethod& method : kNowMethods) list += fmt::format("{},", method.technique);
    return list + "shadow-volumes";
}

// What deciding takes on the processor, of a few plans, and the frame on the device, which makes warps itself where it can.
struct MethodTimes
{
    double planMs = 0;
    RowTiming frame;
};

MethodTimes timesOf(const TechniqueChoice& choice, const PlanSubject& subject, const LixelBudget& lixels,
                    Executor& executor, int frames)
{
    std::vector<double> planMs;
    std::optional<FramePlan> plan;
    std::optional<WarpLayout> layout;
    for (int i = 0; i < frames; ++i) {
        const auto start = std::chrono::steady_clock::now();
        layout = warpLayoutFor(choice, subject, lixels);
        if (!layout) plan = planFor(choice, subject, lixels, executor);
        planMs.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    TimedExtras extras{{}, subject.lights};
    if (layout) extras.warps = layout->fills;
    const FramePlan& timed = layout ? layout->plan : *plan;
    return {median(planMs), executor.time(subject.stage, timed, subject.view, frames, extras)};
}

void add(const Measurement& m, const RowTiming& frame, double planMs, NowOutcome& sum)
{
    sum.misclassified += double(m.misclassified), sum.lightFacing += double(m.lightFacing);
    sum.planMs += planMs;
    sum.frameMs += frame.frameMs.value_or(0);
    for (const PassTime& pass : frame.passes) sum.passMs[pass.name] += pass.ms;
}

} // namespace

NowRace::NowRace(const ExperimentOptions& options) : options_(options), scenes_(nowScenes(options, leftOut_))
{
    executors_.push_back(makeExecutor(options.executor));
    comparison_.techniques = readTechniques(techniqueList());
    comparison_.lixels.total = options.isQuick ? LixelSize{128, 128} : LixelSize{512, 512};
    comparison_.timingFrames = 0; // apart, below
    comparison_.pictures = options.pictures;
}

void NowRace::run(std::span<const char* const> paperNames)
{
    const auto isWanted = [&](const NowScene& scene) {
        return paperNames.empty() ||
               std::find(paperNames.begin(), paperNames.end(), std::string_view(scene.paperName)) != paperNames.end();
    };
    std::erase_if(scenes_, [&](const NowScene& scene) { return !isWanted(scene); });
    const auto pictures = std::accumulate(scenes_.begin(), scenes_.end(), std::size_t{0},
                                          [](std::size_t sum, const NowScene& s) { return sum + s.pictures.size(); });
    Progress progress("reproduce", int(pictures));
    for (const NowScene& scene : scenes_)
        for (std::size_t i = 0; i < scene.pictures.size(); ++i) {
            progress.step(fmt::format("{}, picture {}", scene.file, i + 1));
            addPicture(scene, scene.pictures[i], i);
        }
}

void NowRace::addPicture(const NowScene& scene, const PictureOptions& picture, std::size_t number)
{
    Shooting shooting = prepare(picture, false);
    Shot& shot = shooting.shots.front();
    if (picture.view.empty()) shot.name = fmt::format("{}-{}", scene.title(), number + 1); // apart from other scenes'
    shot.lights.resize(1);
    const Stage stage = makeStage(shooting.scene, shooting.evaluateOptions, originOf(shooting, shot));
    const View view = viewOf(shooting, shot);
    const ViewSamples samples = executors_.front()->viewSamples(stage, view);
    const Truth truth = findTruth(stage, samples, shot.lights, shooting.planes);
    std::vector<ResultRow> rows = compareTechniques({shooting, shot, stage, view, samples, truth, comparison_},
                                                    executors_, [](std::string_view) {});
    const bool areAllServed =
        std::all_of(rows.begin(), rows.end() - 1, [](const ResultRow& row) { return row.measured(); });
    refusedPictures_ += !areAllServed;
    const int frames = options_.isQuick ? kQuickTimingFrames : kTimingFrames;
    if (const Measurement* volumes = areAllServed ? rows.back().measured() : nullptr)
        add(*volumes, executors_.front()->timeVolumes(stage, view, shot.lights, frames, true), 0,
            volumes_[scene.paperName]);
    else if (areAllServed) withoutVolumes_.insert(scene.paperName);
    const PlanSubject subject{stage, view, shot.lights, shooting.planes, samples};
    for (std::size_t method = 0; areAllServed && method < kNowMethods.size(); ++method) {
        const MethodTimes times =
            timesOf(comparison_.techniques[method], subject, comparison_.lixels, *executors_.front(), frames);
        add(*rows[method].measured(), times.frame, times.planMs, outcomes_[scene.paperName][method]);
    }
    if (areAllServed && !options_.pictures.empty()) {
        PictureRow figure{fmt::format("{}: {}", scene.paperName, shot.name),
                          rows.front().scene,
                          rows.front().view,
                          rows.front().light,
                          {}};
        for (const NowMethod& method : kNowMethods) figure.techniques.push_back(method.technique);
        figure.layer = PictureLayer::Error;
        const std::vector<int> everywhere(samples.size(), 0); // planes do not matter here
        enlargeWhereMostIsWrong(readPng(options_.pictures / rows[NowRtw].measured()->pictures.error), samples,
                                everywhere, figure);
        out_.figures.push_back(std::move(figure));
    }
    for (ResultRow& row : rows) {
        row.seed = options_.seed;
        out_.run.rows.push_back(std::move(row));
    }
}

const NowOutcome* NowRace::volumesOf(const NowScene& scene) const
{
    const auto found = volumes_.find(scene.paperName);
    return found == volumes_.end() || withoutVolumes_.contains(scene.paperName) ? nullptr : &found->second;
}

Reproduction NowRace::finished()
{
    out_.run.timing.host = executors_.front()->host();
    out_.parameters = {{"size", options_.isQuick ? "256x256" : "1024x1024"},
                       {"lixels", toString(comparison_.lixels)},
                       {"executor", options_.executor},
                       {"pictures that some method refuses, not counted", fmt::format("{}", refusedPictures_)},
                       {"seed", fmt::format("{}", options_.seed)}};
    for (const NowMethod& method : kNowMethods) out_.parameters.push_back({method.title, method.technique});
    out_.parameters.push_back({"SV", "shadow-volumes"});
    for (const std::string& scene : withoutVolumes_)
        out_.parameters.push_back({scene + ", SV", "refused, as the rows say"});
    if (!leftOut_.empty())
        out_.parameters.push_back({"scenes left out, since they are not in the folder that --scenes names", leftOut_});
    return std::move(out_);
}

} // namespace lixel::app
