// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/light.h"
#include "lixel/trace/ray_triangle.h"
#include "lixel/trace/surface_point.h"
#include "lixel/trace/trace_scene.h"

#include <optional>

// One ray from a surface to a light, decided in double.
namespace lixel {

// Where the ray of a surface point starts. View samples come as floats, which lie up to a float step off their
// triangle, to either side of it and past its edges; from there a surface would shadow itself, and a crease would leak.
// So the start is the point of the sample's own triangle below the sample, drawn in until each corner weighs 1e-6: it
// lies on the inner side of every wall that shares an edge with the triangle. Samples without a triangle start above
// the sample, along its normal, by kLiftOfUnknown of their largest coordinate: 32 float steps.
struct RayStart
{
    Vec3d positionLocal;
    Vec3d normal;                 // of the own triangle, in double, turned as the sample's
    double largestCoordinate = 0; // of the sample and its triangle: what rounding errors are proportional to
    double undecided = 0;         // radians: rays that rise less from the surface graze it (see rayTowards)
};

inline constexpr double kLeastWeightOfStart = 1e-6;
inline constexpr double kLiftOfUnknown = 0x1p-19;

RayStart rayStart(const TraceScene& scene, const SurfacePoint& sample);

// The ray towards the light; ends at it, unless it comes from infinity. Nothing where the start is at the light.
//   - The start is off its plane by double rounding. Hits not higher above that plane than kStartRounding of the
//     largest coordinate (32 roundings) do not count: a thing on the floor is seen from that height on.
//   - Corners are floats, each off the modelled point by up to half a float step, or two where the file rounded before
//     us; the normal of a triangle of height h is therefore unsure by some kCornerRounding * largest coordinate / h,
//     and rays that rise less may in truth go down and hit the far side of the very body they come from. Such rays
//     (3e-6 rad for a triangle a third of the scene high) are turned up to that angle, and start kCornerRounding above
//     the plane.
std::optional<Ray> rayTowards(const RayStart& start, const Light& light, Vec3d originWorld);

inline constexpr double kStartRounding = 0x1p-48;
inline constexpr double kCornerRounding = 0x1p-20;
inline constexpr double kMostUndecided = 0x1p-6; // a degree: slivers narrower than float steps have any normal

// Corners are floats, each off the modelled point by up to half a float step. A flat floor of many triangles is
// therefore rough by as much, and would shadow itself under grazing light. True where all six corners lie in one plane
// within such steps (2^-20 of their largest coordinate, which bounds what six roundings, twice each, can do): such
// triangles are one flat surface and never shadow each other. False where the corners leave the plane undetermined (all
// nearly on a line).
bool areOneFlatSurface(const Corners& a, const Corners& b);

// Whether anything blocks the ray from this sample. A blocker is any triangle but the sample's own and those that are
// one flat surface with it, kept by its alpha at the hit, before the light. Expects a light-facing sample.
bool isInShadow(const TraceScene& scene, const SurfacePoint& sample, const Light& light);

} // namespace lixel
