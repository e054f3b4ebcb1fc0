// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/view.h"
#include "lixel/trace/surface_point.h"
#include "lixel/trace/trace_scene.h"

#include <optional>
#include <span>
#include <vector>

namespace lixel {

// What is seen through one point of the picture: from the near plane (t = 0) to the far plane. Local.
struct ViewRay
{
    Vec3d origin, direction; // unit
    double tFar = 0;         // infinite where the far plane is
};

// Any projective view: rays come from the inverse of its matrix.
class ViewRays
{
public:
    ViewRays(const View& view, Vec3d originWorld); // asserts that the matrix is invertible

    // `pixel` is continuous, (0, 0) at the picture's lower left corner. Nothing where the near plane is not in front (w
    // <= 0).
    std::optional<ViewRay> through(Vec2d pixel) const;

private:
    Mat4d anchoredFromClip_;
    Vec3d anchorLocal_;
    double width_, height_;
};

// The nearest surface through each point of the picture, nothing where there is none. Triangles are found by float rays
// without gaps; the point on the triangle is worked out in double and rounded once.
std::vector<std::optional<SurfacePoint>> seenThrough(const TraceScene& scene, const ViewRays& rays,
                                                     std::span<const Vec2d> pixels);

} // namespace lixel
