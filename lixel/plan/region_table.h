// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/shadow_plan.h"

namespace lixel {

// A region as shaders read it. Its half-spaces are counted in the plan's one array and are the caller's, and so are its knots.
shared::ShadowRegion tableRow(const PlannedRegion& region);

} // namespace lixel
