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

bool DrawnMaps::isSameAtlas(const FramePlan& plan, const CasterSource& casters) const
{
    return version_ != 0 && versionOf(casters) == version_ && casters.index() == kindOfSource_ &&
           plan.originWorld == originWorld_ && plan.atlas == atlas_ && plan.layers == layers_;
}

bool DrawnMaps::findMissing(const FramePlan& plan, const CasterSource& casters, RegionMarks& missing) const
{
    missing.assign(plan.regionTable.size(), 1);
    if (!isSameAtlas(plan, casters)) return true;
    const bool areSameWarps = areSameBits(plan.warpTable, warps_);
    bool anyMissing = false;
    std::size_t i = 0;
    for (const ShadowPlan& light : plan.lights)
        for (const PlannedRegion& region : light.regions) {
            const bool isThere = i < regions_.size() &&
                                 std::memcmp(&plan.regionTable[i], &regions_[i], sizeof(shared::ShadowRegion)) == 0 &&
                                 (region.warp.isIdentity() || (areSameWarps && region.warp.raster == rasters_[i]));
            missing[i++] = isThere ? 0 : 1;
            anyMissing |= !isThere;
        }
    return anyMissing;
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
