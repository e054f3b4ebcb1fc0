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

bool areSameBits(const std::vector<shared::ShadowRegion>& a, const std::vector<shared::ShadowRegion>& b)
{
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(shared::ShadowRegion)) == 0);
}

} // namespace

bool DrawnMaps::areThoseOf(const FramePlan& plan, const CasterSource& casters) const
{
    return version_ != 0 && versionOf(casters) == version_ && casters.index() == kindOfSource_ &&
           plan.originWorld == originWorld_ && plan.atlas == atlas_ && plan.layers == layers_ &&
           areSameBits(plan.regionTable, regions_);
}

void DrawnMaps::set(const FramePlan& plan, const CasterSource& casters)
{
    version_ = versionOf(casters);
    kindOfSource_ = casters.index();
    originWorld_ = plan.originWorld;
    atlas_ = plan.atlas;
    layers_ = plan.layers;
    regions_ = plan.regionTable;
}

} // namespace lixel::gl
