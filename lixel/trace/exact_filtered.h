// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/light.h"
#include "lixel/base/view_samples.h"
#include "lixel/plan/lookup/lookup.h"
#include "lixel/plan/shadow_plan.h"
#include "lixel/trace/trace_scene.h"

#include <vector>

namespace lixel {

// What a filter of lixels stands for: the share of its own footprint that is lit, exactly; one value a sample.
//
//   The filter's square around the sample's place in the light image of the region that serves it is divided into n x n equal
//   squares. The light's ray through each centre meets the receiver's plane in a point; these points, as far as they face the light,
//   are counted, and of those the ones with exact visibility 1.
//
// 0 where the sample itself is not light-facing; its exact visibility where no region serves it. The plane of a receiver that curves
// towards the light lies below it, and is dark there, as it is to every filter of depths.
std::vector<float> exactFiltered(const TraceScene& scene, const ShadowPlan& plan, const ViewSamples& samples,
                                 const Light& light, const LixelFilter& filter, int n);

} // namespace lixel
