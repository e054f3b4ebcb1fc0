// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/observation.h"
#include "lixel/plan/fit/fit.h"

#include <cmath>
#include <span>
#include <vector>

// Predicted error: how wide lixels are in the picture where shadows end. Budgets are shared by it, and planes chosen.
namespace lixel {

// A few hundred of the receivers that face a light, for predictions. Of an observation all that lie at shadow boundaries, as far as
// there is room, and some others at a fiftieth of their weight, since boundaries may have been missed; without one, even
// samples of what is seen. `light` is its number in the observation.
struct NeedSource
{
    const Observation* observed = nullptr;
    std::size_t lightNumber = 0;
    std::span<const Vec3d> seenLocal, seenNormal; // facing the light
};
void gatherNeedSamples(const NeedSource& source, const Light& light, Vec3d originWorld,
                       std::vector<NeedSample>& samples);

// Sums, over samples, of how long one step of a map's x and y is in the picture, the map having one lixel. A lixel misplaces the
// shadow's edge by about half its width across the edge, so with width by height lixels errors go with
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

// Of one sample that the fit holds. Edge-on surfaces have endless lixels; none counts as more than some pictures.
Need needOf(const Fit& fit, const View& view, Vec3d originWorld, const NeedSample& sample);

} // namespace lixel
