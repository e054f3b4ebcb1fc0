// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/fit/fit.h"

namespace lixel {

// The smallest frustum that holds the extent of M. Stamminger and G. Drettakis (Perspective Shadow Maps. SIGGRAPH 2002,
// section 4.1): view frustum, scene and the light's reach clipped against each other, drawn out towards the light and cut by the
// scene again, so that all visible receivers are in and all casters that shadow them, in the picture or not. The rectangle
// of least area by rotating calipers and the tight near and far sides are those of "MIN-SM": T. Milet, J. Navratil, P. Zemcik. An Improved
// Non-Orthogonal Texture Warping for Better Shadow Rendering. 2015, section 3.2.
//
//   Needs    a scene
//   Returns  as focused, with the near side at the nearest part of a caster box that lies between the light and the map's
//            receivers, where focused takes the nearest corner of such a box
//   Refuses  NothingInView; ExtentNotInHemisphere; EmptyScene
//   Differs  the scene is its boxes, one a mesh, not its one box. Drawing a body out towards the light does not change its image
//            on the light plane, so across the light this is focused; the papers compare with looser focusing
FitResult fitMinimalFrustum(const FitInput& input);

} // namespace lixel
