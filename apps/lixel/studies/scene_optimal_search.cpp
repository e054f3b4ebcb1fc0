// SPDX-License-Identifier: MIT
#include "lixel/report/scene_optimal_search.h"

#include "executor.h"
#include "experiments/walkthrough.h"
#include "finish_study.h"
#include "lixel/plan/fit/exhaustive_search.h"
#include "lixel/plan/fit/scene_optimal.h"
#include "lixel/plan/need.h"
#include "lixel/plan/observe.h"
#include "lixel/scene/hemisphere_lights.h"
#include "progress.h"
#include "shadows.h"
#include "study.h"

#include <array>
#include <cmath>
#include <memory>

#include <fmt/format.h>

// The lights of Table 1 of Chong & Gortler 2007: for each metric the energy of what scene-optimal finds, and of what the paper's descent
// does, against the best of very many axes.
namespace lixel::app {
namespace {

constexpr int kLights = 500, kQuickLights = 20;
constexpr const char* kPicture = "750x750";
constexpr const char* kStandard = "focused"; // what the frame before was drawn with
constexpr LixelSize kStandardLixels{400, 400};
constexpr std::array kMetrics{LixelMetric::L2, LixelMetric::Lloyd, LixelMetric::Area, LixelMetric::Width};

// The picture and what is known of it without a light.
class Walkthrough
{
public:
    explicit Walkthrough(Executor& executor)
        : executor_(executor),
          shooting_(walkthroughAt(kPicture)),
          stage_(makeStage(shooting_.scene, shooting_.evaluateOptions, originOf(shooting_, shooting_.shots.front()))),
          view_(viewOf(shooting_, shooting_.shots.front())),
          samples_(executor.viewSamples(stage_, view_))
    {
    }

    // All metrics of one light. False where it throws no shadow in view.
    bool add(const Light& light, std::vector<SceneOptimalSearch::Case>& cases)
    {
        const Vec3d origin = samples_.originWorld;
        seenLocal_.clear();
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            const Vec3d p = toDouble(samples_.positionLocal[i]), n = toDouble(samples_.normal[i]);
            if (isLightFacing(light, origin, p, n)) seenLocal_.push_back(p);
        }
        const Observation observed = observeLastFrame(light);
        NeedSource source;
        source.observed = &observed;
        source.view = &view_;
        const SceneOptimalFit standard;
        const std::size_t all = observed.samples.size();
        gatherNeedSamples(source, light, origin, scratch_.boundaryDirections, edges_,
                          {all, all, standard.awayFromBoundaries, true});

        FitInput input{view_,   light, origin, {&shooting_.sceneWorld, 1}, translated(shooting_.sceneWorld, -origin),
                       scratch_};
        input.hasViewSamples = true;
        input.seenLocal = seenLocal_;
        input.seenIsAll = true;
        input.edges = edges_;
        const std::size_t before = cases.size();
        for (const LixelMetric metric : kMetrics)
            if (const auto found = caseOf(input, metric, light)) cases.push_back(*found);
        return cases.size() > before;
    }

private:
    Observation observeLastFrame(const Light& light)
    {
        const std::vector<Light> lights{light};
        const PlanSubject subject{stage_, view_, lights, shooting_.planes, samples_};
        LixelBudget lixels;
        lixels.total = kStandardLixels;
        const auto plan = planFor(readTechniques(kStandard).front(), subject, lixels, executor_);
        std::vector<Visibility> visibility = executor_.run(stage_, *plan, samples_);
        for (Visibility& v : visibility) v.value.resize(samples_.size(), 0.0f);
        return observe(samples_, view_, lights, visibility);
    }

    std::optional<SceneOptimalSearch::Case> caseOf(const FitInput& input, LixelMetric metric, const Light& light)
    {
        SceneOptimalFit choice;
        choice.metric = metric;
        const FitResult wide = fitSceneOptimal(input, choice);
        const auto asked = sceneQuestion(input, choice);
        if (!wide || !asked || !asked->map) return std::nullopt;
        const PlaneWarp rows = planeWarpOf(asked->frame, wide->lightClipFromLocal).value();
        SceneOptimalSearch::Case out{light.name, std::string(lixel::nameOf(metric)), 0, 0,
                                     0,          int(asked->map->rays.size())};
        out.wide = lixelEnergy(metric, asked->map->rays, rows);
        out.descent = descend(*asked->map, {0, 0, 1}).energy;
        out.exhaustive = searchExhaustively(*asked->map).energy;
        return out;
    }

    Executor& executor_;
    Shooting shooting_;
    Stage stage_;
    View view_;
    ViewSamples samples_;
    FitScratch scratch_;
    std::vector<Vec3d> seenLocal_;
    std::vector<NeedSample> edges_;
};

void print(const SceneOptimalSearch& study, std::FILE* to)
{
    fmt::print(to, "{:<8} {:>8} {:>16} {:>12} {:>12}\n", "metric", "search", "within 2 %", "worst ratio", "mean ratio");
    const auto rows = [&](const char* name, const std::vector<SearchQuality>& all) {
        for (const SearchQuality& q : all)
            fmt::print(to, "{:<8} {:>8} {:>5} of {:<5} {:>12.4f} {:>12.4f}\n", q.metric, name, q.withinShare, q.cases,
                       q.worstRatio, q.meanRatio);
    };
    rows("wide", searchQuality(study, &SceneOptimalSearch::Case::wide));
    rows("paper", searchQuality(study, &SceneOptimalSearch::Case::descent));
}

} // namespace

int studySceneOptimalSearch(const StudyOptions& options)
{
    SceneOptimalSearch study;
    study.seed = options.seed;
    study.lights = options.count > 0 ? options.count : options.isQuick ? kQuickLights : kLights;
    study.scene = "objects";
    study.view = kWalkthrough;
    const Exhaustion exhaustion;
    study.axes = exhaustion.axes, study.refined = int(exhaustion.refined);
    const std::unique_ptr<Executor> executor = makeExecutor(options.executor);
    const Stopwatch total;
    {
        Walkthrough walkthrough(*executor);
        Progress progress("study scene-optimal-search", study.lights);
        for (const Light& light : hemisphereLights(options.seed, study.lights)) {
            progress.step(light.name);
            if (!walkthrough.add(light, study.cases)) ++study.leftOut;
        }
    }
    return finishStudy(study, options, total.seconds(), executor->host(), print);
}

} // namespace lixel::app
