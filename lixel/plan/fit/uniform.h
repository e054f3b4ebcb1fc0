// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/fit/fit.h"

namespace lixel {

// The map that the papers call "normal": the whole scene as the light sees it, whatever the view.
//
//   L. Williams. Casting Curved Shadows on Curved Surfaces. SIGGRAPH 1978.
//
//   Needs    a scene
//   Returns  directional: the upright rectangle of the scene's box across the light; spot: the square of its cone;
//            point: the upright rectangle around the scene's box. In a region with half-spaces: the upright rectangle
//            around what the light reaches there
//   Refuses  ExtentNotInHemisphere, for a point light that the scene surrounds or nearly so, and for a spot wider than 177.7
//            degrees; EmptyScene; NothingInView, where the light reaches nothing of the region, or all of the scene is behind a spot
//   Differs  Williams has spots only; sides of the rectangle lie along arbitrary but fixed directions across the light. Points look
//            along the axis of the narrowest cone
FitResult fitUniform(const FitInput& input);

} // namespace lixel
