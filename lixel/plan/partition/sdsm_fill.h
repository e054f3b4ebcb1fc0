// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/shadow_plan.h"
#include "lixel/shared/sdsm.h"

#include <optional>
#include <vector>

// Sample-distribution cascades whose tables a device makes itself from the picture it has just drawn, with nothing read back.
//
//   A. Lauritzen, M. Salvi, A. Lefohn. Sample Distribution Shadow Maps. I3D 2011, sections 3 and 4.
namespace lixel {

// What the tables of one light are made from, besides view samples.
struct SdsmFill
{
    shared::SdsmSetup setup;
    std::vector<shared::SdsmCasters> casters;
};

// A plan before its tables are made: layout, rectangles, and rows that hold no point yet.
struct SdsmLayout
{
    FramePlan plan;
    std::vector<SdsmFill> fills; // one a light
};

// The layout of `sdsm(n)+desired-view`. PlanInput::seen is not asked. Regions share the light's lixels evenly, since needs are not
// known before the frame.
//
//   Needs    parallel lights, all of them: the frame of a light at a point depends on the samples in ways that no reduction finds
//   Returns  nothing for another technique, `stable`, an else(...), a light at a point, or fewer lixels than regions
std::optional<SdsmLayout> layoutSdsm(const PlanInput& input);

// Makes the tables of one light: the twin of the device's pass, by the same text (lixel/shared/sdsm.h), and for samples of every
// cascade what planShadows() makes of them, to rounding.
void fillSdsm(const SdsmFill& fill, const ViewSamples& samples, FramePlan& plan);

} // namespace lixel
