// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/focused.h"

#include "lixel/plan/fit/light_frame.h"
#include "lixel/plan/fit/stable.h"
#include "lixel/plan/fit/visible_body.h"

namespace lixel {

FitResult fitFocused(const FitInput& input)
{
    if (input.sceneLocal.isEmpty()) return Unexpected{FitFailure::EmptyScene};
    std::vector<Vec3d>& points = input.scratch.points;
    findVisiblePoints(input, points);
    if (points.empty()) return Unexpected{FitFailure::NothingInView};
    if (input.isStable) return fitStable(input);
    const auto body = frameAround(input, points);
    if (!body) return Unexpected{body.error()};
    return fitTightly(*body, RectangleKind::LeastArea, input);
}

} // namespace lixel
