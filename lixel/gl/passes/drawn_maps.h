// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/caster_source.h"
#include "lixel/plan/shadow_plan.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lixel::gl {

// Some of a plan's regions, by index into its table: 1 those that are meant. Empty: all.
using RegionMarks = std::vector<char>;

// What the maps in an atlas were drawn from, so that equal maps need not be drawn again.
class DrawnMaps
{
public:
    // Marks those of a plan's maps, of these casters, that are not there yet: a region by itself, so that the maps of lights that stand
    // still stay. Half-spaces and lights do not count: they decide who reads a map, not what is drawn. Casters of version 0
    // are never the same. False: all are there, in an atlas of this size.
    bool findMissing(const FramePlan& plan, const CasterSource& casters, RegionMarks& missing) const;
    void set(const FramePlan& plan, const CasterSource& casters);
    void forget() { version_ = 0; }

private:
    bool isSameAtlas(const FramePlan& plan, const CasterSource& casters) const;

    std::uint64_t version_ = 0; // 0: nothing is known of the maps
    std::size_t kindOfSource_ = 0;
    Vec3d originWorld_;
    LixelSize atlas_;
    int layers_ = 0;
    std::vector<shared::ShadowRegion> regions_;
    std::vector<float> warps_;        // knots of all
    std::vector<WarpRaster> rasters_; // of the regions
};

} // namespace lixel::gl
