// SPDX-License-Identifier: MIT
#include "comparison.h"

#include "exit_code.h"
#include "lixel/report/false_colour.h"
#include "lixel/report/png.h"
#include "lixel/trace/exact_visibility.h"
#include "plane_errors.h"
#include "shade_quality.h"
#include "shadows.h"
#include "text.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace lixel::app {

ResultRow keyOf(const ShotContext& context, const TechniqueChoice& choice, std::size_t light, std::string_view executor)
{
    ResultRow row;
    row.scene = context.shooting.sceneName;
    row.view = context.shot.name;
    row.light = context.shot.lights[light].name;
    row.technique = choice.typed;
    row.techniqueFull = toString(choice.technique);
    row.lixels = toString(context.options.lixels);
    row.size = fmt::format("{}x{}", context.shooting.width, context.shooting.height);
    row.executor = executor;
    return row;
}

std::optional<Percentiles> percentiles(std::vector<double> values)
{
    if (values.empty()) return std::nullopt;
    std::sort(values.begin(), values.end());
    const auto at = [&](double share) {
        return values[std::min(values.size() - 1, std::size_t(share * double(values.size())))];
    };
    return Percentiles{at(0.01), at(0.1), at(0.5), at(0.9), at(0.99), values.back()};
}

Density densityOf(const ShotContext& context, const ShadowPlan& plan, std::size_t light, std::size_t first,
                  std::size_t step)
{
    Density out;
    out.pixelsPerLixel = out.lixelsPerPixel =
        Image<float>(context.samples.width, context.samples.height, std::numeric_limits<float>::quiet_NaN());
    const ServedFootprints footprints(context.view, context.samples.originWorld, plan);
    for (std::size_t i = first; i < context.samples.size(); i += step) {
        if (context.truth.zones[light][i] == Zone::FacingAway) continue;
        const auto f = footprints.at(toDouble(context.samples.positionLocal[i]), toDouble(context.samples.normal[i]));
        if (!f) continue;
        const int x = int(context.samples.pixel[i].x), y = int(context.samples.pixel[i].y);
        out.pixelsPerLixel(x, y) = float(f->pixelsPerLixel);
        out.lixelsPerPixel(x, y) = float(f->lixelsPerPixel);
        out.pixelsPerLixelList.push_back(f->pixelsPerLixel);
        out.lixelsPerPixelList.push_back(f->lixelsPerPixel);
    }
    return out;
}

Agreement agreementWith(std::string_view other, const ExecutorAgreement& a, const LixelAgreement& lixels)
{
    return {std::string(other), a.agreementPercent(),
            a.misclassifiedByEither > 0 ? std::optional(a.sharedMisclassifiedPercent()) : std::nullopt,
            lixels.lixels > 0 ? std::optional(lixels.percent()) : std::nullopt};
}

Measurement measured(const ShotContext& context, std::size_t light, const Visibility& visibility)
{
    const Score s = score(context.truth.zones[light], visibility, context.truth.exact[light]);
    Measurement m;
    m.lightFacing = s.lightFacing;
    m.misclassified = s.misclassified;
    m.falseShadow = s.falseShadow;
    m.falseLit = s.falseLit;
    m.unserved = s.unserved;
    m.edgeBand = {s.edgeBand.samples, s.edgeBand.misclassified};
    m.terminatorBand = {s.terminatorBand.samples, s.terminatorBand.misclassified};
    m.interior = {s.interior.samples, s.interior.misclassified};
    const std::span<const NamedPlane> planes = context.shooting.planes;
    if (planes.empty()) return m;
    const std::vector<ZoneScore> onPlanes = scoreOfPlanes(
        context.truth.plane, planes.size(), context.truth.zones[light], visibility.value, context.truth.exact[light]);
    for (std::size_t i = 0; i < onPlanes.size(); ++i)
        m.planes.push_back(
            {i < planes.size() ? planes[i].name : "", {onPlanes[i].samples, onPlanes[i].misclassified}, {}});
    return m;
}

