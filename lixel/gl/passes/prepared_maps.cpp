// SPDX-License-Identifier: MIT
#include "lixel/gl/passes/prepared_maps.h"

#include "lixel/shared/gl_slots.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>

namespace lixel::gl {

std::string lookupDefine(const shared::LxLookup& how)
{
    return fmt::format("LOOKUP LxLookup({},{},{},{},{},tapsPerSide,{},{})", how.store, how.depths, how.selection,
                       how.around, how.kernel, how.isDualPlane, how.blur);
}

bool PreparedMaps::areFor(const FramePlan& plan) const
{
    if (plan.regionTable.empty()) return true; // every light was refused
    return of_ == lookupDefine(plan.lookup.how) && has_.size() == plan.regionTable.size() &&
           std::ranges::find(has_, 0) == has_.end();
}

bool PreparedMaps::findMissing(const FramePlan& plan, RegionMarks& missing) const
{
    const bool isOfLookup = of_ == lookupDefine(plan.lookup.how);
    missing.assign(plan.regionTable.size(), 1);
    for (std::size_t i = 0; i < missing.size() && isOfLookup; ++i) missing[i] = i < has_.size() && has_[i] ? 0 : 1;
    return std::ranges::find(missing, 1) != missing.end();
}

void PreparedMaps::set(const FramePlan& plan)
{
    of_ = lookupDefine(plan.lookup.how);
    has_.assign(plan.regionTable.size(), 1);
}

void PreparedMaps::forget(const RegionMarks& regions)
{
    has_.resize(regions.size(), 0);
    for (std::size_t i = 0; i < regions.size(); ++i)
        if (regions[i]) has_[i] = 0;
}

void PreparedMaps::resize(const FramePlan& plan)
{
    const LookupLayout& lookup = plan.lookup;
    const int width = std::max(plan.atlas.width, 1), height = std::max(plan.atlas.height, 1);
    const int layers = std::max(plan.layers, 1);
    const GLenum wordFormat = lookup.preparedWords == 1   ? GL_R32UI
                              : lookup.preparedWords == 2 ? GL_RG32UI
                                                          : GL_RGBA32UI;
    const GLenum momentFormat = lookup.momentChannels == 2 ? GL_RG32F : GL_RGBA32F;
    if (lookup.preparedWords > 0) words.resize(wordFormat, width, height, layers);
    if (lookup.hasMoreWords) moreWords.resize(GL_R32UI, width, height, layers);
    if (lookup.hasGradients) gradients.resize(GL_R32UI, width, height, layers);
    if (lookup.momentChannels == 0) return;
    moments.resize(momentFormat, width, height, layers);
    across.resize(momentFormat, width, height, layers);
}

void PreparedMaps::bind() const
{
    words.bind(shared::kUnitWords);
    moreWords.bind(shared::kUnitMoreWords);
    gradients.bind(shared::kUnitGradients);
    moments.bind(shared::kUnitMoments);
}

} // namespace lixel::gl
