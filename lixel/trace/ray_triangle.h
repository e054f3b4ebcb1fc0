// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/box.h"
#include "lixel/base/vec.h"
#include "lixel/base/view_samples.h"
#include "lixel/trace/embree_scene.h"

#include <array>
#include <limits>
#include <optional>

// Where a ray meets a triangle, in double. All points Local.
namespace lixel {

using Corners = std::array<Vec3d, 3>;

// Points origin + t * direction with tMin < t, and t < 1 where the ray ends at a point: `end` is origin + direction
// then.
struct Ray
{
    Vec3d origin, direction;
    double tMin = 0;
    std::optional<Vec3d> end;
};

struct TriangleHit
{
    double t = 0;
    double u = 0, v = 0; // weights of the second and third corner, in [0, 1] up to rounding
};

// Closed triangles: a ray that meets an edge or a corner within the rounding error of this very test (some 1e-15 of the
// distance) meets the triangle, hence no ray slips between neighbours. A ray in the triangle's plane, and an end point
// in it, within that error, meet nothing: neither side of the surface is entered.
std::optional<TriangleHit> intersect(const Ray& ray, const Corners& corners);

// Where a line meets the triangle's plane, in t of the line; nothing where it is parallel within rounding.
std::optional<double> meetPlane(Vec3d origin, Vec3d direction, const Corners& corners);

// The point of the triangle's plane below or above `p`, drawn into the triangle until each corner weighs at least
// `leastWeight` (below 1/3). Nothing where the triangle has no area.
std::optional<Vec3d> drawnInto(const Corners& corners, Vec3d p, double leastWeight);

// Unit; nothing where the triangle has no area.
std::optional<Vec3d> unitNormal(const Corners& corners);

// Part of a line, in its t; empty where last < first.
struct Interval
{
    double first = 0, last = std::numeric_limits<double>::infinity();
};

Interval clipToBox(Vec3d origin, Vec3d direction, const Box& box, Interval interval);

// A line as Embree wants it: from the start of the interval, of unit direction, so that floats are as exact where the
// scene is as they can be.
SearchRay searchRay(Vec3d origin, Vec3d direction, Interval interval);

} // namespace lixel
