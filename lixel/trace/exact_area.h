// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/light.h"
#include "lixel/base/view.h"
#include "lixel/base/view_samples.h"
#include "lixel/trace/trace_scene.h"

#include <vector>

namespace lixel {

// What `exact-area(n)` says: of all that a pixel shows and that faces the light, the share that is lit; one value a
// sample.
//
//   The pixel that holds the sample is divided into sqrt(n) x sqrt(n) equal squares. A ray of the view through each
//   centre finds the nearest surface, whichever it is: the pixel's own, or another one past an edge. Of these points
//   the light-facing ones are counted, and of those the ones with exact visibility 1.
//
// 0 where the sample itself is not light-facing; its exact visibility where none of the points is. `n` is a square
// number, at least 1. `view` is the one the samples are of.
std::vector<float> exactArea(const TraceScene& scene, const View& view, const ViewSamples& samples, const Light& light,
                             int n);

} // namespace lixel
