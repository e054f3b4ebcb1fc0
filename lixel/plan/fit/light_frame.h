// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/box.h"
#include "lixel/base/rectangle.h"
#include "lixel/plan/fit/fit.h"

#include <optional>
#include <span>

namespace lixel {

// Light-plane coordinates: where the light ray through a point meets a plane in front of the light, as homogeneous (x, y, w),
// with a depth that grows along every ray. Points: perspective from the light, w = depth. Directions: parallel, w = 1. In these
// coordinates every fit is the same planar map for both, and a planar map of them is a LightFrame again (`warped`).
struct LightFrame
{
    Mat4d framedFromLocal; // rows: x, y, depth, w
    bool isPerspective = false;
    Vec3d apexLocal;   // perspective: the light, where rows x, y and w vanish
    double leastW = 1; // parallel light: the smallest w of what must be held
};

// `axisLocal` is a unit vector, the way light travels in the middle of the map; directional lights use their own direction.
LightFrame lightFrame(const Light& light, Vec3d originWorld, Vec3d axisLocal);

// A planar map of the light plane: rows act on (x, y, w).
struct PlaneWarp
{
    Vec3d x{1, 0, 0}, y{0, 1, 0}, w{0, 0, 1};
};

// What a map must hold, as the light sees it.
struct FramedBody
{
    LightFrame frame;
    std::span<const Vec3d> points;  // all of it
    std::span<const Vec3d> corners; // those of them that are corners of its image, or may be; planar maps keep them so
    Box bounds{};                   // of the points, where that is known
};

// Depth of lights at a point becomes the new w, which is 0 at the light and grows along rays where it is positive at all; that of
// parallel light stays. Nothing where the warp's own horizon (w = 0) meets the body.
std::optional<FramedBody> warped(const FramedBody& body, const PlaneWarp& warp);

// The body with its frame's leastW found; nothing where w is not positive, or next to nothing, at some corner.
std::optional<FramedBody> held(FramedBody body);

// Where a point lies on the light plane. Needs w > 0.
inline Vec2d onLightPlane(const LightFrame& frame, Vec3d pointLocal)
{
    const Vec4d q = frame.framedFromLocal * point(pointLocal);
    return {q.x / q.w, q.y / q.w};
}

// The narrowest cone from the apex that holds all points; cosHalfAngle is not above 0 where they do not fit a half-space.
// Needs a point. `room` is for the unit directions.
struct DirectionCone
{
    Vec3d axis;
    double cosHalfAngle = 1;
};
DirectionCone coneAround(std::span<const Vec3d> pointsLocal, Vec3d apexLocal, std::vector<Vec3d>& room);

// The widest cone that one perspective map serves: its half angle stays below 88.8 degrees.
inline constexpr double kLeastCosHalfAngle = 0.02;

// The points in the light's frame that looks along the axis of the narrowest cone around them (directional lights: along their
// direction). Corners are kept in the input's scratch. Refuses ExtentNotInHemisphere. Needs a point.
Expected<FramedBody, FitFailure> frameAround(const FitInput& input, std::span<const Vec3d> points);

// The visible points of the region (visible_body.h) so framed: what most fits start from. Refuses EmptyScene, NothingInView and
// ExtentNotInHemisphere.
Expected<FramedBody, FitFailure> visibleBody(const FitInput& input);

enum class RectangleKind {
    Upright, // sides along the frame's x and y
    LeastArea
};

// The points in a given frame; corners are kept in the scratch. Nothing where w is not positive, or next to nothing, at some.
std::optional<FramedBody> framedIn(const LightFrame& frame, std::span<const Vec3d> points, FitScratch& scratch);

// The rectangle on the light plane that holds the body. Needs a point, and w > 0 at all corners.
OrientedRectangle rectangleAround(const FramedBody& body, RectangleKind kind, FitScratch& scratch);

// The same with one side along a unit vector of the light plane.
OrientedRectangle rectangleAround(const FramedBody& body, Vec2d axis, FitScratch& scratch);

// The part of a rectangle that receivers may stray by rounding: a tenth of a lixel, of 512. Beyond, the rectangle has room.
inline constexpr double kUnroomed = 0.1 / 256;

// Half the size of a map of lights at a point, at least: a line through the light is a point in its image, but for the rounding of
// where the light is. The image of a scene a million of its radii away is a thousand times that.
inline constexpr double kLeastTangent = 1e-9;

// The rectangle with room for what floats of positions and of the map's rows may move the body's points by.
OrientedRectangle resolved(OrientedRectangle rectangle, const FramedBody& body);

// How far, of half the rectangle's size, floats of a fit's matrix may move the body's points in the map.
double floatRounding(const FramedBody& body, const OrientedRectangle& rectangle);

double farthestDepth(const FramedBody& body);

// The tightest fit that holds the body: its rectangle on the light plane, from the nearest caster before it to the farthest
// point. Needs a point.
Fit fitTightly(const FramedBody& body, RectangleKind kind, const FitInput& input);

// The fit whose NDC square is the rectangle of the light plane. Near: the nearest caster box that reaches into the rectangle,
// not nearer than 1e-4 of the far depth for perspective; far: the given depth.
Fit fitRectangle(const LightFrame& frame, OrientedRectangle rectangle, double farDepth, const FitInput& input);

// The same with no room added around the rectangle: for lixels that must lie just where they are asked for.
Fit fitRectangleAsItIs(const LightFrame& frame, const OrientedRectangle& rectangle, double farDepth,
                       const FitInput& input);

// As fitRectangle() with the nearest depth of casters known. Depths that are all but one, as those of a floor right across the light, get
// a span that floats resolve. The room around the rectangle goes with its coordinates, or with `leastScale` where that is more.
Fit fitRectangle(const LightFrame& frame, OrientedRectangle rectangle, double nearDepth, double farDepth,
                 const FitInput& input, double leastScale = 0);

} // namespace lixel
