// SPDX-License-Identifier: MIT
#include "shadows.h"

#include "lixel/trace/exact_area.h"
#include "lixel/trace/exact_visibility.h"

namespace lixel::app {

std::optional<FramePlan> planFor(const Technique& technique, const Stage& stage, const View& view,
                                 std::span<const Light> lights, LixelSize lixels)
{
    const auto* map = std::get_if<MapTechnique>(&technique);
    if (!map) return std::nullopt;
    const SceneBuffers& buffers = stage.buffers;
    return planShadows({view, lights, buffers.bounds.boxesWorld, buffers.triangles.originWorld, *map, lixels});
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
    for (const PlannedRegion& region : plan.regions) images_.emplace_back(region.lightClipFromLocal, region.rectangle);
}

std::optional<Footprint> ServedFootprints::at(Vec3d pointLocal, Vec3d normal) const
{
    for (const LightImage& image : images_)
        if (const auto found = footprint(view_, originWorld_, image, pointLocal, normal)) return found;
    return std::nullopt;
}

} // namespace lixel::app
