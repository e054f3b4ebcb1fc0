// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/fit/fit.h"

#include <optional>

namespace lixel {

// Trapezoidal map: the trapezoid around the visible body on the light plane, with its axis along the line of sight, becomes the
// square, so strongly that a focus point comes to lie at 80 % of the map's height.
//
//   T. Martin, T.-S. Tan. Anti-aliasing and Continuity with Trapezoidal Shadow Maps. EGSR 2004, sections 4 and 5: with
//   lambda the trapezoid's height and delta the focus point's distance from the top line, the centre lies
//   eta = lambda delta (1 + xi) / (lambda - 2 delta - lambda xi), xi = -0.6, before the top line.
//
//   Needs    a scene; view samples, where given, say the nearest and farthest depth that is seen
//   Returns  as focused, with four fifths of the map for what is nearer than the focus point. Focused itself where that lies at or
//            beyond four fifths of the body anyway or before its start, and without a line of sight (along_view.h)
//   Refuses  NothingInView; ExtentNotInHemisphere; EmptyScene
//   Differs  the body is what is visible, not the whole view frustum. Depth needs no second map (section 6): ours is
//            constant along rays. Without `focusDepth` (world units from the eye along the line of sight, clamped to what is
//            seen) the focus point is at the geometric mean of the nearest and the farthest visible depth, where the paper leaves it
//            to the user
FitResult fitTsm(const FitInput& input, std::optional<double> focusDepth);

// eta; infinite where the focus point lies at or beyond 80 % of the trapezoid as it is.
double tsmDistance(double lambda, double delta);

} // namespace lixel
