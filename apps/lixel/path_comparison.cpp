// SPDX-License-Identifier: MIT
#include "path_comparison.h"

#include "lixel/judge/temporal.h"
#include "lixel/scene/framing.h"
#include "lixel/trace/exact_visibility.h"
#include "shadows.h"

#include <algorithm>

#include <fmt/format.h>

namespace lixel::app {
namespace {

using StatesOfLights = std::vector<std::vector<ShadowState>>; // [light][sample]

// One frame, as far as it does not depend on a technique.
struct Moment
{
    Stage stage;
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

// What becomes one row of the results, while frames are added to it.
struct Track
{
    ResultRow row;
    Measurement sum;
    Temporal temporal;
    ExecutorAgreement agreement;
    std::vector<double> pixelsPerLixel, lixelsPerPixel;
    std::vector<ShadowState> states; // of the frame before; empty where it was refused
    std::optional<Refusal> refusal;  // the last one
};

void add(SampleCount& sum, const SampleCount& more)
{
    sum.samples += more.samples;
    sum.misclassified += more.misclassified;
}

void add(Measurement& sum, const Measurement& more)
{
    sum.lightFacing += more.lightFacing;
    sum.misclassified += more.misclassified;
    sum.falseShadow += more.falseShadow;
    sum.falseLit += more.falseLit;
    sum.unserved += more.unserved;
    add(sum.edgeBand, more.edgeBand);
    add(sum.terminatorBand, more.terminatorBand);
    add(sum.interior, more.interior);
}

void add(FlipCount& sum, const ZoneFlips& more)
{
    sum.samples += more.samples;
    sum.flips += more.flips;
}

void add(ExecutorAgreement& sum, const ExecutorAgreement& more)
{
    sum.lightFacing += more.lightFacing;
    sum.agreeing += more.agreeing;
    sum.misclassifiedByEither += more.misclassifiedByEither;
    sum.misclassifiedByBoth += more.misclassifiedByBoth;
}

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
        : path_(path), executors_(executors), options_(options), onStep_(onStep),
          lights_(path.frames.front().shot.lights.size()),
          tracks_(options.techniques.size() * executors.size() * lights_)
    {
    }

    void addFrame(std::size_t number);
    std::vector<ResultRow> rows();

private:
    // Of one executor, technique and frame.
    struct Said
    {
        std::vector<Visibility> ofSamples, ofFollowed; // [light]
    };

