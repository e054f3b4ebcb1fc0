// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/fit/along_view.h"
#include "lixel/plan/fit/fit.h"

namespace lixel {

// Light space perspective: a perspective across the light, along the line of sight, as strong as makes near and far errors equal.
//
//   M. Wimmer, D. Scherzer, W. Purgathofer. Light Space Perspective Shadow Maps. EGSR 2004: the best distance n of the
//   perspective's centre from the body is (z_n + sqrt(z_n z_f)) / sin(gamma), section 4.
//
//   Needs    a scene; view samples, where given, say the nearest and farthest depth that is seen
//   Returns  as focused, with lixels smaller where the picture is near
//   Refuses  NothingInView; ExtentNotInHemisphere; EmptyScene
//   Differs  z_n is the nearest visible depth, not the view's near side. Lights at a point are not made directional: on the
//            light plane, where a point at depth z of the line of sight lies at t(z) and its light frame's depth changes by
//            the factor 1 + k z, errors along the line go with (n + t)^2 (1 + k z)^2 / z; equal at z_n and z_f they give
//            n = T a_f / (a_n - a_f) / sin(gamma)^2 with a = (1 + k z) / sqrt(z), T = t(z_f) - t(z_n). For parallel light, k = 0,
//            this is the paper's n. Where light and line of sight align, n grows; beyond 8 times the body it is focused
//   Stable   the map of a held view: see stable.h
FitResult fitLispsm(const FitInput& input);

// n for a line of sight; infinite where no perspective helps.
double lispsmDistance(const LightFrame& frame, const LineOfSight& line, const DepthSpan& depths);

} // namespace lixel
