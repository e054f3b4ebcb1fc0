// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/view_samples.h"
#include "lixel/base/visibility.h"
#include "lixel/plan/shadow_plan.h"
#include "lixel/trace/prepared_maps.h"
#include "lixel/trace/trace_scene.h"

#include <cstddef>
#include <vector>

// The executor without OpenGL: does what a plan says by rays. It decides nothing about shadows.
namespace lixel {

// Samples, scene and plan share their originWorld, here and below.
TracedAtlas traceAtlas(const TraceScene& scene, const FramePlan& plan);

// What the maps say of one light: each sample looks itself up in the first region that holds it, by
// lixel/shared/lookup/visibility.h. In no region, and where the light's plan was refused, a sample is lit and marked unserved.
// `prepared` is prepareMaps() of the same maps.
Visibility lookUp(const FramePlan& plan, const TracedAtlas& atlas, const PreparedMaps& prepared,
                  const ViewSamples& samples, std::size_t light);

// All of it: one visibility a light.
std::vector<Visibility> runTraced(const TraceScene& scene, const FramePlan& plan, const ViewSamples& samples);

} // namespace lixel
