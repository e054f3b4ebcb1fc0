// SPDX-License-Identifier: MIT
#include "shadows.h"

#include "exit_code.h"
#include "lixel/base/assert.h"
#include "lixel/plan/lookup/lookup.h"
#include "lixel/plan/observe.h"
#include "lixel/plan/warp/light_view.h"
#include "lixel/trace/exact_area.h"
#include "lixel/trace/exact_filtered.h"
#include "lixel/trace/exact_visibility.h"
#include "plan_file.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace lixel::app {

namespace {

std::vector<GivenLight> readGiven(const Technique& technique, const std::filesystem::path& folder)
{
    const std::string file = fileNamedBy(technique);
    if (file.empty()) return {};
    return readPlanFile((folder / file).string(), std::holds_alternative<PlanFit>(mapsOf(technique)->fit));
}

// What a plan is made from, without memory.
PlanInput inputFor(const MapTechnique& technique, const TechniqueChoice& choice, const PlanSubject& subject,
                   const LixelBudget& lixels)
{
    const SceneBuffers& buffers = subject.stage.buffers;
    PlanInput input{subject.view, subject.lights, buffers.bounds.boxesWorld, buffers.triangles.originWorld,
                    technique,    lixels.total};
    input.seen = &subject.seen;
    input.seenIsAll = true;
    input.planes = subject.planes;
    input.lixelsOfRegions = lixels.ofRegions;
    input.given = choice.given;
    return input;
}

// What the lights see through a technique's maps, and the lixels that it takes.
struct LightSight
{
    std::vector<std::vector<ViewSamples>> seen;
    std::int64_t lixels = 0; // of each light
};

LightSight lookFromLights(const LightLook& look, PlanInput input, const PlanSubject& subject, Executor& executor)
{
    input.technique = look.technique;
    input.lixels = look.lixels;
    input.lixelsOfRegions = {};
    input.lixelsSpent = 0;
    const FramePlan plan = planShadows(input);
    LightSight sight{{}, std::int64_t(look.lixels.width) * look.lixels.height};
    for (std::size_t i = 0; i < plan.lights.size(); ++i) {
        std::vector<ViewSamples>& ofLight = sight.seen.emplace_back();
        for (const PlannedRegion& region : plan.lights[i].regions)
            ofLight.push_back(
                executor.viewSamples(subject.stage, lightViewOf(region, subject.lights[i], plan.originWorld)));
    }
    return sight;
}

// With what the technique's warp wants to know of the lights' own view.
FramePlan planWithLights(PlanInput input, const PlanSubject& subject, Executor& executor)
{
    const auto look = lightLookOf(input.technique, input.lixels);
    if (!look) return planShadows(input);
    const LightSight sight = lookFromLights(*look, input, subject, executor);
    input.seenByLights = sight.seen;
    input.lixelsSpent += sight.lixels;
    return planShadows(input);
}

} // namespace

std::string fileNamedBy(const Technique& technique)
{
    const MapTechnique* map = mapsOf(technique);
    if (!map) return {};
    if (const auto* matrix = std::get_if<MatrixFit>(&map->fit)) return matrix->file;
    if (const auto* plan = std::get_if<PlanFit>(&map->fit)) return plan->file;
    return {};
}

TechniqueChoice chooseTechnique(const std::string& text, const std::filesystem::path& folder)
{
    const auto technique = parseTechnique(text);
    if (!technique) throw UsageError(technique.error());
    return {text, *technique, readGiven(*technique, folder)};
}

std::vector<TechniqueChoice> readTechniques(const std::string& list)
{
    const auto texts = splitTechniques(list);
    if (!texts) throw UsageError(texts.error());
    std::vector<TechniqueChoice> out;
    for (const std::string& text : *texts) {
        TechniqueChoice choice = chooseTechnique(text);
        for (const TechniqueChoice& other : out)
            if (other.technique == choice.technique)
                throw UsageError(fmt::format("technique \"{}\" is the same as \"{}\"", text, other.typed));
        out.push_back(std::move(choice));
    }
    return out;
}

void expectPlanes(std::span<const TechniqueChoice> techniques, const Shooting& shooting)
{
    std::string known;
    for (const NamedPlane& plane : shooting.planes) known += (known.empty() ? "" : ", ") + oneLine(plane.name);
    for (const TechniqueChoice& choice : techniques) {
        const MapTechnique* map = mapsOf(choice.technique);
        const auto* planes = map ? std::get_if<PlanesPartition>(&map->partition) : nullptr;
        if (!planes) continue;
        for (const std::string& name : planes->names)
            if (std::ranges::none_of(shooting.planes, [&](const NamedPlane& plane) { return plane.name == name; }))
                throw UsageError(fmt::format(
                    "technique \"{}\": {} has no plane \"{}\" ({}); a view file can name planes", choice.typed,
                    shooting.sceneName, name, known.empty() ? "it names none" : "it has: " + known));
    }
}