namespace {

Image<Verdict> verdicts(const ShotContext& context, std::size_t light, const Visibility& visibility)
{
    Image<Verdict> out(context.samples.width, context.samples.height, Verdict::NotCounted);
    for (std::size_t i = 0; i < context.samples.size(); ++i)
        out(int(context.samples.pixel[i].x), int(context.samples.pixel[i].y)) =
            verdictOf(context.truth.zones[light][i], visibility.value[i], context.truth.exact[light][i]);
    return out;
}

// Writes pictures under names that tell what they are, and remembers them by their path below the run's folder.
class PictureWriter
{
public:
    // The number keeps apart what differs in signs only.
    PictureWriter(const ShotContext& context, const TechniqueChoice& choice, std::string_view executor)
        : folder_(context.options.pictures),
          stem_(fmt::format("{}-{}-{}-{}", slug(context.shot.name), &choice - context.options.techniques.data(),
                            slug(choice.typed), executor))
    {
    }

    bool isWanted() const { return !folder_.empty(); }
    std::string write(const Image<Rgba8>& picture, std::string_view what) const
    {
        const std::string name = fmt::format("pictures/{}-{}.png", stem_, what);
        writePng(folder_ / name, picture);
        return name;
    }

private:
    std::filesystem::path folder_;
    std::string stem_;
};

// A found plane that is one of the scene's has its name; others have numbers.
std::string nameOfPlane(int plane, const ShotContext& context, const FramePlan& plan, std::size_t light)
{
    if (plane < 0) return "";
    const std::span<const NamedPlane> named = context.shooting.planes;
    const std::vector<FoundPlane>& found = plan.lights[light].foundPlanes;
    if (found.empty()) return named[std::size_t(plane)].name;
    const Plane& p = found[std::size_t(plane)].planeLocal;
    const double near = 1e-4 * length(context.shooting.sceneWorld.max - context.shooting.sceneWorld.min);
    for (const NamedPlane& one : named)
        if (dot(one.normalWorld, p.normal) > 1 - 1e-6 &&
            std::abs(p.signedDistance(one.pointWorld - plan.originWorld)) < near)
            return one.name;
    return fmt::format("plane {}", plane + 1);
}

// Why samples on planes with a lixel a pixel are wrong, where some are.
void addCauses(const ShotContext& context, const FramePlan& plan, std::size_t light, const Visibility& visibility,
               Measurement& m)
{
    std::vector<Verdict> verdict(context.samples.size());
    for (std::size_t i = 0; i < verdict.size(); ++i)
        verdict[i] = verdictOf(context.truth.zones[light][i], visibility.value[i], context.truth.exact[light][i]);
    const auto causes = causesOfPlaneErrors({*context.stage.traced, plan, light, context.shot.lights[light],
                                             context.samples, context.truth.plane, verdict, context.truth.exact[light]},
                                            context.shooting.planes.size());
    for (std::size_t i = 0; i < causes.size(); ++i) m.planes[i].causes = causes[i];
}

// What the map of a light costs, and how its lixels lie on the picture.
void addMap(const ShotContext& context, const FramePlan& plan, std::size_t light, const PictureWriter& pictures,
            const std::string& lightName, Measurement& m)
{
    m.lixelsUsed = plan.lixelsOf(light);
    m.bytes = m.lixelsUsed * plan.lookup.bytesPerLixel;
    for (const PlannedRegion& region : plan.lights[light].regions)
        m.regions.push_back(
            {nameOfPlane(region.plane, context, plan, light), region.rectangle.width(), region.rectangle.height()});
    for (const LeftOutPlane& left : plan.lights[light].leftOut)
        m.leftOut.push_back({nameOfPlane(left.plane, context, plan, light), std::string(nameOf(left.why))});
    const std::size_t step = pictures.isWanted() ? 1 : context.options.footprintStep;
    Density density = densityOf(context, plan.lights[light], light, 0, step);
    if (pictures.isWanted()) {
        m.pictures.footprint = pictures.write(footprintPicture(density.pixelsPerLixel), lightName + "-footprint");
        m.pictures.density = pictures.write(densityPicture(density.lixelsPerPixel), lightName + "-density");
    }
    m.footprintPixelsPerLixel = percentiles(std::move(density.pixelsPerLixelList));
    m.densityLixelsPerPixel = percentiles(std::move(density.lixelsPerPixelList));
}

} // namespace

