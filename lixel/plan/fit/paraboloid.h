// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/fit/fit.h"

namespace lixel {

// What the map of a paraboloid holds.
enum class ParaboloidExtent {
    Scene,  // the whole half sphere, as `uniform`
    Body,   // what may be seen, as `focused`
    Samples // the view samples, as `desired-view`
};

// The half sphere of light rays around an axis, and beyond its rim as far as the map's corners reach.
//
//   S. Brabec, T. Annen, H.-P. Seidel. Shadow Mapping for Hemispherical and Omnidirectional Light Sources. CGI 2002.
//
//   Needs    a light with a place; the region's half-space through it, across the axis (FitInput::cellLocal)
//   Returns  Fit::paraboloid: of Scene the square around the disc of the half sphere; of Body that around the narrowest cone of
//            what may be seen, as far as the disc goes; of Samples the upright rectangle around them. Depth from the nearest
//            caster, or 1e-4 of the way to the farthest point of those, on to that point
//   Refuses  EmptyScene, NothingInView, NoViewSamples
//   Differs  Brabec's depth is linear in the distance, where this is linear in one over it: then a plane's depth is linear in rays.
//            His map is the disc in its square; the corners beyond the rim are drawn here too, so that lookups reach over it
FitResult fitParaboloid(const FitInput& input, Vec3d axisLocal, ParaboloidExtent extent);

} // namespace lixel
