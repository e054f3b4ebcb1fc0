// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/uniform.h"

#include "lixel/plan/fit/light_frame.h"

#include <algorithm>

namespace lixel {

FitResult fitUniform(const FitInput& input)
{
    if (input.sceneLocal.isEmpty()) return Unexpected{FitFailure::EmptyScene};
    const auto corners = input.sceneLocal.corners();
    const Vec3d lightLocal = input.light.positionWorld - input.originWorld;

    if (input.light.kind == LightKind::Spot) {
        const LightFrame frame = lightFrame(input.light, input.originWorld, input.light.directionWorld);
        double far = 0;
        for (const Vec3d& p : corners) far = std::max(far, dot(p - lightLocal, input.light.directionWorld));
        if (std::isfinite(input.light.range)) far = std::min(far, input.light.range);
        if (!(far > 0)) return Unexpected{FitFailure::NothingInView};
        if (std::cos(input.light.coneAngle / 2) < kLeastCosHalfAngle)
            return Unexpected{FitFailure::ExtentNotInHemisphere};
        const double half = std::tan(input.light.coneAngle / 2);
        return fitRectangle(frame, {{0, 0}, {1, 0}, {half, half}}, far, input);
    }

    Vec3d axis = input.light.directionWorld;
    if (input.light.kind == LightKind::Point) {
        const DirectionCone cone = coneAround(corners, lightLocal);
        if (cone.cosHalfAngle < kLeastCosHalfAngle) return Unexpected{FitFailure::ExtentNotInHemisphere};
        axis = cone.axis;
    }
    const LightFrame frame = lightFrame(input.light, input.originWorld, axis);
    std::array<Vec2d, 8> onPlane;
    double far = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 8; ++i) {
        onPlane[i] = onLightPlane(frame, corners[i]);
        far = std::max(far, (frame.framedFromLocal * point(corners[i])).z);
    }
    return fitRectangle(frame, rectangleAlong(onPlane, {1, 0}), far, input);
}

} // namespace lixel
