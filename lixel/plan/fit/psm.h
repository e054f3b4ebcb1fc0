// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/fit/fit.h"

namespace lixel {

enum class PsmShift {
    Casters, // the virtual camera starts so far back that it has all casters in front of it (the paper)
    None     // it starts where the view's stands
};

// Perspective shadow map: the map as the light sees the scene after the view's own perspective.
//
//   M. Stamminger, G. Drettakis. Perspective Shadow Maps. SIGGRAPH 2002, section 4.1 (the camera moved back before the casters);
//   S. Kozlov. Perspective Shadow Maps: Care and Feeding. GPU Gems, 2004, chapter 14.2 (virtual cameras, the light's camera).
//   Neither numbers equations. The virtual camera stands s behind the eye on the line of sight, with x and y as the view has them and
//   w = d + s, d being the depth along that line; its z goes from -1 to +1 between the nearest and the farthest depth that is seen.
//   The light, brought through the same matrix, looks at the middle of that cube, and its image of what may be seen is framed.
//
//   Needs    a scene; view samples, where given, say the nearest and farthest depth that is seen
//   Returns  as focused, across the image that the light has of the scene in the virtual camera's NDC. Focused itself for parallel
//            views, which have no perspective, where all that is seen has one depth, and where no virtual camera serves
//   Refuses  NothingInView; EmptyScene; ExtentNotInHemisphere
//   Camera   s starts at 0, with PsmShift::Casters at what keeps all casters between the light and what is seen 1/1000 of the
//            farthest depth before the camera. Where the light lies within or beside what is
//            seen after the perspective, some of it 88.8 degrees aside or more (Kozlov splits it over a cube there), s becomes
//            2 s and a sixteenth of the farthest depth: 16 cameras are tried
//   Differs  After the view's perspective a direction is a light at a point; one behind the viewer becomes its opposite, with the
//            order along its rays turned round, and rays that cross the plane of the eye pass through infinity. Here only the
//            image across the light is taken from that space; depth is the light's own, or for lights at a point the new w, which
//            is 0 at the light and grows along every ray. Neither has those flaws: casters behind the viewer lie where they
//            should without a shift, a light behind needs no inversion, and one in the plane of the eye is no special case.
//            The shift still decides how strong the perspective is. The camera's near side is the nearest visible depth, not
//            the view's
FitResult fitPsm(const FitInput& input, PsmShift shift);

} // namespace lixel
