// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/gl/device/device.h"
#include "lixel/gl/device/objects.h"
#include "lixel/plan/shadow_plan.h"

#include <string>

namespace lixel::gl {

// The lookup as a define of shaders that read or make what it needs; the taps of a side stay a uniform.
std::string lookupDefine(const shared::LxLookup& how);

// What a plan's lookup makes of its maps before anything is looked up, as the atlas has its layers; of each kind as much as the lookup needs.
struct PreparedMaps
{
    Texture words, moreWords; // several depths
    Texture gradients;
    Texture moments, across; // and half blurred

    void resize(const FramePlan& plan);
    void bind() const; // kUnitWords, kUnitMoreWords, kUnitGradients, kUnitMoments

    // Whether they are there for this plan's lookup. They must be forgotten when the maps change.
    bool areFor(const FramePlan& plan) const { return of_ == lookupDefine(plan.lookup.how); }
    void set(const FramePlan& plan) { of_ = lookupDefine(plan.lookup.how); }
    void forget() { of_.clear(); }

private:
    std::string of_;
};

} // namespace lixel::gl
