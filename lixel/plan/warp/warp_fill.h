// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/shadow_plan.h"
#include "lixel/plan/warp/warp_choice.h"

#include <cstddef>
#include <optional>
#include <vector>

// Warps that a device makes itself from the picture it has just drawn, with nothing read back.
namespace lixel {

// The warps of one light.
struct WarpFill
{
    std::size_t light = 0; // of the plan
    WarpChoice choice;
};

// A plan whose warps are even until a device fills them.
struct WarpLayout
{
    FramePlan plan;
    std::vector<WarpFill> fills; // one a light with a map
};

// The layout of a technique with a warp. PlanInput::seen is asked by fits and partitions that need it, not by the warp.
//
//   Returns  nothing for techniques without a warp, and for importance that is not in the picture: forward and hybrid analysis,
//            boundaries, shadow edges
std::optional<WarpLayout> layoutWarps(const PlanInput& input, FitScratch& scratch);

} // namespace lixel
