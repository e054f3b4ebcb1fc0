// SPDX-License-Identifier: MIT
#include "path_comparison.h"

#include "lixel/trace/exact_visibility.h"
#include "path_row.h"
#include "shadows.h"

#include <algorithm>

#include <fmt/format.h>

namespace lixel::app {
namespace {

using StatesOfLights = std::vector<std::vector<ShadowState>>; // [light][sample]

// One frame, as far as it does not depend on a technique.
struct Moment
{
    std::shared_ptr<const Stage> stage;
    View view;
    ViewSamples samples;
    Truth truth;
    StatesOfLights exact;
};

// Samples of the frame before, in this one.
struct Followed
{
    CarriedSamples carried;
    std::vector<std::vector<float>> exact; // [light][sample]
    StatesOfLights exactStates;
};

// A light at the eye: what it reaches is what the view sees.
Light lightOfEye(const View& view)
{
    const Vec3d eye{view.eyeAnchored.x, view.eyeAnchored.y, view.eyeAnchored.z};
    Light light;
    light.kind = view.eyeAnchored.w != 0 ? LightKind::Point : LightKind::Directional;
    if (light.kind == LightKind::Point) light.positionWorld = view.anchorWorld + (1 / view.eyeAnchored.w) * eye;
    else light.directionWorld = -normalized(eye);
    return light;
}

Visibility part(const Visibility& all, std::size_t first, std::size_t last)
{
    const auto cut = [&](const auto& values) {
        if (values.empty()) return values;
        return std::remove_cvref_t<decltype(values)>(values.begin() + std::ptrdiff_t(first),
                                                     values.begin() + std::ptrdiff_t(last));
    };
    return {cut(all.value), cut(all.unserved)};
}

class PathComparison
{
public:
    PathComparison(const PathShooting& path, std::span<const std::unique_ptr<Executor>> executors,
                   const ComparisonOptions& options, const std::function<void(std::string_view)>& onStep)
        : path_(path),
          executors_(executors),
          options_(options),
          onStep_(onStep),
          lights_(path.frames.front().shot.lights.size()),
          rows_(options.techniques.size() * executors.size() * lights_),
          memories_(options.techniques.size())
    {
    }

    void addFrame(std::size_t number);
    std::vector<ResultRow> rows();

private:
    // Of one executor, technique and frame.
    struct Said
    {
        bool isOfMaps = false;
        std::vector<Visibility> ofSamples, ofFollowed; // [light]
    };

    Moment momentOf(std::size_t number);
    Followed follow(const Moment& now, std::span<const Light> lights) const;
    Said ask(Executor& executor, const TechniqueChoice& choice, const FramePlan* plan, const Moment& now,
             const Followed& followed, const ViewSamples& all, std::span<const Light> lights) const;
    void addTechnique(const ShotContext& context, std::size_t technique, std::size_t number, const Moment& now,
                      const Followed& followed, const ViewSamples& all);
    void addLight(PathRow& row, const ShotContext& context, std::size_t light, std::size_t number,
                  const FramePlan* plan, const Said& said, const Followed& followed);
    void addPictures(std::size_t technique, std::size_t executor, std::span<const ResultRow> shown);
    PathRow& rowOf(std::size_t technique, std::size_t executor, std::size_t light)
    {
        return rows_[(technique * executors_.size() + executor) * lights_ + light];
    }
    std::string nameOf(std::size_t number, std::string_view what) const
    {
        return fmt::format("frame {} of {}: {}", number + 1, path_.frames.size(), what);
    }

