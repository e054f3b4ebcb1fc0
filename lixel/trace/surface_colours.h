// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/view_samples.h"
#include "lixel/trace/trace_scene.h"

#include <vector>

namespace lixel {

// What a picture needs to know of its samples besides shadows; one entry a sample.
struct SurfaceColours
{
    std::vector<Vec3f> baseColour;    // linear: factor * vertex colour * base level of the texture, bilinear
    std::vector<Vec3f> emission;      // linear
    std::vector<Vec3f> shadingNormal; // unit, interpolated, turned to the side of the sample's normal
};

// Samples without a triangle get the default material and their own normal.
SurfaceColours surfaceColours(const TraceScene& scene, const ViewSamples& samples);

} // namespace lixel
