// SPDX-License-Identifier: MIT
#include "shadows.h"

#include "lixel/trace/exact_area.h"
#include "lixel/trace/exact_visibility.h"

#include <algorithm>

namespace lixel::app {

std::optional<FramePlan> planFor(const Technique& technique, const Stage& stage, const View& view,
                                 std::span<const Light> lights, LixelSize lixels, const ViewSamples& seen)
{
    const auto* map = std::get_if<MapTechnique>(&technique);
    if (!map) return std::nullopt;
    const SceneBuffers& buffers = stage.buffers;
    PlanInput input{view, lights, buffers.bounds.boxesWorld, buffers.triangles.originWorld, *map, lixels};
    input.seen = &seen;
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
