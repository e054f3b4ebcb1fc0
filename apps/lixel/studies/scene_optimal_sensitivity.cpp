// SPDX-License-Identifier: MIT
#include "lixel/report/scene_optimal_sensitivity.h"

#include "experiments/walkthrough.h"
#include "finish_study.h"
#include "lixel/plan/need.h"
#include "lixel/plan/place.h"
#include "lixel/scene/hemisphere_lights.h"
#include "one_light.h"
#include "progress.h"
#include "studies/scene_optimal_variants.h"
#include "study.h"

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

// The lights of Table 1 of Chong & Gortler 2007: errors of scene-optimal's maps against those of focused ones, as its parameters change one by
// one.
namespace lixel::app {
namespace {

constexpr int kLights = 50, kQuickLights = 8;
constexpr const char* kPicture = "750x750";
constexpr LixelSize kMap{400, 400};

// No technique says which angles a descent takes: the light image is made here, and its matrix given.
class GivenAngles
{
public:
    explicit GivenAngles(const StudiedPicture& picture) : picture_(picture) {}

    // Nothing where refused.
    std::optional<TechniqueChoice> choice(const SceneOptimalVariant& variant, const Light& light,
                                          const Observation& observed)
    {
        const Vec3d origin = picture_.samples.originWorld;
        const Box& sceneWorld = picture_.shooting.sceneWorld;
        gather(variant.fit, light, observed);
        FitInput input{
            picture_.view, light, origin, picture_.stage.buffers.bounds.boxesWorld, translated(sceneWorld, -origin),
            scratch_};
        input.hasViewSamples = true;
        input.seenLocal = seenLocal_;
        input.seenIsAll = true;
        input.edges = edges_;
        input.shadowsLocal = shadowsLocal_;
        const FitResult found = fitSceneOptimal(input, variant.fit, *variant.angles);
        if (!found) return std::nullopt;
        const MapTechnique technique{.fit = MatrixFit{}};
        const LixelRectangle whole{0, 0, kMap.width, kMap.height, 0};
        const Mat4d placed = place(*found, whole, lookupLayout(technique), origin).lightClipFromLocal;
        return TechniqueChoice{variant.value, technique, {{"", {{placed * translation(-origin), whole, {}}}}}};
    }

private:
    void gather(const SceneOptimalFit& fit, const Light& light, const Observation& observed)
    {
        const Vec3d origin = picture_.samples.originWorld;
        seenLocal_.clear();
        for (std::size_t i = 0; i < picture_.samples.size(); ++i) {
            const Vec3d p = toDouble(picture_.samples.positionLocal[i]), n = toDouble(picture_.samples.normal[i]);
            if (isLightFacing(light, origin, p, n)) seenLocal_.push_back(p);
        }
        NeedSource source;
        source.observed = &observed;
        source.view = &picture_.view;
        const std::size_t all = observed.samples.size();
        gatherNeedSamples(source, light, origin, scratch_.boundaryDirections, edges_,
                          {all, all, fit.awayFromBoundaries, true});
        gatherShadows(source, light, origin, shadowsLocal_);
    }

    const StudiedPicture& picture_;
    FitScratch scratch_;
    std::vector<Vec3d> seenLocal_, shadowsLocal_;
    std::vector<NeedSample> edges_;
};

class Sensitivity
{
public:
    explicit Sensitivity(const StudiedPicture& picture)
        : picture_(picture), curves_(sceneOptimalCurves()), given_(picture)
    {
        for (const SceneOptimalCurve& curve : curves_) {
            found_.push_back({curve.parameter, curve.technique, {}});
            for (const SceneOptimalVariant& variant : curve.variants)
                found_.back().points.push_back({variant.value, variant.isOwn});
        }
    }

