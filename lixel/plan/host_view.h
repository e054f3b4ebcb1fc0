// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/view.h"
#include "lixel/plan/clip_convention.h"

#include <optional>

// A host's camera as a View, in whatever convention the host draws: perspective, orthographic, off-centre, jittered, with an
// oblique near plane, with an infinite far plane; its view space may be right- or left-handed and look along any axis. The
// matrices are those that the picture is drawn with. `width` and `height` are the picture's pixels.
//
//   Needs    what is inside has w > 0 in the host's clip space (all APIs clip so)
//   Returns  a View whose eye is found from the matrix: the point that x, y and w of clip space send to 0, or for parallel
//            projections (w the same everywhere) the direction that they do, turned to where depth shrinks
//   Refuses  nothing comes back where a matrix is singular or not finite, or width or height is not positive
namespace lixel {

// clip = hostClipFromView * viewFromWorld * pointWorld. `viewFromWorld` is affine; kept apart, since the product of both
// rounds the eye's place, which far from the world's origin is all there is.
std::optional<View> viewFromHost(const Mat4d& hostClipFromView, const Mat4d& viewFromWorld, const ClipConvention& host,
                                 int width, int height);

// clip = hostClipFromAnchored * (pointWorld - anchorWorld): for hosts that draw relative to the camera (the anchor), and with
// an anchor of 0 for those that only know clipFromWorld.
std::optional<View> viewFromHost(const Mat4d& hostClipFromAnchored, Vec3d anchorWorld, const ClipConvention& host,
                                 int width, int height);

} // namespace lixel
