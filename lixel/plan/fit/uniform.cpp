// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/uniform.h"

#include "lixel/plan/fit/light_frame.h"
#include "lixel/plan/fit/visible_body.h"

#include <algorithm>
#include <cmath>

namespace lixel {
namespace {

FitResult fitCone(const FitInput& input)
{
    const Light& light = input.light;
    const LightFrame frame = lightFrame(light, input.originWorld, light.directionWorld);
    const Vec3d lightLocal = light.positionWorld - input.originWorld;
    double far = 0;
    for (const Vec3d& p : input.sceneLocal.corners()) far = std::max(far, dot(p - lightLocal, light.directionWorld));
    if (std::isfinite(light.range)) far = std::min(far, light.range);
    if (!(far > 0)) return Unexpected{FitFailure::NothingInView};
    if (std::cos(light.coneAngle / 2) < kLeastCosHalfAngle) return Unexpected{FitFailure::ExtentNotInHemisphere};
    const double half = std::tan(light.coneAngle / 2);
    return fitRectangle(frame, {{0, 0}, {1, 0}, {half, half}}, far, input);
}

} // namespace

FitResult fitUniform(const FitInput& input)
{
    if (input.sceneLocal.isEmpty()) return Unexpected{FitFailure::EmptyScene};
    std::vector<Vec3d>& points = input.scratch.points;
    if (input.cellLocal.empty()) {
        if (input.light.kind == LightKind::Spot) return fitCone(input);
        const auto corners = input.sceneLocal.corners();
        points.assign(corners.begin(), corners.end());
    } else {
        findReachedPoints(input, points);
    }
    if (points.empty()) return Unexpected{FitFailure::NothingInView};
    const auto body = frameAround(input, points);
    if (!body) return Unexpected{body.error()};
    return fitTightly(*body, RectangleKind::Upright, input);
}

} // namespace lixel
