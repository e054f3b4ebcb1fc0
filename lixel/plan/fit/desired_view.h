// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/fit/fit.h"

namespace lixel {

// The map cut down to the view samples themselves: their rectangle on the light plane, upright or of least area.
//
//   P. Rosen. Rectilinear Texture Warping for Fast Adaptive Shadow Mapping. I3D 2012 ("desired view");
//   T. Milet, J. Navratil, P. Zemcik. An Improved Non-Orthogonal Texture Warping for Better Shadow Rendering. 2015,
//   section 3.2: by parallel reduction over the view samples.
//
//   Needs    view samples that face the light (FitInput::seenLocal), all that will be asked
//   Returns  every given sample inside the square; depth from the nearest caster box before it to the farthest sample.
//            Samples that were not given may fall outside: give them all, or say what serves them with else(...)
//   Refuses  NoViewSamples; ExtentNotInHemisphere; EmptyScene; NothingInView, where no sample faces the light
//   Differs  rotated is not in the papers: they take columns and rows of the map as they are
FitResult fitDesiredView(const FitInput& input, bool isRotated);

} // namespace lixel
