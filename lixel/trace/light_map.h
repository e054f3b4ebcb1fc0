// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/image.h"
#include "lixel/plan/shadow_plan.h"
#include "lixel/trace/trace_scene.h"

#include <vector>

namespace lixel {

// The ideal shadow map of a region: one ray through each lixel centre, from the light on, against all casters. Writes
// the depth of the first surface that the ray meets, reversed (1 at the near side, 0 at the far), into the region's
// rectangle of `layer`; lixels that meet nothing, or lie where w <= 0, become 0.
//
// Triangles are found by float rays without gaps; depths are worked out in double from the triangle's plane and rounded
// once. Where a lixel is a pixel (PlannedRegion::pixels), which triangle is met is decided in double too, by the very test of
// exact visibility: rays of floats stray at edges by up to a thousandth of a pixel. What lies before the near side counts as drawn at it (depth 1), as with depth clamping.
void traceLightMap(const TraceScene& scene, const PlannedRegion& region, Image<float>& layer);

// The same of one lixel alone, decided in double.
float tracedDepth(const TraceScene& scene, const PlannedRegion& region, int x, int y);

} // namespace lixel
