// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/fit/fit.h"
#include "lixel/plan/fit/lixel_energy.h"

#include <span>

namespace lixel {

// What is asked of a light image: that it holds a hull, at the least energy of some samples.
struct MapQuestion
{
    LixelMetric metric = LixelMetric::Width;
    const EdgeRays& rays;
    std::span<const Vec3d> corners; // of the hull: rays (x, y, w), counter-clockwise, w above 0
    double aspect = 1;              // lixels across the map over those along it
    bool hasShear = false;          // the affine part may be a parallelogram
    FitScratch::OfScene& scratch;
};

struct FoundMap
{
    PlaneWarp map;     // of one lixel in all
    double energy = 0; // of all samples; infinite where nothing was found
};

// The rectangle of least area around the hull, from a given optical axis, as the paper fits it.
FoundMap leastAreaMap(const MapQuestion& question, Vec3d w);

// Gradient descent on the axis, affine parts of least area.
//
//   H. Chong, S. Gortler. Scene Optimized Shadow Mapping. 2007, Algorithm 1, step 4.
//   Angles are turns along the negative gradient, in degrees; each iteration goes on from the best of its own, and the best of all
//   is kept (the paper leaves the first open).
inline constexpr std::array<double, 9> kPaperAngles{-10, 3, 5, 9, 16, 23, 30, 40, 50};
struct Descent
{
    int iterations = 3;
    std::span<const double> angles = kPaperAngles;
};
FoundMap descend(const MapQuestion& question, Vec3d startW, const Descent& descent = {});

// The best light image there is, nearly always: axes all over the hull's field of view by closed forms (SquaresForm, CubesForm),
// the best of them again by some samples, and those refined.
FoundMap searchWidely(const MapQuestion& question);

} // namespace lixel