std::vector<ResultRow> rowsOf(const ShotContext& context, Executor& executor, const TechniqueChoice& choice,
                              std::span<const Visibility> visibility, const FramePlan* plan)
{
    const PictureWriter pictures(context, choice, executor.name());
    const bool servesAny = !plan || plan->layers > 0, hasMaps = hasMap(choice.technique);
    std::string shaded;
    if (pictures.isWanted() && servesAny)
        shaded = pictures.write(
            executor.shade(context.stage, context.view, context.shot.lights, context.samples, visibility), "shaded");
    RowTiming timing;
    const int frames = context.options.timingFrames;
    if (hasMaps && servesAny && frames > 0) timing = executor.time(context.stage, *plan, context.view, frames);
    if (std::holds_alternative<ShadowVolumesTechnique>(choice.technique) && frames > 0)
        timing = executor.timeVolumes(context.stage, context.view, context.shot.lights, frames, false);

    std::vector<ResultRow> rows;
    for (std::size_t light = 0; light < context.shot.lights.size(); ++light) {
        ResultRow& row = rows.emplace_back(keyOf(context, choice, light, executor.name()));
        if (plan && plan->lights[light].refused) {
            const FitFailure reason = *plan->lights[light].refused;
            row.outcome = Refusal{std::string(nameOf(reason)), std::string(sentenceFor(reason))};
            continue;
        }
        Measurement m = measured(context, light, visibility[light]);
        if (hasMaps) addCauses(context, *plan, light, visibility[light], m);
        m.timing = timing;
        m.pictures.shaded = shaded;
        const std::string lightName = fmt::format("{}-{}", light, slug(row.light));
        if (pictures.isWanted())
            m.pictures.error =
                pictures.write(errorPicture(verdicts(context, light, visibility[light])), lightName + "-error");
        if (hasMaps) addMap(context, *plan, light, pictures, lightName, m);
        if (!context.truth.partial.empty()) m.shades = shadeQuality(context, visibility[light], plan, light);
        row.outcome = std::move(m);
    }
    return rows;
}

