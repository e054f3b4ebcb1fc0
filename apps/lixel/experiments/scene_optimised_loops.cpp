// SPDX-License-Identifier: MIT
#include "experiments/scene_optimised_loops.h"

#include "exit_code.h"
#include "lixel/plan/observe.h"
#include "planning_time.h"
#include "run_results.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace lixel::app {
namespace {

struct Sizes
{
    const char* scene;
    const char* picture;
    int frames;
    double mapShare; // of the paper's, a side
};
constexpr Sizes kPaperSizes{"objects", "1150x1150", 60, 1};
constexpr Sizes kQuickSizes{"objects(count=2)", "230x230", 12, 0.2};

constexpr double kPathBegins = 4; // seconds; there the path comes down to the objects
constexpr double kFramesPerSecond = 30;
constexpr double kGoldenAngle = 2.399963229728653;
constexpr int kReadbackFrames = 15;
constexpr int kHullPlans = 31;
constexpr std::size_t kDensityStep = 16; // samples

const Sizes& sizesOf(bool isQuick) { return isQuick ? kQuickSizes : kPaperSizes; }

PathShooting walk(const ExperimentOptions& options)
{
    if (options.executor != "gl")
        throw UsageError(
            fmt::format("--executor {}: the experiment times frames of the gl executor", options.executor));
    PictureOptions picture;
    picture.scene = sizesOf(options.isQuick).scene;
    picture.size = sizesOf(options.isQuick).picture;
    picture.time = kPathBegins;
    picture.alongPath = true;
    return preparePath(picture, {sizesOf(options.isQuick).frames, kFramesPerSecond, true});
}

} // namespace

std::vector<Light> sunsAround(int count)
{
    std::vector<Light> suns;
    for (int i = 0; i < count; ++i) {
        const double y = 0.87 - 0.53 * (i + 0.5) / count, r = std::sqrt(1 - y * y), angle = 0.6 + kGoldenAngle * i;
        Light sun;
        sun.name = fmt::format("sun-{}", i + 1);
        sun.directionWorld = {-r * std::cos(angle), -y, -r * std::sin(angle)};
        sun.colour = (1.0 / count) * Vec3d{1, 1, 1};
        suns.push_back(sun);
    }
    return suns;
}

