// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/partition/partition.h"

namespace lixel {

// The six faces of a cube around the light, for lights that one perspective map cannot serve.
//
//   S. Brabec, T. Annen, H.-P. Seidel compare them (Shadow Mapping for Hemispherical and Omnidirectional Light Sources. CGI
//   2002); the faces are those of environment maps (N. Greene. IEEE CG&A 6(11), 1986).
//
//   Needs    nothing but the light
//   Returns  a cell for each face, four half-spaces through the light, along the axes of the world; a spot's cube stands on
//            its own axis. Faces that nothing visible lies in get no map, since their fit finds nothing in view. Directional
//            lights have one cell
//   Refuses  nothing
//   Differs  a cell holds more than it serves, for the rounding of floats: tangents to its four sides are 1 + 1e-4, not 1
CellsResult splitCube(const FitInput& input);

} // namespace lixel
