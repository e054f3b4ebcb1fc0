// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/minimal_frustum.h"

#include "lixel/plan/fit/light_frame.h"
#include "lixel/plan/fit/visible_body.h"

#include <algorithm>

namespace lixel {

FitResult fitMinimalFrustum(const FitInput& input)
{
    if (input.sceneLocal.isEmpty()) return Unexpected{FitFailure::EmptyScene};
    std::vector<Vec3d>& points = input.scratch.points;
    findVisiblePoints(input, points);
    if (points.empty()) return Unexpected{FitFailure::NothingInView};
    const auto frame = frameAround(input, points);
    if (!frame) return Unexpected{frame.error()};

    const OrientedRectangle rectangle = rectangleAround(*frame, points, RectangleKind::LeastArea, input.scratch);
    const double far = farthestDepth(*frame, points);

    // What is left of the boxes between the light and the farthest receiver, within the rectangle, has the near depth.
    findCasterPoints(input, fitRectangle(*frame, rectangle, far, far).lightClipFromLocal, input.scratch.casterPoints);
    double near = far;
    const Vec4d depth = frame->framedFromLocal.row(2);
    for (const Vec3d& p : input.scratch.casterPoints) near = std::min(near, dot(depth, point(p)));
    return fitRectangle(*frame, rectangle, near, far);
}

} // namespace lixel
