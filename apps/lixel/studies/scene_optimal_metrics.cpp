// SPDX-License-Identifier: MIT
#include "lixel/report/scene_optimal_metrics.h"

#include "boundary_energy.h"
#include "experiments/walkthrough.h"
#include "finish_study.h"
#include "lixel/scene/hemisphere_lights.h"
#include "one_light.h"
#include "progress.h"
#include "study.h"

#include <array>
#include <memory>

#include <fmt/format.h>

// The lights of Table 1 of Chong & Gortler 2007: what each metric says of single maps, by the picture's exact shadow boundaries, against what
// they misclassify.
namespace lixel::app {
namespace {

constexpr int kLights = 500, kQuickLights = 20;
constexpr const char* kPicture = "750x750";
constexpr LixelSize kMap{400, 400};
constexpr const char* kTechniques =
    "focused,lispsm,psm,tsm,scene-optimal(metric=l2,uncovered=lit),scene-optimal(metric=lloyd,uncovered=lit),"
    "scene-optimal(metric=area,uncovered=lit),scene-optimal(metric=width,uncovered=lit)";
constexpr std::array kMetrics{LixelMetric::L2, LixelMetric::Lloyd, LixelMetric::Area, LixelMetric::Width};

// False where no shadow ends in view.
bool addLight(const StudiedPicture& picture, const Light& light, std::span<const TechniqueChoice> techniques,
              std::vector<SceneOptimalMetrics::Case>& cases)
{
    OneLight one(picture, light);
    const std::vector<NeedSample> boundary = one.boundary();
    if (boundary.empty()) return false;
    one.drawLastFrame(kMap);
    const PlanMemory known = one.lastFrame();
    for (const TechniqueChoice& choice : techniques) {
        const FramePlan plan = one.plan(choice, kMap, known);
        if (plan.lights.front().refused) continue;
        const BoundaryEnergy energy(picture.view, picture.samples.originWorld, plan.lights.front(), boundary);
        SceneOptimalMetrics::Case c{light.name,
                                    choice.typed,
                                    one.score(plan).misclassified,
                                    std::int64_t(boundary.size()),
                                    std::int64_t(energy.unserved()),
                                    {}};
        for (const LixelMetric metric : kMetrics)
            if (const auto mean = energy.mean(metric)) c.meanEnergy[std::string(nameOf(metric))] = *mean;
        if (!c.meanEnergy.empty()) cases.push_back(std::move(c));
    }
    return true;
}

std::string text(std::optional<double> value) { return value ? fmt::format("{:+.3f}", *value) : "-"; }

// Metrics side by side.
void print(const SceneOptimalMetrics& study, std::FILE* to)
{
    const std::vector<MetricRanks> all = metricRanks(study);
    const auto row = [&](const std::string& what, const auto& cell) {
        fmt::print(to, "{:<46}", what);
        for (const MetricRanks& ranks : all) fmt::print(to, " {:>9}", cell(ranks));
        fmt::print(to, "\n");
    };
    fmt::print(to,
               "Spearman's rank correlation of energy and misclassified samples, for each sample of the boundary\n");
    row("", [](const MetricRanks& ranks) { return ranks.metric; });
    for (const std::string& technique : study.techniques)
        row("over lights: " + technique, [&](const MetricRanks& r) { return text(r.ofTechnique.at(technique)); });
    row("over lights and techniques", [](const MetricRanks& r) { return text(r.pooled); });
    row("the same, sums over the boundary", [](const MetricRanks& r) { return text(r.pooledSums); });
    row("over techniques, mean of lights", [](const MetricRanks& r) { return text(r.withinLights); });
    row("lights whose best map has the least energy",
        [](const MetricRanks& r) { return fmt::format("{}/{}", r.bestFound, r.lightsRanked); });
    row("errors of maps so chosen, of the best maps'",
        [](const MetricRanks& r) { return fmt::format("{:.3f}", r.lossOfChoice); });
}

} // namespace

int studySceneOptimalMetrics(const StudyOptions& options)
{
    SceneOptimalMetrics study;
    study.seed = options.seed;
    study.lights = options.count > 0 ? options.count : options.isQuick ? kQuickLights : kLights;
    study.scene = "objects";
    study.view = kWalkthrough;
    study.size = kPicture;
    study.lixels = toString(kMap);
    for (const LixelMetric metric : kMetrics) study.metrics.emplace_back(nameOf(metric));
    const std::vector<TechniqueChoice> techniques = readTechniques(kTechniques);
    for (const TechniqueChoice& choice : techniques) study.techniques.push_back(choice.typed);
    const std::unique_ptr<Executor> executor = makeExecutor(options.executor);
    study.executor = executor->name();
    const Stopwatch total;
    {
        const Shooting shooting = walkthroughAt(kPicture);
        const StudiedPicture picture(shooting, shooting.shots.front(), *executor);
        Progress progress("study scene-optimal-metrics", study.lights);
        for (const Light& light : hemisphereLights(options.seed, study.lights)) {
            progress.step(light.name);
            if (!addLight(picture, light, techniques, study.cases)) ++study.leftOut;
        }
    }
    return finishStudy(study, options, total.seconds(), executor->host(), print);
}

} // namespace lixel::app
