// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/scene.h"

#include <functional>
#include <span>
#include <vector>

// The parts that built-in scenes are made of. Metres, Y up; triangles turn counterclockwise seen from outside, normals
// are smooth where the thing is round; no triangle is degenerate. Solid parts are closed.
namespace lixel::builtin {

// A grid of points f(u, v), u and v in [0, 1]; its outside is where cross(df/du, df/dv) points. Points that coincide
// (seams, poles) share their normal. uv = (u, v) * uvScale.
Mesh surface(const std::function<Vec3d(double u, double v)>& f, int columns, int rows, Vec2d uvScale = {1, 1});

// Flat faces, from the corner `a` of the least coordinates to its opposite `b`; uv in metres over `metresPerRepeat`.
Mesh box(Vec3d a, Vec3d b, double metresPerRepeat = 1);
Mesh boxAround(Vec3d centre, Vec3d size, double metresPerRepeat = 1);

// Turns a profile of (radius, height) about the Y axis. Profiles run with their solid on the left of (r, y), that is
// upwards on outer sides; a point given twice in a row is a crease; solids start and end at radius 0.
Mesh lathe(std::span<const Vec2d> profile, int segments, Vec2d uvScale = {1, 1});

// A profile through these points, smooth but at points given twice; `steps` spans between neighbours.
std::vector<Vec2d> smoothProfile(std::span<const Vec2d> points, int steps);

Mesh sphere(double radius, int segments);                  // about the origin
Mesh cylinder(double radius, double height, int segments); // on the origin, with both ends
Mesh cone(double radius, double height, int segments);
Mesh torus(double ringRadius, double tubeRadius, int segments, int sides);             // about the Y axis, centred
Mesh torusKnot(int p, int q, double size, double tubeRadius, int segments, int sides); // centred, axis Y

// A round rod along a path of at least two points, its ends closed flat; or along a loop (first point not repeated).
Mesh tube(std::span<const Vec3d> path, double radiusStart, double radiusEnd, int sides);
Mesh loopTube(std::span<const Vec3d> loop, double radius, int sides);
Mesh rod(Vec3d from, Vec3d to, double radius, int sides);

// The solid between two polylines of as many points, both running towards +x, `lower` below `upper`; along z from
// -depth/2 to +depth/2. Arches, vaults and slabs with curved undersides.
Mesh band(std::span<const Vec2d> lower, std::span<const Vec2d> upper, double depth, double metresPerRepeat = 1);

// A wall about z = 0 with a rectangular opening: corners in (x, y); the hole lies inside the wall.
struct Rectangle2
{
    Vec2d min, max;
};
Mesh wallWithHole(Rectangle2 wall, Rectangle2 hole, double depth, double metresPerRepeat = 1);

// A polygon that is star-shaped about the origin, counterclockwise in (x, y), from z = -depth/2 to +depth/2.
Mesh prism(std::span<const Vec2d> polygon, double depth);

// A cube with round edges: |x|^n + |y|^n + |z|^n = 1, scaled; on the origin.
Mesh softBox(Vec3d size, double exponent, int segments);

Mesh bunny(); // one metre high, feet at y = 0, looking about towards -x; 9,000 triangles

// Appends `part`, moved; needs the same set of arrays, which all parts here have (position, normal, uv).
void append(Mesh& whole, const Mesh& part, const Mat4d& wholeFromPart = {});

// Placements for append().
Mat4d at(Vec3d position);
Mat4d turnedY(double degrees);
Mat4d turned(Vec3d axis, double degrees);

} // namespace lixel::builtin
