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
//   Returns  as focused, with lixels smaller where the picture is near. Focused itself where no perspective helps: n is beyond 8
//            times the body's length along the line, which it comes to as light and line of sight align; a = (1 + k z) / sqrt(z),
//            below, is no greater near than far; and where there is no such line (along_view.h), as of parallel views
//   Refuses  NothingInView; ExtentNotInHemisphere; EmptyScene
//   Differs  z_n is the nearest visible depth, not the view's near side. Lights at a point are not made directional: on the
//            light plane, where a point at depth z of the line of sight lies at t(z) and its light frame's depth changes by
//            the factor 1 + k z, errors along the line go with (n + t)^2 (1 + k z)^2 / z; equal at z_n and z_f they give
//            n = T a_f / (a_n - a_f) / sin(gamma)^2, T = t(z_f) - t(z_n). For parallel light, k = 0, this is the paper's n. Gamma
//            is that at the geometric mean of z_n and z_f; the body, which n is counted from, may begin before z_n. Where it comes to be
//            focused the map turns, from upright along the line of sight to the rectangle of least area
//   Stable   the map of a held view: see stable.h
FitResult fitLispsm(const FitInput& input);

// n for a line of sight; infinite where no perspective helps.
double lispsmDistance(const LightFrame& frame, const LineOfSight& line, const DepthSpan& depths);

} // namespace lixel
