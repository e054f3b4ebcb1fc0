// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/rectangle.h"
#include "lixel/plan/fit/fit.h"

namespace lixel {

// Light-plane coordinates: where the light ray through a point meets a plane in front of the light, as homogeneous (x, y, w),
// with the depth along the light's axis. Points: perspective from the light, w = depth. Directions: parallel, w = 1. In these
// coordinates every fit is the same planar map for both.
struct LightFrame
{
    Mat4d framedFromLocal; // rows: x, y, depth, w
    bool isPerspective = false;
};

// `axisLocal` is a unit vector, the way light travels in the middle of the map; directional lights use their own direction.
LightFrame lightFrame(const Light& light, Vec3d originWorld, Vec3d axisLocal);

// Where a point lies on the light plane. Needs w > 0.
inline Vec2d onLightPlane(const LightFrame& frame, Vec3d pointLocal)
{
    const Vec4d q = frame.framedFromLocal * point(pointLocal);
    return {q.x / q.w, q.y / q.w};
}

// The narrowest cone from the apex that holds all points; cosHalfAngle is not above 0 where they do not fit a half-space.
// Needs a point.
struct DirectionCone
{
    Vec3d axis;
    double cosHalfAngle = 1;
};
DirectionCone coneAround(std::span<const Vec3d> pointsLocal, Vec3d apexLocal);

// The widest cone that one perspective map serves: its half angle stays below 88.8 degrees.
inline constexpr double kLeastCosHalfAngle = 0.02;

// The fit whose NDC square is the rectangle of the light plane. Near: the nearest caster box that reaches into the rectangle,
// not nearer than 1e-4 of the far depth for perspective; far: the given depth.
Fit fitRectangle(const LightFrame& frame, OrientedRectangle rectangle, double farDepth, const FitInput& input);

} // namespace lixel