    // False where there is no focused map.
    bool add(const Light& light)
    {
        OneLight one(picture_, light);
        const auto focused = one.score(readTechniques("focused").front(), kMap, {});
        if (!focused) return false;
        one.drawLastFrame(kMap);
        known_.clear(), measured_.clear();
        for (std::size_t i = 0; i < curves_.size(); ++i)
            for (std::size_t j = 0; j < curves_[i].variants.size(); ++j) {
                const auto misclassified = measure(one, curves_[i].variants[j]);
                if (!misclassified) continue;
                SceneOptimalSensitivity::Point& point = found_[i].points[j];
                point.misclassified += *misclassified;
                point.ofFocused += focused->misclassified;
                ++point.lights;
            }
        return true;
    }

    std::vector<SceneOptimalSensitivity::Curve> take() { return std::move(found_); }

private:
    // Nothing where refused. The own values of a technique stand in each of its curves, and are measured once.
    std::optional<std::int64_t> measure(const OneLight& one, const SceneOptimalVariant& variant)
    {
        for (const auto& [fit, misclassified] : measured_)
            if (!variant.angles && fit == variant.fit) return misclassified;
        const PlanMemory& known = knownBy(one, variant.fit.samples);
        const auto choice = variant.angles ? given_.choice(variant, one.light(), *known.observed)
                                           : TechniqueChoice{variant.value, MapTechnique{.fit = variant.fit}};
        const auto score = choice ? one.score(*choice, kMap, known) : std::nullopt;
        const auto misclassified = score ? std::optional(score->misclassified) : std::nullopt;
        if (!variant.angles) measured_.emplace_back(variant.fit, misclassified);
        return misclassified;
    }

    const PlanMemory& knownBy(const OneLight& one, int samples)
    {
        const auto [place, isNew] = known_.try_emplace(samples);
        if (isNew) place->second = one.lastFrame({samples, samples});
        return place->second;
    }

    const StudiedPicture& picture_;
    std::vector<SceneOptimalCurve> curves_;
    GivenAngles given_;
    std::vector<SceneOptimalSensitivity::Curve> found_;

    // Of one light.
    std::map<int, PlanMemory> known_; // by the grid that observed
    std::vector<std::pair<SceneOptimalFit, std::optional<std::int64_t>>> measured_;
};

// A table a parameter.
void print(const SceneOptimalSensitivity& study, std::FILE* to)
{
    fmt::print(to, "misclassified samples of {} lights against those of focused; *: what the technique has\n",
               study.lights);
    for (const SceneOptimalSensitivity::Curve& curve : study.curves) {
        fmt::print(to, "\n{}, {}\n", curve.parameter, curve.technique);
        for (const SceneOptimalSensitivity::Point& point : curve.points)
            fmt::print(to, "  {:<28}{} {:>9} {:>8.4f}{}\n", point.value, point.isOwn ? "*" : " ", point.misclassified,
                       point.ratio(), point.lights < study.lights ? fmt::format("  ({} lights)", point.lights) : "");
    }
}

} // namespace

int studySceneOptimalSensitivity(const StudyOptions& options)
{
    SceneOptimalSensitivity study;
    study.seed = options.seed;
    const int lights = options.count > 0 ? options.count : options.isQuick ? kQuickLights : kLights;
    study.scene = "objects";
    study.view = kWalkthrough;
    study.size = kPicture;
    study.lixels = toString(kMap);
    const std::unique_ptr<Executor> executor = makeExecutor(options.executor);
    study.executor = executor->name();
    const Stopwatch total;
    {
        const Shooting shooting = walkthroughAt(kPicture);
        const StudiedPicture picture(shooting, shooting.shots.front(), *executor);
        Sensitivity sensitivity(picture);
        Progress progress("study scene-optimal-sensitivity", lights);
        for (const Light& light : hemisphereLights(options.seed, lights)) {
            progress.step(light.name);
            study.lights += sensitivity.add(light);
        }
        study.curves = sensitivity.take();
    }
    return finishStudy(study, options, total.seconds(), executor->host(), print);
}

} // namespace lixel::app
