// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/fit/light_frame.h"
#include "lixel/plan/fit/visible_body.h"

#include <optional>
#include <span>

// What light-space perspective maps and trapezoidal maps share: a perspective of the light plane whose centre lies on the image
// of the line of sight, behind what is seen.
namespace lixel {

// The depths between which something is seen: of the view samples where there are any, else of the visible body. Of perspective
// views what is nearer than a millionth of the farthest counts as so far away.
DepthSpan seenDepths(const FitInput& input, const ViewDepth& depth, std::span<const Vec3d> visiblePoints);

// The line of sight through the picture's middle as it lies on the light plane, and what is seen along it.
struct LineOfSight
{
    Vec2d along;              // unit, from near to far
    double aside = 0;         // where the line lies across `along`
    double first = 0;         // least coordinate along it of the visible body ...
    double length = 0;        // ... and how far the body goes on
    double sineSquared = 0;   // of the angle between light and line of sight, at the geometric mean of the two depths
    Vec3d eyeLocal, perDepth; // the line itself: eyeLocal + depth * perDepth

    Vec3d at(double depth) const { return eyeLocal + depth * perDepth; }
};

// Nothing for parallel views, where both depths are one, where the line runs along the light or out of its half-space between the
// two, and where the body's image is a point, or a line across this one, but for rounding.
std::optional<LineOfSight> lineOfSight(const FitInput& input, const FramedBody& body, const DepthSpan& depths);

// Where a point lies along the line, from the start of the body.
double placeAlong(const LineOfSight& line, const LightFrame& frame, Vec3d pointLocal);

// The perspective whose centre is `distance` before the start of the body, framed upright along the line. With distance to
// infinity it is the parallel map in the same orientation. Where rounding leaves nothing of the perspective, as from a centre a millionth of
// the body's length before it, the map is upright in the body's own frame.
Fit fitAlong(const FitInput& input, const FramedBody& body, const LineOfSight& line, double distance);

} // namespace lixel