namespace {

// Rows of the two executors side by side carry how far they agree.
void addAgreement(const ShotContext& context, const FramePlan* plan, std::vector<ResultRow>& rows,
                  std::span<const std::vector<Visibility>> visibility,
                  std::span<const std::unique_ptr<Executor>> executors)
{
    const std::size_t lights = context.shot.lights.size();
    std::vector<std::vector<Image<float>>> maps;
    for (std::size_t e = 0; e < 2 && plan; ++e) maps.push_back(executors[e]->maps(context.stage, *plan));
    for (std::size_t e = 0; e < 2; ++e)
        for (std::size_t light = 0; light < lights; ++light) {
            auto* m = std::get_if<Measurement>(&rows[e * lights + light].outcome);
            if (!m || visibility[1 - e][light].value.empty()) continue; // one of them refuses
            const ExecutorAgreement a = agreement(context.truth.zones[light], visibility[0][light],
                                                  visibility[1][light], context.truth.exact[light]);
            m->agreement =
                agreementWith(executors[1 - e]->name(), a,
                              plan ? lixelAgreement(plan->lights[light], maps[0], maps[1]) : LixelAgreement{});
        }
}

Expected<std::vector<Visibility>, Refusal> withoutMap(const ShotContext& context, const Technique& technique,
                                                      Executor& executor, const FramePlan* plan)
{
    if (!std::holds_alternative<ExactTechnique>(technique))
        return visibilityWithoutMap(technique, executor, context.stage, context.view, context.samples,
                                    context.shot.lights, plan);
    std::vector<Visibility> out;
    for (const std::vector<float>& exact : context.truth.exact) out.push_back({exact, {}});
    return out;
}

std::vector<ResultRow> refusedRows(const ShotContext& context, const TechniqueChoice& choice, const Executor& executor,
                                   const Refusal& refusal)
{
    std::vector<ResultRow> rows;
    for (std::size_t light = 0; light < context.shot.lights.size(); ++light)
        rows.emplace_back(keyOf(context, choice, light, executor.name())).outcome = refusal;
    return rows;
}

// The rows of one technique: executors x lights.
std::vector<ResultRow> rowsOfAll(const ShotContext& context, std::span<const std::unique_ptr<Executor>> executors,
                                 const TechniqueChoice& choice, const std::function<void(std::string_view)>& onStep)
{
    const PlanSubject subject{context.stage, context.view, context.shot.lights, context.shooting.planes,
                              context.samples};
    const auto planned = planFor(choice, subject, context.options.lixels, *executors.front(), context.options.memory);
    const FramePlan* const plan = planned ? &*planned : nullptr;
    std::vector<ResultRow> rows;
    std::vector<std::vector<Visibility>> visibility;
    for (const auto& executor : executors) {
        onStep(fmt::format("{}: {} ({})", context.shot.name, choice.typed, executor->name()));
        // Rays say the same for all executors.
        const bool hasMaps = hasMap(choice.technique);
        const bool isKnown =
            !visibility.empty() && !hasMaps && !std::holds_alternative<ShadowVolumesTechnique>(choice.technique);
        Expected<std::vector<Visibility>, Refusal> answer =
            hasMaps   ? executor->run(context.stage, *plan, context.samples)
            : isKnown ? visibility.front()
                      : withoutMap(context, choice.technique, *executor, plan);
        std::vector<ResultRow> some = answer ? rowsOf(context, *executor, choice, *answer, plan)
                                             : refusedRows(context, choice, *executor, answer.error());
        visibility.push_back(answer ? std::move(answer).value() : std::vector<Visibility>(context.shot.lights.size()));
        rows.insert(rows.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
    }
    if (executors.size() == 2) addAgreement(context, plan ? &*plan : nullptr, rows, visibility, executors);
    return rows;
}

} // namespace

Truth findTruth(const Stage& stage, const ViewSamples& samples, std::span<const Light> lights,
                std::span<const NamedPlane> planes)
{
    Truth truth;
    truth.plane = planeOfSamples(samples, planes);
    for (const Light& light : lights) {
        truth.exact.push_back(exactVisibility(*stage.traced, samples, light));
        truth.zones.push_back(zonesOf(samples, light, truth.exact.back()));
    }
    return truth;
}

std::vector<ResultRow> compareTechniques(const ShotContext& context,
                                         std::span<const std::unique_ptr<Executor>> executors,
                                         const std::function<void(std::string_view)>& onStep)
{
    std::vector<ResultRow> all;
    for (const TechniqueChoice& choice : context.options.techniques) {
        std::vector<ResultRow> rows = rowsOfAll(context, executors, choice, onStep);
        all.insert(all.end(), std::make_move_iterator(rows.begin()), std::make_move_iterator(rows.end()));
    }
    return all;
}

int stepsPerShot(std::size_t executors, const ComparisonOptions& options)
{
    return 2 + int(options.techniques.size() * executors);
}

std::vector<ResultRow> compareShot(const Shooting& shooting, const Shot& shot, const Stage& stage, const View& view,
                                   std::span<const std::unique_ptr<Executor>> executors,
                                   const ComparisonOptions& options,
                                   const std::function<void(std::string_view)>& onStep)
{
    onStep(shot.name + ": view samples");
    const ViewSamples samples = executors.front()->viewSamples(stage, view);
    onStep(shot.name + ": exact visibility");
    Truth truth = findTruth(stage, samples, shot.lights, shooting.planes);
    if (options.withShades) truth.partial = findPartialTruth(stage, view, samples, shot.lights, truth);
    return compareTechniques({shooting, shot, stage, view, samples, truth, options}, executors, onStep);
}

} // namespace lixel::app
