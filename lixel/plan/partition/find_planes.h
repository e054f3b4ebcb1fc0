// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/fixed_vector.h"
#include "lixel/base/plane.h"
#include "lixel/base/view.h"
#include "lixel/plan/partition/plane_fit.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

// Planes that receivers lie on, found in what a view sees: candidates for maps that are exact on a plane.
namespace lixel {

// Samples count as lying on a plane when they are no farther from it than this share of a pixel's width at their place (or than
// floats of their positions can tell).
inline constexpr double kFlatWithinPixels = 1.0 / 16;

// Planes with less than this share of all weight are not reported.
inline constexpr double kLeastPlaneShare = 0.02;

// What to look in. Points and normals have as many entries, `weights` as many or none (all alike).
struct PlaneSearch
{
    std::span<const Vec3d> pointsLocal, normals; // normals: unit, geometric, turned to the eye
    std::span<const float> weights = {};         // how much each matters; samples of no weight are not looked at
    Vec4d pixelSize;                             // of the view: pixelSizeLocal()
    std::span<const Plane> earlierLocal = {};    // found in the last frame: kept while they are there
};

struct FoundPlane
{
    Plane planeLocal;                        // unit normal, towards the eye's side
    double weight = 0;                       // share of all weight that lies on it
    FixedVector<Vec3d, 8> cornersLocal = {}; // convex, on the plane, counter-clockwise seen from the eye's side
};
using FoundPlanes = FixedVector<FoundPlane, 8>;

// Room to work in. The same one again allocates nothing.
struct PlaneScratch
{
    std::vector<PlaneSample> samples, group; // those that no plane has taken; those that a plane is sought among
    std::vector<std::uint16_t> cellOfSample; // by the direction of its normal
    std::vector<double> cellWeights;
    std::vector<std::uint16_t> cells;
    std::vector<Vec2d> onPlane, hull;
};

// How wide a pixel is at a point, world units, as a linear function of it: dot(pixelSize, point(p)). For pixels that are not
// square, their smaller side.
Vec4d pixelSizeLocal(const View& view, Vec3d originWorld);

// The heaviest planes, heaviest first. Looks at no more than 4096 samples, evenly chosen from the list: shares and polygons are
// those of the chosen ones. Each counts for one plane only.
//
//   Finds    what is flat to within kFlatWithinPixels: a facet of something coarse is a plane, curved and rough surfaces are not,
//            however many of their samples lie near some plane by chance. Parallel planes are told apart where normals
//            are exact, else where they are more than about half a pixel apart; where two are nearer than the tolerance, as far
//            away, the heavier one has the samples of both
//   Exact    samples on a plane to float rounding give this plane, as well as floats can tell, also where normals are some
//            degrees off: they sort samples, the plane is fitted to points
//   Steady   a plane of `earlierLocal` keeps its very numbers while they fit as well as new ones would, and stays until it has less
//            than half the least share. The order of equal weights depends on the planes alone
//   Polygon  holds all chosen samples of the plane: their convex hull, grown where it had more than eight corners
void findPlanes(const PlaneSearch& search, PlaneScratch& scratch, FoundPlanes& found);

} // namespace lixel
