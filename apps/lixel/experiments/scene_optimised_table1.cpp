// SPDX-License-Identifier: MIT
#include "comparison.h"
#include "experiment.h"
#include "experiments/enlarged_square.h"
#include "experiments/scene_optimised_table1_numbers.h"
#include "experiments/walkthrough.h"
#include "lixel/plan/observe.h"
#include "lixel/report/false_colour.h"
#include "lixel/report/png.h"
#include "lixel/scene/hemisphere_lights.h"
#include "run_results.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>

#include <fmt/format.h>

// Chong and Gortler 2007, section 3 and Table 1: a few dozen objects on or near a floor (1,137,772 triangles), the viewer
// slightly above it as in a walkthrough, 500 lights uniform on a distant hemisphere, picture 750x750, maps 400x400. The lights
// here are infinitely far. The paper's truth is a focused map of 4000x4000, ours exact visibility.
namespace lixel::app {
namespace {

// What is compared. The paper's five come first and in its order; Optimal and Plane are single maps, where samples that they do
// not cover are lit.
struct Method
{
    const char* title;
    const char* technique;
};
constexpr std::array kMethods{
    Method{"Optimal", "scene-optimal(metric=l2,search=paper,uncovered=lit)"},
    Method{"Focused", "focused"},
    Method{"LiSPSM", "lispsm"},
    Method{"Plane", "planes(floor)+plane-optimal(uncovered=lit)"},
    Method{"Normal", "uniform"},
    Method{"Best", "scene-optimal(uncovered=lit)"},
    Method{"Best, shadows, else focused", "scene-optimal(holds=shadows)"},
    Method{"Best, all that is seen", "scene-optimal"},
    Method{"Best, sheared", "scene-optimal(shear,uncovered=lit)"},
    Method{"L2, all axes", "scene-optimal(metric=l2)"},
    Method{"Lloyd's m, all axes", "scene-optimal(metric=lloyd)"},
    Method{"Area, all axes", "scene-optimal(metric=area)"},
    Method{"Plane else focused", "planes(floor)+plane-optimal"},
    Method{"Planes found", "planes(auto)+plane-optimal"},
    Method{"Minimal frustum", "minimal-frustum"},
    Method{"Desired view", "desired-view"},
    Method{"Desired view, rotated", "desired-view(rotated)"},
    Method{"PSM", "psm"},
    Method{"TSM", "tsm"},
};

constexpr std::size_t kShown = 4; // in Figure 4: the first

// What the last frame is drawn with, for observations.
constexpr const char* kStandard = "focused";

constexpr int kLights = 500, kQuickLights = 50;
constexpr const char* kPicture = "750x750";
constexpr const char* kMap = "400x400";
constexpr std::size_t kFootprintStep = 16; // samples; all of them would take as long as a map and its lookup

class Table1
{
public:
    explicit Table1(const ExperimentOptions& options);
    Reproduction run();

private:
    std::vector<ResultRow> rowsOf(const Light& light, ComparisonOptions& options);
    Observation observeLastFrame();

    void showExample(const Light& light);
    void addFigures(const std::vector<ResultRow>& rows);
    void addParameters();

