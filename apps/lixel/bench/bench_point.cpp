// SPDX-License-Identifier: MIT
#include "bench/bench_point.h"

#include "bench/memory.h"
#include "lixel/gl/graphics_error.h"
#include "lixel/scene/hemisphere_lights.h"
#include "run_results.h"

#include <algorithm>
#include <new>

#include <fmt/format.h>

namespace lixel::app {
namespace {

constexpr std::uint64_t kSeed = 2004;    // of where lights are
constexpr double kPlanningSeconds = 1.0; // spent on taking the median of planning, at most

// The median time of planning anew, after a first time that warms up.
double planningMs(const TechniqueChoice& technique, const PlanSubject& subject, const LixelBudget& lixels,
                  Executor& executor, int times)
{
    std::vector<double> ms;
    const Stopwatch all;
    do {
        const Stopwatch one;
        planFor(technique, subject, lixels, executor);
        ms.push_back(1e3 * one.seconds());
    } while (int(ms.size()) < times && all.seconds() < kPlanningSeconds);
    std::ranges::sort(ms);
    return ms[ms.size() / 2];
}

// One that no light of the picture is refused for.
std::string refusalOf(const FramePlan& plan)
{
    for (const ShadowPlan& light : plan.lights)
        if (light.refused) return fmt::format("refused: {}", sentenceFor(*light.refused));
    return "";
}

} // namespace

BenchStage::BenchStage(const BenchPoint& point, const std::string& executor) : point_(point), executor_(executor)
{
    PictureOptions options;
    options.scene = point.scene();
    options.view = "overview";
    options.size = fmt::format("{0}x{0}", point.side);
    shooting_ = prepare(options, false);
    shot_ = shooting_.shots.front();
    if (point.lights > 1) shot_.lights = hemisphereLights(kSeed, point.lights);
    const Vec3d origin = originOf(shooting_, shot_);
    if (executor == "trace") stage_ = makeStage(shooting_.scene, shooting_.evaluateOptions, origin);
    else stage_.buffers = evaluate(shooting_.scene, shooting_.evaluateOptions, origin);
    view_ = viewOf(shooting_, shot_);
}

BenchStage::Outcome BenchStage::measure(const TechniqueChoice& technique, int frames) const
{
    const bool hasVolumes = std::holds_alternative<ShadowVolumesTechnique>(technique.technique);
    if (!hasVolumes && !std::holds_alternative<MapTechnique>(technique.technique))
        return {{}, "makes nothing whose cost there would be"};
    const PeakMemory peak;
    try {
        const auto executor = makeExecutor(executor_);
        const ViewSamples samples = executor->viewSamples(stage_, view_);
        BenchRow::Measured measured;
        if (hasVolumes) {
            const auto visibility = executor->shadowVolumes(stage_, view_, shot_.lights, samples);
            if (!visibility) return {{}, "refused: " + visibility.error().message};
            measured.timing = executor->timeVolumes(stage_, view_, shot_.lights, frames, false);
            measured.peakResidentBytes = peak.bytes();
            measured.deviceBytes = executor->deviceBytes();
            return {measured, ""};
        }
        const PlanSubject subject{stage_, view_, shot_.lights, shooting_.planes, samples};
        const LixelBudget lixels{{point_.mapSide, point_.mapSide}, {}};
        const FramePlan plan = *planFor(technique, subject, lixels, *executor);
        if (const std::string refusal = refusalOf(plan); !refusal.empty()) return {{}, refusal};
        measured.planMs = planningMs(technique, subject, lixels, *executor, frames);
        measured.timing = executor->time(stage_, plan, view_, frames);
        for (std::size_t light = 0; light < plan.lights.size(); ++light) measured.lixelsUsed += plan.lixelsOf(light);
        measured.peakResidentBytes = peak.bytes();
        measured.deviceBytes = executor->deviceBytes();
        return {measured, ""};
    } catch (const gl::GraphicsError& error) {
        return {{}, error.what()};
    } catch (const std::bad_alloc&) {
        return {{}, "out of memory"};
    }
}

} // namespace lixel::app
