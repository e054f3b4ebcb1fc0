// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/minimal_frustum.h"

#include "lixel/plan/fit/light_frame.h"
#include "lixel/plan/fit/visible_body.h"

namespace lixel {

FitResult fitMinimalFrustum(const FitInput& input)
{
    if (input.sceneLocal.isEmpty()) return Unexpected{FitFailure::EmptyScene};
    std::vector<Vec3d>& points = input.scratch.points;
    findVisiblePoints(input, points);
    if (points.empty()) return Unexpected{FitFailure::NothingInView};
    const auto body = frameAround(input, points);
    if (!body) return Unexpected{body.error()};
    const OrientedRectangle rectangle = rectangleAround(*body, RectangleKind::LeastArea, input.scratch);
    const double far = farthestDepth(*body);

    // What is left of the boxes between the light and the farthest receiver, within the rectangle, has the near depth.
    const Mat4d roughly = fitRectangle(body->frame, rectangle, far, far, input).lightClipFromLocal;
    const double near = leastOverCasters(input, roughly, body->frame.framedFromLocal.row(2), far);
    return fitRectangle(body->frame, rectangle, near, far, input);
}

} // namespace lixel