    const ExperimentOptions& options_;
    std::string size_, lixels_;
    std::vector<Light> lights_;
    Shooting shooting_;
    Stage stage_;
    View view_;
    std::vector<std::unique_ptr<Executor>> executors_;
    ViewSamples samples_; // the same for all lights
    std::vector<TechniqueChoice> standard_;
    ComparisonOptions comparison_;
    std::vector<PossibleErrors> errors_{kMethods.size()}; // [method][light]
    Reproduction out_;
};

Table1::Table1(const ExperimentOptions& options)
    : options_(options),
      size_(options.size.value_or(kPicture)),
      lixels_(options.lixels.value_or(kMap)),
      lights_(hemisphereLights(options.seed, options.lights.value_or(options.isQuick ? kQuickLights : kLights))),
      shooting_(walkthroughAt(size_)),
      stage_(makeStage(shooting_.scene, shooting_.evaluateOptions, originOf(shooting_, shooting_.shots.front()))),
      view_(viewOf(shooting_, shooting_.shots.front())),
      standard_(readTechniques(kStandard))
{
    executors_.push_back(makeExecutor(options.executor));
    samples_ = executors_.front()->viewSamples(stage_, view_);
    comparison_.lixels.total = readSize(lixels_, "--lixels", kMostLixelsASide);
    comparison_.timingFrames = 0;
    comparison_.footprintStep = kFootprintStep;
    for (const Method& method : kMethods) comparison_.techniques.push_back(readTechniques(method.technique).front());
}

// What the frame before this one, drawn with the standard map, tells of shadow boundaries. As in the paper this map is not in
// the budget: there it is the map of an earlier frame.
Observation Table1::observeLastFrame()
{
    const std::vector<Light>& lights = shooting_.shots.front().lights;
    const PlanSubject subject{stage_, view_, lights, shooting_.planes, samples_};
    const auto plan = planFor(standard_.front(), subject, comparison_.lixels, *executors_.front());
    std::vector<Visibility> visibility = executors_.front()->run(stage_, *plan, samples_);
    Observation observed = observe(samples_, view_, lights, visibility);
    observed.ageFrames = 1;
    return observed;
}

std::vector<ResultRow> Table1::rowsOf(const Light& light, ComparisonOptions& options)
{
    Shot& shot = shooting_.shots.front();
    shot.lights = {light};
    const Truth truth = findTruth(stage_, samples_, shot.lights, shooting_.planes);
    options.memory.observed = observeLastFrame();
    std::vector<ResultRow> rows = compareTechniques({shooting_, shot, stage_, view_, samples_, truth, options},
                                                    executors_, [](std::string_view) {});
    for (ResultRow& row : rows) row.seed = options_.seed;
    return rows;
}

// The light in the middle of all by the errors of Focused.
std::size_t medianLight(const ComparableErrors& counted)
{
    const std::vector<double>& errors = counted.errors[kFocused];
    std::vector<std::size_t> order(errors.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return errors[i]; });
    return counted.cases[order[order.size() / 2]];
}

// Its rows again, with pictures.
void Table1::showExample(const Light& light)
{
    ComparisonOptions options = comparison_;
    options.pictures = options_.pictures;
    options.techniques.push_back(readTechniques("exact").front());
    std::vector<ResultRow> rows = rowsOf(light, options);
    const std::string boundary = fmt::format("pictures/{}-{}-boundary.png", shooting_.shots.front().name, light.name);
    writePng(options_.pictures / boundary, boundaryPicture(*options.memory.observed, 0));
    for (ResultRow& row : rows)
        if (auto* m = std::get_if<Measurement>(&row.outcome)) m->pictures.boundary = boundary;
    addFigures(rows);
    std::erase_if(out_.run.rows, [&](const ResultRow& row) { return row.light == light.name; });
    std::ranges::move(rows, std::back_inserter(out_.run.rows));
}

// Figure 4 as it is, and with what is wrong; Figure 2.
void Table1::addFigures(const std::vector<ResultRow>& rows)
{
    PictureRow figure{"Figure 4: Optimal, Focused, LiSPSM, Plane",
                      rows.front().scene,
                      shooting_.shots.front().name,
                      rows.front().light,
                      {}};
    for (std::size_t method = 0; method < kShown; ++method)
        if (rows[method].measured()) figure.techniques.push_back(rows[method].technique);
    enlargeWhereMostIsWrong(readPng(options_.pictures / rows[kFocused].measured()->pictures.error), samples_,
                            planeOfSamples(samples_, shooting_.planes), figure);
    out_.figures.push_back(figure);
    figure.title += ", with what is wrong";
    figure.layer = PictureLayer::Error;
    out_.figures.push_back(figure);
    figure.title = "Figure 2: the samples used in optimisation";
    figure.layer = PictureLayer::Boundary;
    figure.techniques.resize(1);
    out_.figures.push_back(figure);
}

void Table1::addParameters()
{
    out_.parameters = {{"scene", shooting_.sceneName},
                       {"view", std::string(kWalkthrough)},
                       {"lights", fmt::format("{} of parallel light, uniform on the upper hemisphere", lights_.size())},
                       {"size", size_},
                       {"lixels", lixels_},
                       {"last frame", fmt::format("{}, {}; not in the budget", kStandard, lixels_)},
                       {"footprints", fmt::format("of one sample in {}", kFootprintStep)},
                       {"executor", options_.executor},
                       {"seed", fmt::format("{}", options_.seed)}};
    for (const Method& method : kMethods) out_.parameters.push_back({method.title, method.technique});
}

Reproduction Table1::run()
{
    Progress progress("reproduce", int(lights_.size()) + !options_.pictures.empty());
    for (const Light& light : lights_) {
        progress.step(light.name);
        std::vector<ResultRow> rows = rowsOf(light, comparison_);
        for (std::size_t method = 0; method < kMethods.size(); ++method) {
            const Measurement* m = rows[method].measured();
            errors_[method].push_back(m ? std::optional(double(m->misclassified)) : std::nullopt);
        }
        std::ranges::move(rows, std::back_inserter(out_.run.rows));
    }
    const ComparableErrors counted = comparableErrors(errors_, kFocused);
    if (!options_.pictures.empty() && !counted.cases.empty()) {
        progress.step("pictures");
        showExample(lights_[medianLight(counted)]);
    }
    std::vector<ReproducedTable::Column> columns;
    for (const Method& method : kMethods) columns.push_back({method.title, method.technique});
    out_.tables = {tableOf(std::move(columns), counted)};
    out_.numbers = numbersOf(out_.tables.front(), counted, double(view_.width) * view_.height);
    out_.run.timing.host = executors_.front()->host();
    addParameters();
    return std::move(out_);
}

} // namespace

Reproduction reproduceSceneOptimisedTable1(const ExperimentOptions& options) { return Table1(options).run(); }

} // namespace lixel::app
