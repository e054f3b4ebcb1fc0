// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/view.h"
#include "lixel/plan/fit/lixel_energy.h"
#include "lixel/plan/fit/need_sample.h"
#include "lixel/plan/shadow_plan.h"

#include <optional>
#include <span>
#include <vector>

namespace lixel::app {

// How bad the maps of a light are for samples near its shadows' edges, by energies of their own lixels: each sample asks the first region
// that holds it.
class BoundaryEnergy
{
public:
    BoundaryEnergy(const View& view, Vec3d originWorld, const ShadowPlan& plan, std::span<const NeedSample> samples);

    // The mean over the samples that are served, in pixels (L2 and area: their squares). Nothing where none is.
    std::optional<double> mean(LixelMetric metric) const;

    std::size_t unserved() const { return unserved_; }

private:
    struct Region
    {
        EdgeRays rays; // their frame is the map, a unit being a lixel
        double weight = 0;
    };
    std::vector<Region> regions_;
    std::size_t unserved_ = 0;
};

} // namespace lixel::app