    const PathShooting& path_;
    std::span<const std::unique_ptr<Executor>> executors_;
    const ComparisonOptions& options_;
    const std::function<void(std::string_view)>& onStep_;
    std::size_t lights_;
    std::vector<PathRow> rows_;
    std::vector<PlanMemory> memories_; // [technique]
    std::optional<Moment> before_;
};

Moment PathComparison::momentOf(std::size_t number)
{
    const PathFrame& frame = path_.frames[number];
    Moment now;
    onStep_(nameOf(number, "view samples"));
    if (before_ && path_.frames[number - 1].evaluateOptions.time == frame.evaluateOptions.time)
        now.stage = before_->stage; // nothing has moved
    else
        now.stage =
            std::make_shared<const Stage>(makeStage(path_.shooting.scene, frame.evaluateOptions, path_.originWorld));
    now.view = frame.view;
    now.samples = executors_.front()->viewSamples(*now.stage, now.view);
    onStep_(nameOf(number, "exact visibility"));
    now.truth = findTruth(*now.stage, now.samples, frame.shot.lights, path_.shooting.planes);
    for (std::size_t light = 0; light < lights_; ++light)
        now.exact.push_back(exactStates(now.truth.zones[light], now.truth.exact[light]));
    return now;
}

Followed PathComparison::follow(const Moment& now, std::span<const Light> lights) const
{
    Followed out;
    out.carried.samples.width = now.samples.width, out.carried.samples.height = now.samples.height;
    out.carried.samples.originWorld = now.samples.originWorld;
    if (before_) {
        const CarriedSamples inView =
            carry(before_->samples, before_->stage->buffers.triangles, now.stage->buffers.triangles, now.view);
        out.carried = keepOnly(inView, exactVisibility(*now.stage->traced, inView.samples, lightOfEye(now.view)));
    }
    for (const Light& light : lights) {
        out.exact.push_back(exactVisibility(*now.stage->traced, out.carried.samples, light));
        out.exactStates.push_back(exactStates(out.carried.samples, light, out.exact.back()));
    }
    return out;
}

void PathComparison::addFrame(std::size_t number)
{
    Moment now = momentOf(number);
    const Shot& shot = path_.frames[number].shot;
    const Followed followed = follow(now, shot.lights);
    const ViewSamples all = joined(now.samples, followed.carried.samples);
    const ShotContext context{path_.shooting, shot, *now.stage, now.view, now.samples, now.truth, options_};
    for (std::size_t technique = 0; technique < options_.techniques.size(); ++technique)
        addTechnique(context, technique, number, now, followed, all);
    before_ = std::move(now);
}

// What the technique says of all samples. Exact visibility is known already.
PathComparison::Said PathComparison::ask(Executor& executor, const TechniqueChoice& choice, const FramePlan* plan,
                                         const Moment& now, const Followed& followed, const ViewSamples& all,
                                         std::span<const Light> lights) const
{
    if (std::holds_alternative<ExactTechnique>(choice.technique)) {
        Said said;
        for (std::size_t light = 0; light < lights_; ++light) {
            said.ofSamples.push_back({now.truth.exact[light], {}});
            said.ofFollowed.push_back({followed.exact[light], {}});
        }
        return said;
    }
    Said said{hasMap(choice.technique), {}, {}};
    const auto answer = said.isOfMaps
                            ? executor.run(*now.stage, *plan, all)
                            : visibilityWithoutMap(choice.technique, executor, *now.stage, now.view, all, lights, plan);
    for (const Visibility& one : *answer) {
        const bool isThere = !one.value.empty(); // else its light was refused
        said.ofSamples.push_back(isThere ? part(one, 0, now.samples.size()) : Visibility{});
        said.ofFollowed.push_back(isThere ? part(one, now.samples.size(), all.size()) : Visibility{});
    }
    return said;
}

void PathComparison::addTechnique(const ShotContext& context, std::size_t technique, std::size_t number,
                                  const Moment& now, const Followed& followed, const ViewSamples& all)
{
    const TechniqueChoice& choice = options_.techniques[technique];
    const PlanSubject subject{*now.stage, now.view, context.shot.lights, context.shooting.planes, now.samples};
    const auto plan = planFor(choice, subject, options_.lixels, *executors_.front(), memories_[technique]);
    const FramePlan* const planOrNull = plan ? &*plan : nullptr;
    std::vector<Said> said;
    for (std::size_t e = 0; e < executors_.size(); ++e) {
        Executor& executor = *executors_[e];
        onStep_(nameOf(number, fmt::format("{} ({})", choice.typed, executor.name())));
        if (e > 0 && !said.front().isOfMaps) said.push_back(said.front()); // rays do not depend on the executor
        else said.push_back(ask(executor, choice, planOrNull, now, followed, all, context.shot.lights));
        for (std::size_t light = 0; light < lights_; ++light) {
            PathRow& row = rowOf(technique, e, light);
            if (number == 0) row = PathRow(keyOf(context, choice, light, executor.name()));
            addLight(row, context, light, number, planOrNull, said[e], followed);
        }
        if (number == path_.frames.size() / 2)
            addPictures(technique, e, rowsOf(context, executor, choice, said[e].ofSamples, planOrNull));
    }
    if (plan) memories_[technique] = memoryOf(choice, subject, *plan, said.front().ofSamples);
    std::vector<std::vector<Image<float>>> maps;
    for (std::size_t e = 0; e < 2 && said.size() == 2 && plan; ++e)
        maps.push_back(executors_[e]->maps(context.stage, *plan));
    for (std::size_t light = 0; light < lights_ && said.size() == 2; ++light) {
        if (plan && plan->lights[light].refused) continue;
        const ExecutorAgreement counts = agreement(now.truth.zones[light], said[0].ofSamples[light],
                                                   said[1].ofSamples[light], now.truth.exact[light]);
        const LixelAgreement lixels = plan ? lixelAgreement(plan->lights[light], maps[0], maps[1]) : LixelAgreement{};
        for (std::size_t e = 0; e < 2; ++e) rowOf(technique, e, light).add(counts, lixels);
    }
}

// And times, from the rows of the frame in the middle alone.
void PathComparison::addPictures(std::size_t technique, std::size_t executor, std::span<const ResultRow> shown)
{
    for (std::size_t light = 0; light < lights_; ++light)
        if (const Measurement* m = shown[light].measured())
            rowOf(technique, executor, light).show(m->pictures, m->timing);
}

void PathComparison::addLight(PathRow& row, const ShotContext& context, std::size_t light, std::size_t number,
                              const FramePlan* plan, const Said& said, const Followed& followed)
{
    row.beginFrame(path_.frames[number].time);
    if (plan && plan->lights[light].refused) {
        row.addRefusal(*plan->lights[light].refused);
        return;
    }
    row.add(measured(context, light, said.ofSamples[light]));
    if (said.isOfMaps) {
        row.addMap(std::int64_t(plan->lixelsOf(light)), plan->lookup.bytesPerLixel);
        row.add(densityOf(context, plan->lights[light], light, number, path_.frames.size()));
    }
    if (before_)
        row.addFlips({before_->exact[light], before_->truth.zones[light]}, followed.carried.from,
                     statesOf(said.ofFollowed[light]), followed.exactStates[light]);
    row.keepStates(statesOf(said.ofSamples[light]));
}

std::vector<ResultRow> PathComparison::rows()
{
    std::vector<ResultRow> out;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const std::size_t executor = i / lights_ % executors_.size();
        const bool hasOther = executors_.size() == 2;
        out.push_back(rows_[i].finished(path_.isStill, hasOther ? executors_[1 - executor]->name() : ""));
    }
    return out;
}

} // namespace

std::vector<ResultRow> comparePath(const PathShooting& path, std::span<const std::unique_ptr<Executor>> executors,
                                   const ComparisonOptions& options,
                                   const std::function<void(std::string_view)>& onStep)
{
    PathComparison comparison(path, executors, options, onStep);
    for (std::size_t number = 0; number < path.frames.size(); ++number) comparison.addFrame(number);
    return comparison.rows();
}

int stepsOfPath(const PathShooting& path, std::size_t executors, const ComparisonOptions& options)
{
    return int(path.frames.size()) * stepsPerShot(executors, options);
}

} // namespace lixel::app
