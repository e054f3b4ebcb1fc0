// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/fit/visible_body.h"

#include <optional>

// Maps that do not crawl: as the camera moves or turns, the edges of still shadows stay where they are. The price is sharpness.
namespace lixel {

// focused(stable). Parallel light: the square around the sphere around the view frustum (the region's slice of it), whose size
// does not change as the camera moves, nor by jitter of up to half a pixel; place() moves it by whole lixels of a grid fixed in the world. Where the whole scene is no
// larger than that, and for lights at a point, it is the uniform map, which does not depend on the camera at all.
//
//   M. Valient. Stable Rendering of Cascaded Shadow Maps. ShaderX 6, 2008.
//
//   Refuses  as uniform; NothingInView
FitResult fitStable(const FitInput& input);

// For fits whose perspective follows the camera: the fit of a held view, which stays as it is while the camera moves within a
// step of a grid (1/20 of the scene's diagonal) and turns within a step of 1/88 circle (1/14 radian) of yaw, pitch and roll, as long as
// the scene's diagonal and the view's opening and near side stay, and holds every such view. Jitter, of up to half a pixel, is no
// change. At a step all of the map changes. Cells that follow the camera would move such maps with it: it is for all of space. `fit`
// finds scratch.points filled with what the held view sees, and no view samples, which would change from frame to frame.
//
//   Refuses  as the fit of the held view, which sees more than the camera
//   Limits   a camera that sways across a border of steps changes the map each time. Borders are half a step from views along the
//            world's axes, half-way between two of them, and upright with y or z up: a yaw of 1/16 circle is one, as is half a step from
//            any multiple of the step in the world, and a near side of 0.76 of a power of two. Pictures off centre by more than jitter
//            have one every 1/64 of their side, which jitter may cross
FitResult fitHeld(const FitInput& input, FitResult (*fit)(const FitInput&));

// How deep a camera in the scene may ever see, whichever way it looks: between the view's near side and its far side, or the scene's
// diagonal and an eighth beyond the near side. Farther for a camera outside the scene by more than that eighth, in steps of
// the square root of two.
DepthSpan stableDepths(const FitInput& input);

// The held view itself: the picture, widened by the turns and seen from so far behind the step's cell that every camera in it sees
// nothing else. Nothing for parallel views, for those too wide to widen (some 68 degrees of square pictures, 81 of flat ones, from
// the line of sight to a side), and without a step; fitHeld() is fitStable() there.
std::optional<View> heldView(const View& view, double gridStep);

} // namespace lixel
