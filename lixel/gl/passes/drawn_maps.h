// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/caster_source.h"
#include "lixel/plan/shadow_plan.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lixel::gl {

// What the maps in an atlas were drawn from, so that equal maps need not be drawn again.
class DrawnMaps
{
public:
    // Whether a plan's maps, of these casters, are those that are there. Half-spaces and lights do not count: they decide who reads
    // a map, not what is drawn. Casters of version 0 are never the same.
    bool areThoseOf(const FramePlan& plan, const CasterSource& casters) const;
    void set(const FramePlan& plan, const CasterSource& casters);
    void forget() { version_ = 0; }

private:
    bool areSameRasters(const FramePlan& plan) const;

    std::uint64_t version_ = 0; // 0: nothing is known of the maps
    std::size_t kindOfSource_ = 0;
    Vec3d originWorld_;
    LixelSize atlas_;
    int layers_ = 0;
    std::vector<shared::ShadowRegion> regions_;
    std::vector<float> warps_;
    std::vector<WarpRaster> rasters_; // of the regions
};

} // namespace lixel::gl
