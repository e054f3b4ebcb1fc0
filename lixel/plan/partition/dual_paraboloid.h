// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/partition/partition.h"

namespace lixel {

// Two half spheres of light rays, each with its paraboloid (fit/paraboloid.h).
//
//   S. Brabec, T. Annen, H.-P. Seidel. Shadow Mapping for Hemispherical and Omnidirectional Light Sources. CGI 2002.
//
//   Returns  two cells that meet in the plane through the light across an axis: a spot's own, so that one paraboloid holds all of it
//            (Brabec's hemispherical light), else the first of the world. A cell that nothing visible lies in gets no map
//   Refuses  NoPlaceOfLight, for directional lights
CellsResult splitDualParaboloid(const FitInput& input);

} // namespace lixel
