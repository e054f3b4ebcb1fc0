// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/fit/fit.h"

namespace lixel {

enum class PsmShift {
    Casters, // the virtual camera stands far enough back to have all casters in front of it (the paper)
    None     // it stands where the view's does
};

// Perspective shadow map: the map as the light sees the scene after the view's own perspective.
//
//   M. Stamminger, G. Drettakis. Perspective Shadow Maps. SIGGRAPH 2002; S. Kozlov. Perspective Shadow Maps: Care and
//   Feeding. GPU Gems, 2004.
//
//   Needs    a scene; view samples, where given, say the nearest and farthest depth that is seen
//   Returns  as focused, across the image that the light has of the scene in the view's NDC
//   Refuses  NothingInView; EmptyScene; ExtentNotInHemisphere
//   Differs  After the view's perspective a direction is a light at a point; one behind the viewer becomes its opposite, with the
//            order along its rays turned round, and rays that cross the plane of the eye pass through infinity. Here only the
//            image across the light is taken from that space; depth is the light's own, which has neither flaw: casters
//            behind the viewer lie where they should without a shift, a light behind needs no inversion, and one in the plane of
//            the eye is no special case. The shift still decides how strong the perspective is. Where the light lies within or
//            beside what is seen after the perspective (Kozlov splits it over a cube there), the camera moves back until it does
//            not; with the camera at infinity the map is focused. So it is for parallel views, which have no
//            perspective. The near side is the nearest visible depth
FitResult fitPsm(const FitInput& input, PsmShift shift);

} // namespace lixel
