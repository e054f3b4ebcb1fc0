// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/shadow_plan.h"
#include "lixel/trace/trace_scene.h"

#include <vector>

// What there is about a sample on a plane whose lixels are its pixels, to tell rounding from errors.
namespace lixel {

struct PlaneProbe
{
    std::vector<float>
        exactBeside; // exact visibility of points that far along +-x and +-y of the light image, on the plane
    bool isNearCaster =
        false; // the sample's light ray meets a caster so near to the plane that the lookup, in an ideal map,
               // takes it for the plane
};

// Needs a region with pixelPlaneLocal, one of the plan's for the light.
PlaneProbe probeOnPlane(const TraceScene& scene, const FramePlan& plan, std::size_t lightNumber, std::size_t region,
                        const Light& light, const ViewSamples& samples, std::size_t sample, double besideLixels);

} // namespace lixel
