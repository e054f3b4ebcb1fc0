// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/lispsm.h"

#include "lixel/plan/fit/stable.h"

#include <cmath>
#include <limits>

namespace lixel {
namespace {

// Beyond so many lengths of the body the perspective changes lixels over the map by little more than a quarter along the line, (9/8)^2,
// and by an eighth across it.
constexpr double kFarthestCentre = 8;

FitResult fitSeen(const FitInput& input)
{
    const std::vector<Vec3d>& points = input.scratch.points;
    const auto body = frameAround(input, points);
    if (!body) return Unexpected{body.error()};
    const DepthSpan depths = seenDepths(input, viewDepth(input.view, input.originWorld), points);
    if (const auto line = lineOfSight(input, *body, depths)) {
        const double distance = lispsmDistance(body->frame, *line, depths);
        if (distance < kFarthestCentre * line->length) return fitAlong(input, *body, *line, distance);
    }
    return fitTightly(*body, RectangleKind::LeastArea, input);
}

} // namespace

double lispsmDistance(const LightFrame& frame, const LineOfSight& line, const DepthSpan& depths)
{
    const Vec4d w = frame.framedFromLocal.row(3);
    const auto weight = [&](double depth) { return dot(w, point(line.at(depth))) / std::sqrt(depth); };
    const double near = weight(depths.nearest), far = weight(depths.farthest);
    if (!(near > far) || !(line.sineSquared > 0)) return std::numeric_limits<double>::infinity();
    const double t =
        placeAlong(line, frame, line.at(depths.farthest)) - placeAlong(line, frame, line.at(depths.nearest));
    return t * far / (near - far) / line.sineSquared;
}

FitResult fitLispsm(const FitInput& input)
{
    if (input.sceneLocal.isEmpty()) return Unexpected{FitFailure::EmptyScene};
    if (input.isStable) return fitHeld(input, fitSeen);
    findVisiblePoints(input, input.scratch.points);
    if (input.scratch.points.empty()) return Unexpected{FitFailure::NothingInView};
    return fitSeen(input);
}

} // namespace lixel
