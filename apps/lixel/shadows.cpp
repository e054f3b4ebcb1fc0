// SPDX-License-Identifier: MIT
#include "shadows.h"

#include "exit_code.h"
#include "lixel/trace/exact_area.h"
#include "lixel/trace/exact_visibility.h"
#include "plan_file.h"

#include <algorithm>

#include <fmt/format.h>

namespace lixel::app {

namespace {

std::vector<GivenLight> readGiven(const Technique& technique)
{
    const auto* map = std::get_if<MapTechnique>(&technique);
    if (!map) return {};
    if (const auto* matrix = std::get_if<MatrixFit>(&map->fit)) return readPlanFile(matrix->file, false);
    if (const auto* plan = std::get_if<PlanFit>(&map->fit)) return readPlanFile(plan->file, true);
    return {};
}

} // namespace

std::vector<TechniqueChoice> readTechniques(const std::string& list)
{
    const auto texts = splitTechniques(list);
    if (!texts) throw UsageError(texts.error());
    std::vector<TechniqueChoice> out;
    for (const std::string& text : *texts) {
        const auto technique = parseTechnique(text);
        if (!technique) throw UsageError(technique.error());
        for (const TechniqueChoice& other : out)
            if (other.technique == *technique)
                throw UsageError(fmt::format("technique \"{}\" is the same as \"{}\"", text, other.typed));
        out.push_back({text, *technique, readGiven(*technique)});
    }
    return out;
}

std::optional<FramePlan> planFor(const TechniqueChoice& choice, const Stage& stage, const View& view,
                                 std::span<const Light> lights, const LixelBudget& lixels, const ViewSamples& seen)
{
    const auto* map = std::get_if<MapTechnique>(&choice.technique);
    if (!map) return std::nullopt;
    const SceneBuffers& buffers = stage.buffers;
    PlanInput input{view, lights, buffers.bounds.boxesWorld, buffers.triangles.originWorld, *map, lixels.total};
    input.seen = &seen;
    input.seenIsAll = true;
    input.lixelsOfRegions = lixels.ofRegions;
    input.given = choice.given;
    return planShadows(input);
}

std::vector<Visibility> visibilityByRays(const Technique& technique, const Stage& stage, const View& view,
                                         const ViewSamples& samples, std::span<const Light> lights)
{
    std::vector<Visibility> out;
    for (const Light& light : lights) {
        if (const auto* area = std::get_if<ExactAreaTechnique>(&technique))
            out.push_back({exactArea(*stage.traced, view, samples, light, area->samples), {}});
        else out.push_back({exactVisibility(*stage.traced, samples, light), {}});
    }
    return out;
}

ServedFootprints::ServedFootprints(const View& view, Vec3d originWorld, const ShadowPlan& plan)
    : view_(view), originWorld_(originWorld)
{
    for (const PlannedRegion& region : plan.regions)
        served_.push_back({LightImage(region.lightClipFromLocal, region.rectangle), region.halfSpacesLocal});
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
