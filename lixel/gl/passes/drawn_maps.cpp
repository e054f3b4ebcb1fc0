// SPDX-License-Identifier: MIT
#include "lixel/gl/passes/drawn_maps.h"

#include <cstring>
#include <variant>

namespace lixel::gl {
namespace {

std::uint64_t versionOf(const CasterSource& casters)
{
    return std::visit([](const auto& source) { return source.version; }, casters);
}

template <typename T>
bool areSameBits(const std::vector<T>& a, const std::vector<T>& b)
{
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

} // namespace

bool DrawnMaps::areThoseOf(const FramePlan& plan, const CasterSource& casters) const
{
    return version_ != 0 && versionOf(casters) == version_ && casters.index() == kindOfSource_ &&
           plan.originWorld == originWorld_ && plan.atlas == atlas_ && plan.layers == layers_ &&
           areSameBits(plan.regionTable, regions_) && areSameBits(plan.warpTable, warps_) && areSameRasters(plan);
}

bool DrawnMaps::areSameRasters(const FramePlan& plan) const
{
    std::size_t i = 0;
    for (const ShadowPlan& light : plan.lights)
        for (const PlannedRegion& region : light.regions)
            if (region.warp.raster != rasters_[i++]) return false;
    return true;
}

void DrawnMaps::set(const FramePlan& plan, const CasterSource& casters)
{
    version_ = versionOf(casters);
    kindOfSource_ = casters.index();
    originWorld_ = plan.originWorld;
    atlas_ = plan.atlas;
    layers_ = plan.layers;
    regions_ = plan.regionTable;
    warps_ = plan.warpTable;
    rasters_.clear();
    for (const ShadowPlan& light : plan.lights)
        for (const PlannedRegion& region : light.regions) rasters_.push_back(region.warp.raster);
}

} // namespace lixel::gl
