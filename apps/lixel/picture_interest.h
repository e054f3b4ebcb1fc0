// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/light.h"
#include "lixel/base/view.h"
#include "lixel/trace/trace_scene.h"

namespace lixel::app {

// How much a picture has to show, to choose between framings; only the order of values means something. It grows with
//   the share of neighbouring pixels with a contour (a jump in depth, or a crease) between them,
//   twice the share with the border of a shadow between them, on one smooth surface,
//   the square root of the median distance: of two pictures as rich, the one that shows more of the place;
// and falls with the square of the share of pixels nearer than `tooNear`, where things stand in the way, and where less
// than a third is lit. A view of some thousand pixels is enough.
double pictureInterest(const TraceScene& scene, const View& view, Vec3d eyeWorld, const Light& light, double tooNear);

} // namespace lixel::app
