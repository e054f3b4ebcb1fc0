// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/fixed_vector.h"
#include "lixel/plan/partition/partition.h"

#include <span>
#include <string>
#include <string_view>

namespace lixel {

// A plane of interest as a partition takes it.
struct InterestPlane
{
    Plane planeLocal;                     // unit normal, either way
    FixedVector<Vec3d, 8> polygonLocal{}; // convex, corners in order, either way round; empty: the whole plane
    int number = -1;                      // the caller's
};
inline constexpr std::size_t kMostPlanes = 8;
using InterestPlanes = FixedVector<InterestPlane, kMostPlanes>;

// A named plane; of a polygon that is not convex or has more than 8 corners a convex one around it.
InterestPlane interestPlane(const NamedPlane& plane, Vec3d originWorld, int number, FitScratch::OnPlane& scratch);

// One cell a plane, in order of priority: the light rays that meet it within the picture's sides, as
//
//   H. Chong, S. Gortler. A Lixel for every Pixel. 2004, section 3: C^floor, C^wall; table and floor.
//
// A plane with a polygon has the rays through the polygon: half-spaces through the light and the polygon's sides. Whole planes that
// meet within the scene part their rays at the line where they meet: each has those that come to it first. Planes that face away
// take no rays from others. With wantsWholePixels cells end at their planes: what is behind a table as the light sees it, such as
// the floor at the border of the table's shadow, is left to its own plane, whose lixels are its pixels.
//
//   Returns  up to eight cells. Receivers in none of them are left, to an else(...)
//   Refuses  NoSuchPlane, where there are no planes
//   Differs  nothing asks that the light's rays fit less than a hemisphere. Rays outside the picture's sides are left out by the fit,
//            which knows where they lie
CellsResult splitPlanes(const FitInput& input, std::span<const InterestPlane> planes, Twist twist);

} // namespace lixel
