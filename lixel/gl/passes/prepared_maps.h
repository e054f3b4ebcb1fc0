// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/gl/device/device.h"
#include "lixel/gl/device/objects.h"
#include "lixel/gl/passes/drawn_maps.h"
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

    bool areFor(const FramePlan& plan) const;
    // Marks the regions that they are not there of, for this plan's lookup. False: areFor() all.
    bool findMissing(const FramePlan& plan, RegionMarks& missing) const;
    void set(const FramePlan& plan); // of all regions
    // Of maps that change.
    void forget(const RegionMarks& regions);

private:
    std::string of_;
    RegionMarks has_;
};

} // namespace lixel::gl
