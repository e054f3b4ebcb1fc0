// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/minimal_frustum.h"

#include "lixel/plan/fit/light_frame.h"
#include "lixel/plan/fit/visible_body.h"

namespace lixel {

FitResult fitMinimalFrustum(const FitInput& input)
{
    const auto body = visibleBody(input);
    if (!body) return Unexpected{body.error()};
    const OrientedRectangle rectangle = rectangleAround(*body, RectangleKind::LeastArea, input.scratch);
    const double far = farthestDepth(*body);

    // What is left of the boxes between the light and the farthest receiver, within the rectangle, has the near depth.
    const Mat4d roughly = fitRectangle(body->frame, rectangle, far, far, input).lightClipFromLocal;
    const double near = leastOverCasters(input, roughly, body->frame.framedFromLocal.row(2), far);
    return fitRectangle(body->frame, rectangle, near, far, input);
}

} // namespace lixel
