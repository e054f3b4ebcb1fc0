// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/observation.h"
#include "lixel/plan/boundary_directions.h"
#include "lixel/plan/fit/fit.h"
#include "lixel/plan/fit/need_sample.h"

#include <cmath>
#include <span>
#include <vector>

// Predicted error: how wide lixels are in the picture across the edges of shadows. Budgets are shared by it, and planes chosen. It is our
// own; that samples near shadow boundaries are what counts is from H. Chong, S. Gortler. Scene Optimized Shadow Mapping. 2007.
namespace lixel {

// Receivers that face a light, for predictions.
struct NeedSource
{
    const Observation* observed = nullptr; // where shadows end; nothing: unknown
    std::size_t lightNumber = 0;           // in the observation
    std::span<const Vec3d> seenLocal, seenNormal;
    const View* view = nullptr; // samples of an earlier frame count where this one sees them
};

// How many, and what those away from shadow boundaries count for.
struct NeedSampling
{
    std::size_t mostAtBoundaries = 768, mostOthers = 256;
    double awayFromBoundaries = 0.002;
    bool skipsDepthJumps = false; // leaves out samples at them
};

// Of an observation all at shadow boundaries, as far as there is room, with the direction of the boundary; and some others at a
// part of their weight, since boundaries may have been missed. Without one, evenly of what is seen.
void gatherNeedSamples(const NeedSource& source, const Light& light, Vec3d originWorld, BoundaryDirections& directions,
                       std::vector<NeedSample>& samples, const NeedSampling& sampling = {});

// Receivers that face the light and were observed in its shadow or near the edge of one. Empty without an observation.
void gatherShadows(const NeedSource& source, const Light& light, Vec3d originWorld, std::vector<Vec3d>& shadowsLocal);

// Sums, over samples, of how wide one step of a map's x and y is in the picture across the shadow's edge, the map having one lixel.
// A lixel misplaces the edge by about half its width, so with width by height lixels errors go with
// alongX / width + alongY / height.
struct Need
{
    double alongX = 0, alongY = 0;

    double within(double width, double height) const { return alongX / width + alongY / height; }
    double best() const
    {
        return std::sqrt(alongX * alongY);
    } // errors of n lixels go with 2 / sqrt(n) of it, at the best aspect
    Need& operator+=(Need other)
    {
        alongX += other.alongX, alongY += other.alongY;
        return *this;
    }
};

// What a map does to one sample that it holds. Edges are taken to run in all directions of the surface alike, so that in the
// picture they are foreshortened as the surface is: on a floor seen from low above most lie across. Edge-on surfaces have endless
// lixels; none counts as more than some pictures.
class NeedPredictor
{
public:
    NeedPredictor(const View& view, Vec3d originWorld);
    Need of(const Fit& fit, const NeedSample& sample) const;

private:
    Mat4d pixelsFromLocal_; // rows: pixel x and y times w, unused, w
    double most_;
};

} // namespace lixel
