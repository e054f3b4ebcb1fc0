// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/mat4.h"

namespace lixel {

// What the picture is taken through: any invertible projective matrix (off-centre, oblique, jittered, orthographic), in
// lixel's one convention: NDC x, y, z in [-1, +1], y up, depth growing away from the eye, inside where w > 0.
//
// Matrices are kept relative to an anchor (the eye, for views made here), so that a view 1e5 units from the origin is as
// precise as one at it: clip = clipFromAnchored * (pointWorld - anchorWorld).
struct View
{
    Mat4d clipFromAnchored;
    Vec3d anchorWorld;
    Vec4d eyeAnchored{0, 0, 0, 1}; // a point (w = 1), or for orthographic views the direction towards the eye (w = 0)
    int width = 0, height = 0;     // pixels; pixel (i, j) is at (i + 1/2, j + 1/2), row 0 at the bottom
};

Mat4d clipFromWorld(const View& view);
Mat4d clipFromLocal(const View& view, Vec3d originWorld); // Local = World - originWorld
Vec4d eyeLocal(const View& view, Vec3d originWorld);

// Towards the eye from a point; not normalised for perspective views.
Vec3d towardsEye(const View& view, Vec3d originWorld, Vec3d pointLocal);

// The view in pixels: (x, y) in [0, width] x [0, height], z the NDC depth. Needs w > 0.
Vec3d pixelFromLocal(const View& view, Vec3d originWorld, Vec3d pointLocal);

// A symmetric perspective. `fovy` in radians, in (0, pi); 0 < near < far, far may be infinite. `up` must not be along the
// line of sight. Asserts on anything else: callers check user input first (see isValidLookAt, isValidPerspective).
View perspectiveView(Vec3d eyeWorld, Vec3d targetWorld, Vec3d up, double fovy, double near, double far, int width,
                     int height);

// A parallel projection; `height` in world units, near < far along the line of sight.
View orthographicView(Vec3d eyeWorld, Vec3d targetWorld, Vec3d up, double heightWorld, double near, double far,
                      int width, int height);

// Rotation whose rows are right, up and backward of someone at the origin looking along `forward`.
Mat4d eyeFromWorldRotation(Vec3d forward, Vec3d up);

} // namespace lixel
