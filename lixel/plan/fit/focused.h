// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/fit/fit.h"

namespace lixel {

// The map spent only on what can be seen: the scene's boxes, each clipped by the view frustum and by the light's cone and
// range, in the rectangle of least area on the light plane.
//
//   S. Brabec, T. Annen, H.-P. Seidel. Practical Shadow Mapping. JGT 7(4), 2002; called "Focused" by
//   H. Chong, S. Gortler. Scene Optimized Shadow Mapping. 2007.
//
//   Needs    a scene
//   Returns  all receivers in view inside the square; depth from the nearest caster box before it to the farthest receiver
//   Refuses  NothingInView; ExtentNotInHemisphere, when that surrounds a point light or nearly so; EmptyScene
//   Differs  Brabec takes the upright rectangle and directional or spot lights only; points look along the axis of the
//            narrowest cone. One box a mesh instead of one for the scene leaves out the empty space between them
//   Stable   see stable.h
FitResult fitFocused(const FitInput& input);

} // namespace lixel
