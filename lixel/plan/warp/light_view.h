// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/light.h"
#include "lixel/base/view.h"
#include "lixel/plan/shadow_plan.h"

#include <optional>

// What forward analysis looks through (P. Rosen 2012): the scene as the light sees it.
namespace lixel {

// A region's map before its warp, as a view with a pixel a lixel; its originWorld is the plan's.
View lightViewOf(const PlannedRegion& region, const Light& light, Vec3d originWorld);

// A technique whose warp analyses what the light sees, without its warp: the plan of it, with so many lixels a light, has
// the maps to look through. They are drawn, and count. Nothing where the technique does not ask for it.
struct LightLook
{
    MapTechnique technique;
    LixelSize lixels;
};
std::optional<LightLook> lightLookOf(const MapTechnique& technique, LixelSize lixels);

} // namespace lixel