std::optional<FramePlan> planFor(const TechniqueChoice& choice, const PlanSubject& subject, const LixelBudget& lixels,
                                 Executor& executor, const PlanMemory& memory)
{
    const MapTechnique* map = mapsOf(choice.technique);
    if (!map) return std::nullopt;
    PlanInput input = inputFor(*map, choice, subject, lixels);
    const auto first = firstPassOf(*map, lixels.total);
    input.before = memory.before;
    if (memory.observed) input.observed = &*memory.observed;
    if (!first || memory.observed) return planWithLights(input, subject, executor);

    PlanInput firstInput = input;
    firstInput.technique = first->technique;
    firstInput.lixels = first->lixels;
    firstInput.lixelsOfRegions = {};
    const FramePlan firstPlan = planShadows(firstInput);
    std::vector<Visibility> visibility = executor.run(subject.stage, firstPlan, subject.seen);
    for (Visibility& light : visibility) light.value.resize(subject.seen.size(), 0.0f);
    const Observation observed = observe(subject.seen, subject.view, subject.lights, visibility, first->grid);
    input.observed = &observed;
    input.lixelsSpent = std::int64_t(first->lixels.width) * first->lixels.height;
    return planWithLights(input, subject, executor);
}

std::optional<WarpLayout> warpLayoutFor(const TechniqueChoice& choice, const PlanSubject& subject,
                                        const LixelBudget& lixels)
{
    const auto* map = std::get_if<MapTechnique>(&choice.technique);
    if (!map) return std::nullopt;
    FitScratch scratch;
    return layoutWarps(inputFor(*map, choice, subject, lixels), scratch);
}

PlanMemory memoryOf(const TechniqueChoice& choice, const PlanSubject& subject, const FramePlan& plan,
                    std::span<const Visibility> visibility)
{
    const MapTechnique* map = mapsOf(choice.technique);
    const auto first = map ? firstPassOf(*map, {1, 1}) : std::nullopt;
    if (!first) return {};
    std::vector<Visibility> all(visibility.begin(), visibility.end());
    for (Visibility& light : all) light.value.resize(subject.seen.size(), 0.0f);
    PlanMemory memory{rememberedBy(plan), observe(subject.seen, subject.view, subject.lights, all, first->grid)};
    memory.observed->ageFrames = 1;
    return memory;
}

Expected<std::vector<Visibility>, Refusal> visibilityWithoutMap(const Technique& technique, Executor& executor,
                                                                const Stage& stage, const View& view,
                                                                const ViewSamples& samples,
                                                                std::span<const Light> lights, const FramePlan* plan)
{
    if (std::holds_alternative<ShadowVolumesTechnique>(technique))
        return executor.shadowVolumes(stage, view, lights, samples);
    const auto* area = std::get_if<ExactAreaTechnique>(&technique);
    const auto* filtered = std::get_if<ExactFilteredTechnique>(&technique);
    LX_ASSERT(!filtered || plan);
    std::vector<Visibility> out(lights.size());
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const TraceScene& scene = *stage.traced;
        if (area) out[i].value = exactArea(scene, view, samples, lights[i], area->samples);
        else if (!filtered) out[i].value = exactVisibility(scene, samples, lights[i]);
        else if (!plan->lights[i].refused)
            out[i].value = exactFiltered(scene, plan->lights[i], samples, lights[i], filterOf(plan->lookup),
                                         int(std::lround(std::sqrt(double(filtered->rays)))));
    }
    return out;
}

ServedFootprints::ServedFootprints(const View& view, Vec3d originWorld, const ShadowPlan& plan)
    : view_(view), originWorld_(originWorld)
{
    for (const PlannedRegion& region : plan.regions)
        served_.push_back({LightImage(region.projection(), region.rectangle, &region.warp), region.halfSpacesLocal});
}

std::optional<Footprint> ServedFootprints::at(Vec3d pointLocal, Vec3d normal) const
{
    for (const Served& served : served_) {
        const auto isOutside = [&](const Plane& plane) { return plane.signedDistance(pointLocal) < 0; };
        if (std::any_of(served.halfSpacesLocal.begin(), served.halfSpacesLocal.end(), isOutside)) continue;
        if (const auto found = footprint(view_, originWorld_, served.image, pointLocal, normal)) return found;
    }
    return std::nullopt;
}

} // namespace lixel::app