double mean(std::span<const double> values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

TimeRatio timeRatio(const LoopTimes& of, const LoopTimes& over)
{
    TimeRatio ratio{mean(of.frameMs) / mean(over.frameMs), 0};
    for (std::size_t i = 0; i < of.frameMs.size(); ++i)
        ratio.worst = std::max(ratio.worst, of.frameMs[i] / over.frameMs[i]);
    return ratio;
}

LoopExperiment::LoopExperiment(const ExperimentOptions& options, std::size_t mostLoops)
    : isQuick_(options.isQuick),
      seed_(options.seed),
      path_(walk(options)),
      stage_(makeStage(path_.shooting.scene, path_.shooting.evaluateOptions, path_.originWorld)),
      race_(path_, stage_.buffers, mostLoops),
      executor_(makeExecutor(options.executor))
{
}

LixelSize LoopExperiment::map(int side) const
{
    const int scaled = int(std::lround(side * sizesOf(isQuick_).mapShare));
    return {scaled, scaled};
}

TimedLoop LoopExperiment::loop(const char* technique, LixelSize lixels)
{
    return {readTechniques(technique).front(), lixels};
}

std::vector<LoopTimes> LoopExperiment::time(std::span<const TimedLoop> loops, std::span<const Light> lights,
                                            int passFrames, Progress& progress)
{
    std::vector<RacedLoop> raced;
    for (const TimedLoop& loop : loops) raced.push_back({std::get<MapTechnique>(loop.choice.technique), loop.lixels});
    const std::string now = fmt::format("{} lights, {}", lights.size(), toString(loops.front().lixels));
    return race_.run(raced, lights, passFrames, [&] { progress.step(now); });
}

ResultRow LoopExperiment::rowOf(const ShotContext& context, const TimedLoop& loop, const LoopTimes& times,
                                const FramePlan& plan, std::size_t light, const Visibility& visibility) const
{
    ResultRow row = keyOf(context, loop.choice, light, executor_->name());
    row.seed = seed_;
    if (const auto refused = plan.lights[light].refused) {
        row.outcome = Refusal{std::string(nameOf(*refused)), std::string(sentenceFor(*refused))};
        return row;
    }
    Measurement m = measured(context, light, visibility);
    m.lixelsUsed = plan.lixelsOf(light);
    m.bytes = m.lixelsUsed * plan.lookup.bytesPerLixel;
    for (const PlannedRegion& region : plan.lights[light].regions)
        m.regions.push_back({"", region.rectangle.width(), region.rectangle.height()});
    Density density = densityOf(context, plan.lights[light], light, 0, kDensityStep);
    m.footprintPixelsPerLixel = percentiles(std::move(density.pixelsPerLixelList));
    m.densityLixelsPerPixel = percentiles(std::move(density.lixelsPerPixelList));
    m.timing.frameMs = mean(times.frameMs);
    m.timing.passes = times.passes;
    m.timing.clock = fmt::format("steady_clock from idle to idle, mean of {} frames; passes: {}", times.frameMs.size(),
                                 times.passClock);
    row.outcome = std::move(m);
    return row;
}

Judged LoopExperiment::judge(std::span<const TimedLoop> loops, std::span<const LoopTimes> times,
                             const std::vector<Light>& lights, int count)
{
    std::vector<SampleCount> sums(loops.size());
    const int frames = int(path_.frames.size());
    for (int i = 1; i <= count; ++i) {
        const int number = frames * i / count - 1;
        const PathFrame& frame = path_.frames[std::size_t(number)];
        Shot shot = frame.shot;
        shot.name = fmt::format("frame {}, {} {}", number + 1, lights.size(), lights.size() > 1 ? "lights" : "light");
        shot.lights = lights;
        const ViewSamples samples = executor_->viewSamples(stage_, frame.view);
        const Truth truth = findTruth(stage_, samples, lights, path_.shooting.planes);
        for (std::size_t j = 0; j < loops.size(); ++j) {
            ComparisonOptions comparison;
            comparison.techniques = {loops[j].choice};
            comparison.lixels.total = loops[j].lixels;
            const ShotContext context{path_.shooting, shot, stage_, frame.view, samples, truth, comparison};
            const FramePlan& plan = times[j].plans[std::size_t(number)];
            const std::vector<Visibility> visibility = executor_->run(stage_, plan, samples);
            for (std::size_t light = 0; light < lights.size(); ++light) {
                rows_.push_back(rowOf(context, loops[j], times[j], plan, light, visibility[light]));
                const Measurement* const m = rows_.back().measured();
                if (!m) continue;
                sums[j].samples += m->lightFacing;
                sums[j].misclassified += m->misclassified;
            }
        }
    }
    Judged percent;
    for (const SampleCount& sum : sums)
        percent.push_back(100 * double(sum.misclassified) / std::max(1.0, double(sum.samples)));
    return percent;
}

ReadbackCost LoopExperiment::readbackOf(std::span<const Light> lights) const
{
    return readbackCost(stage_.buffers, path_.frames.front().view, lights, kReadbackFrames);
}

double LoopExperiment::hullMs(std::span<const Light> lights, LixelSize lixels) const
{
    const View& view = path_.frames.back().view;
    const Observation observed = observe(executor_->viewSamples(stage_, view), view, {}, {});
    PlanInput input{view, lights, stage_.buffers.bounds.boxesWorld, path_.originWorld, {}, lixels};
    input.technique.fit = DesiredViewFit{true};
    input.seen = &observed.samples;
    return planningMs(input, kHullPlans);
}

Reproduction LoopExperiment::finished()
{
    Reproduction out;
    out.run.rows = std::move(rows_);
    out.run.timing.host = executor_->host();
    const Sizes& sizes = sizesOf(isQuick_);
    out.parameters = {{"scene", sizes.scene},
                      {"triangles", fmt::format("{}", stage_.buffers.triangles.triangleCount())},
                      {"size", sizes.picture},
                      {"frames", fmt::format("{} of the scene's path from {} s at {} a second, techniques by turns",
                                             sizes.frames, kPathBegins, kFramesPerSecond)},
                      {"observed", "every third frame, 180x180 cells"},
                      {"executor", std::string(executor_->name())}};
    if (isQuick_)
        out.parameters.push_back(
            {"quick",
             fmt::format("picture and maps are {} of the paper's a side, and objects few: planning weighs more",
                         sizes.mapShare)});
    return out;
}

} // namespace lixel::app
