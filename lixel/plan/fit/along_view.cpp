// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/along_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lixel {

namespace {

// A surface nearer to the eye than this part of the farthest depth counts as so far away: a perspective made for it would leave no
// lixels for the rest, and would be made of rounding.
constexpr double kLeastNearPerFar = 1e-6;

// A line of sight whose image is so short against the body's runs along the light but for rounding.
constexpr double kLeastOfBody = 1e-9;

} // namespace

DepthSpan seenDepths(const FitInput& input, const ViewDepth& depth, std::span<const Vec3d> visiblePoints)
{
    DepthSpan range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const Vec3d& p : input.seenLocal.empty() ? visiblePoints : input.seenLocal) {
        range.nearest = std::min(range.nearest, depth.of(p));
        range.farthest = std::max(range.farthest, depth.of(p));
    }
    if (depth.isPerspective) range.nearest = std::max(range.nearest, kLeastNearPerFar * range.farthest);
    return range;
}

std::optional<LineOfSight> lineOfSight(const FitInput& input, const FramedBody& body, const DepthSpan& depths)
{
    const LightFrame& frame = body.frame;
    const ViewDepth depth = viewDepth(input.view, input.originWorld);
    if (!depth.isPerspective || !(depths.nearest > 0) || !(depths.farthest > depths.nearest)) return std::nullopt;
    const Mat4d clip = clipFromLocal(input.view, input.originWorld);
    const Vec3d across = cross(xyz(clip.row(0)), xyz(clip.row(1))); // x = 0 and y = 0 meet along it
    LineOfSight line;
    line.eyeLocal = xyz(eyeLocal(input.view, input.originWorld));
    line.perDepth = (1 / dot(across, depth.forward)) * across;

    const Vec3d near = line.at(depths.nearest), far = line.at(depths.farthest);
    const Vec4d w = frame.framedFromLocal.row(3);
    if (!(dot(w, point(near)) > 0) || !(dot(w, point(far)) > 0)) return std::nullopt;
    const Vec2d from = onLightPlane(frame, near), to = onLightPlane(frame, far);
    const double size = length(to - from);
    if (!(size > 1e-9 * (length(from) + length(to)))) return std::nullopt;
    line.along = (1 / size) * (to - from);
    line.aside = cross(from, line.along);

    double last = -std::numeric_limits<double>::infinity();
    line.first = std::numeric_limits<double>::infinity();
    for (const Vec3d& p : body.corners) {
        const double t = dot(line.along, onLightPlane(frame, p));
        line.first = std::min(line.first, t);
        last = std::max(last, t);
    }
    line.length = last - line.first;
    if (!(size > kLeastOfBody * line.length)) return std::nullopt;
    // Rectangles are never smaller than floats resolve; a body that is has no room for a centre before it.
    const Vec2d half = rectangleAround(body, RectangleKind::LeastArea, input.scratch).halfSize;
    if (line.length < std::min(half.x, half.y)) return std::nullopt;
    const Vec3d middle = line.at(std::sqrt(depths.nearest * depths.farthest));
    const Vec3d turn = cross(normalized(line.perDepth), towardsLight(input.light, input.originWorld, middle));
    line.sineSquared = dot(turn, turn);
    return line;
}

double placeAlong(const LineOfSight& line, const LightFrame& frame, Vec3d pointLocal)
{
    return dot(line.along, onLightPlane(frame, pointLocal)) - line.first;
}

Fit fitAlong(const FitInput& input, const FramedBody& body, const LineOfSight& line, double distance)
{
    // From the centre, t along the line and s across it: s / t' and t / t' with t' = 1 + t / distance, so that no digits
    // are lost as the centre goes to infinity. The depth of the map's plane does not matter.
    const Vec2d a = line.along, across{a.y, -a.x};
    const Vec3d along{a.x, a.y, -line.first};
    const PlaneWarp warp{{across.x, across.y, -line.aside}, along, (1 / distance) * along + Vec3d{0, 0, 1}};
    const FramedBody perspective =
        warped(body, warp).value_or(body); // t' >= 1: its horizon is elsewhere but for rounding
    return fitTightly(perspective, RectangleKind::Upright, input);
}

} // namespace lixel
