// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/light.h"
#include "lixel/base/view_samples.h"
#include "lixel/trace/trace_scene.h"

#include <vector>

namespace lixel {

// The ground truth: one value a sample, 1 where nothing stands between it and the light, 0 in shadow and where the
// sample is not light-facing. Embree only finds the triangles near each ray; which of them blocks it is decided in
// double (shadow_ray.h), so that neither self-hits nor gaps between neighbours occur. An occluder behind a light at a
// point does not count, nor does a surface the light lies in.
//
// Samples and scene share their originWorld. The result does not depend on the number of threads.
std::vector<float> exactVisibility(const TraceScene& scene, const ViewSamples& samples, const Light& light);

} // namespace lixel
