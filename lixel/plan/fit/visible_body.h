// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/fit/fit.h"

#include <span>
#include <vector>

// What a map must hold, and what can shadow it, as corners of the scene's boxes cut by planes.
namespace lixel {

// Room for a view, a light's cone and range, and a region's half-spaces.
using BodyPlanes = FixedVector<Plane, 6 + CellPlanes::capacity() + 6 + 8>;

// Corners of all of the region that can be seen and lit, Local: what the map must hold is their convex hull. Empty where there
// is nothing. For a light at a point, corners at the light itself are left out: they have no place in its image. A spot's cone counts as
// the eight planes through the light that touch it, a range as the cube around its ball: what is held is a little more.
void findVisiblePoints(const FitInput& input, std::vector<Vec3d>& points);

// The same without the view: all of the region that the light reaches.
void findReachedPoints(const FitInput& input, std::vector<Vec3d>& points);

// The least value of a linear function over all that can shadow something in a map: what of the scene lies within its sides and
// not beyond its far side. Never more than `most`, which it is where nothing is below.
double leastOverCasters(const FitInput& input, const Mat4d& lightClipFromLocal, Vec4d function, double most);

// Appends the corners of a box cut by the planes. Most boxes are wholly inside or outside, which costs a few products.
void appendClippedBox(const Box& box, std::span<const Plane> planes, std::vector<Vec3d>& points);

// How far along the line of sight a point lies: the distance in front of the plane through the eye (of parallel views: of
// the near side).
struct ViewDepth
{
    Vec3d forward; // unit, Local = World directions
    double offset = 0;
    bool isPerspective = true;

    double of(Vec3d pointLocal) const { return dot(forward, pointLocal) + offset; }
    Plane beyond(double depth) const { return {forward, offset - depth}; }  // holds depths >= depth
    Plane before(double depth) const { return {-forward, depth - offset}; } // holds depths <= depth
};
struct DepthSpan
{
    double nearest = 0, farthest = 0;
};

ViewDepth viewDepth(const View& view, Vec3d originWorld);

} // namespace lixel