    Moment momentOf(std::size_t number);
    Followed follow(const Moment& now) const;
    std::vector<Visibility> ask(Executor& executor, const TechniqueChoice& choice, const FramePlan* plan,
                                const Moment& now, const Followed& followed, const ViewSamples& all,
                                std::span<const Light> lights) const;
    void addTechnique(const ShotContext& context, std::size_t technique, std::size_t number, const Moment& now,
                      const Followed& followed, const ViewSamples& all);
    void addLight(Track& track, const ShotContext& context, std::size_t light, std::size_t number,
                  const FramePlan* plan, const Said& said, const Followed& followed);
    Track& trackOf(std::size_t technique, std::size_t executor, std::size_t light)
    {
        return tracks_[(technique * executors_.size() + executor) * lights_ + light];
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
    std::vector<Track> tracks_;
    std::optional<Moment> before_;
};

Moment PathComparison::momentOf(std::size_t number)
{
    const PathFrame& frame = path_.frames[number];
    Moment now;
    onStep_(nameOf(number, "view samples"));
    if (before_ && path_.frames[number - 1].evaluateOptions.time == frame.evaluateOptions.time)
        now.stage = before_->stage; // nothing has moved
    else now.stage = makeStage(path_.shooting.scene, frame.evaluateOptions, path_.originWorld);
    now.view = makeView(frame.shot.camera, path_.shooting.width, path_.shooting.height, frame.sceneWorld);
    now.samples = executors_.front()->viewSamples(now.stage, now.view);
    onStep_(nameOf(number, "exact visibility"));
    now.truth = findTruth(now.stage, now.samples, frame.shot.lights);
    for (std::size_t light = 0; light < lights_; ++light)
        now.exact.push_back(exactStates(now.truth.zones[light], now.truth.exact[light]));
    return now;
}

// Without exact visibility of the lights yet.
Followed PathComparison::follow(const Moment& now) const
{
    Followed out;
    if (!before_) {
        out.carried.samples.width = now.samples.width, out.carried.samples.height = now.samples.height;
        out.carried.samples.originWorld = now.samples.originWorld;
        return out;
    }
    const CarriedSamples inView =
        carry(before_->samples, before_->stage.buffers.triangles, now.stage.buffers.triangles, now.view);
    out.carried = keepOnly(inView, exactVisibility(*now.stage.traced, inView.samples, lightOfEye(now.view)));
    return out;
}

void PathComparison::addFrame(std::size_t number)
{
    Moment now = momentOf(number);
    const Shot& shot = path_.frames[number].shot;
    Followed followed = follow(now);
    for (const Light& light : shot.lights) {
        followed.exact.push_back(exactVisibility(*now.stage.traced, followed.carried.samples, light));
        followed.exactStates.push_back(exactStates(followed.carried.samples, light, followed.exact.back()));
    }
    const ViewSamples all = joined(now.samples, followed.carried.samples);
    const ShotContext context{path_.shooting, shot, now.stage, now.view, now.samples, now.truth, options_};
    for (std::size_t technique = 0; technique < options_.techniques.size(); ++technique)
        addTechnique(context, technique, number, now, followed, all);
    before_ = std::move(now);
}

// What the technique says of all samples. Exact visibility is known already.
std::vector<Visibility> PathComparison::ask(Executor& executor, const TechniqueChoice& choice, const FramePlan* plan,
                                            const Moment& now, const Followed& followed, const ViewSamples& all,
                                            std::span<const Light> lights) const
{
    if (plan) return executor.run(now.stage, *plan, all);
    if (!std::holds_alternative<ExactTechnique>(choice.technique))
        return visibilityByRays(choice.technique, now.stage, now.view, all, lights);
    std::vector<Visibility> out;
    for (std::size_t light = 0; light < lights_; ++light) {
        Visibility& exact = out.emplace_back(Visibility{now.truth.exact[light], {}});
        exact.value.insert(exact.value.end(), followed.exact[light].begin(), followed.exact[light].end());
    }
    return out;
}

void PathComparison::addTechnique(const ShotContext& context, std::size_t technique, std::size_t number,
                                  const Moment& now, const Followed& followed, const ViewSamples& all)
{
    const TechniqueChoice& choice = options_.techniques[technique];
    const auto plan = planFor(choice.technique, now.stage, now.view, context.shot.lights, options_.lixels);
    const FramePlan* const planOrNull = plan ? &*plan : nullptr;
    const bool isShown = number == path_.frames.size() / 2;
    std::vector<Said> said;
    for (std::size_t e = 0; e < executors_.size(); ++e) {
        Executor& executor = *executors_[e];
        onStep_(nameOf(number, fmt::format("{} ({})", choice.typed, executor.name())));
        Said& here = said.emplace_back();
        for (const Visibility& one :
             plan || e == 0 ? ask(executor, choice, planOrNull, now, followed, all, context.shot.lights)
                            : std::vector<Visibility>()) {
            const bool isThere = !one.value.empty(); // else its light was refused
            here.ofSamples.push_back(isThere ? part(one, 0, now.samples.size()) : Visibility{});
            here.ofFollowed.push_back(isThere ? part(one, now.samples.size(), all.size()) : Visibility{});
        }
        if (!plan && e > 0) here = said.front(); // rays do not depend on the executor
        std::vector<ResultRow> shown;
        if (isShown) shown = rowsOf(context, executor, choice, here.ofSamples, planOrNull);
        for (std::size_t light = 0; light < lights_; ++light) {
            Track& track = trackOf(technique, e, light);
            if (number == 0) track.row = keyOf(context, choice, light, executor.name());
            addLight(track, context, light, number, planOrNull, here, followed);
            const Measurement* const m = isShown ? shown[light].measured() : nullptr;
            if (m) track.sum.pictures = m->pictures, track.sum.timing = m->timing;
        }
    }
    if (said.size() != 2) return;
    for (std::size_t light = 0; light < lights_; ++light) {
        if (plan && plan->lights[light].refused) continue;
        const ExecutorAgreement counts = agreement(now.truth.zones[light], said[0].ofSamples[light],
                                                   said[1].ofSamples[light], now.truth.exact[light]);
        for (std::size_t e = 0; e < 2; ++e) add(trackOf(technique, e, light).agreement, counts);
    }
}

void PathComparison::addLight(Track& track, const ShotContext& context, std::size_t light, std::size_t number,
                              const FramePlan* plan, const Said& said, const Followed& followed)
{
    Temporal& temporal = track.temporal;
    ++temporal.frames;
    if (number > 0) temporal.pairs.push_back({path_.frames[number].time, {}});
    if (plan && plan->lights[light].refused) {
        const FitFailure reason = *plan->lights[light].refused;
        track.refusal = Refusal{std::string(lixel::nameOf(reason)), std::string(sentenceFor(reason))};
        ++temporal.refusedFrames;
        track.states.clear();
        return;
    }
    add(track.sum, measured(context, light, said.ofSamples[light]));
    if (plan) {
        track.sum.lixelsUsed = std::max(track.sum.lixelsUsed, std::int64_t(plan->lixelsOf(light)));
        track.sum.bytes = track.sum.lixelsUsed * plan->lookup.bytesPerLixel;
        const Density some = densityOf(context, plan->lights[light], light, number, path_.frames.size());
        track.pixelsPerLixel.insert(track.pixelsPerLixel.end(), some.pixelsPerLixel.begin(), some.pixelsPerLixel.end());
        track.lixelsPerPixel.insert(track.lixelsPerPixel.end(), some.lixelsPerPixelList.begin(),
                                    some.lixelsPerPixelList.end());
    }
    if (!track.states.empty()) {
        const std::vector<ShadowState> states = statesOf(said.ofFollowed[light]);
        const TemporalScore flips =
            temporalScore({track.states, before_->exact[light]}, before_->truth.zones[light],
                          {states, followed.exactStates[light]}, followed.carried.from);
        add(temporal.pairs.back().count, flips.all);
        add(temporal.all, flips.all);
        add(temporal.edgeBand, flips.edgeBand);
        add(temporal.terminatorBand, flips.terminatorBand);
        add(temporal.interior, flips.interior);
    }
    track.states = statesOf(said.ofSamples[light]);
}

std::vector<ResultRow> PathComparison::rows()
{
    std::vector<ResultRow> out;
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
        Track& track = tracks_[i];
        ResultRow& row = out.emplace_back(std::move(track.row));
        if (track.temporal.refusedFrames == track.temporal.frames) {
            row.outcome = *track.refusal;
            continue;
        }
        Measurement m = std::move(track.sum);
        m.footprintPixelsPerLixel = percentiles(std::move(track.pixelsPerLixel));
        m.densityLixelsPerPixel = percentiles(std::move(track.lixelsPerPixel));
        if (executors_.size() == 2)
            m.agreement = agreementWith(executors_[1 - i / lights_ % 2]->name(), track.agreement);
        m.temporal = std::move(track.temporal);
        m.temporal->fromSeconds = path_.frames.front().time;
        m.temporal->toSeconds = path_.frames.back().time;
        m.temporal->isStill = path_.isStill;
        row.outcome = std::move(m);
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
