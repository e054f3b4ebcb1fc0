// SPDX-License-Identifier: MIT
#include "lixel/plan/warp/warp_fill.h"

#include "lixel/plan/warp/region_warps.h"

namespace lixel {

std::optional<WarpLayout> layoutWarps(const PlanInput& input, FitScratch& scratch)
{
    const WarpOptions* options = warpOptionsOf(input.technique.warp);
    if (!options || options->analysis != Analysis::Backward || options->importance.has(kBoundariesWeight) ||
        options->importance.has(kShadowEdgesWeight))
        return std::nullopt;
    PlanInput without = input;
    without.technique.warp = NoWarp{};
    if (auto* partition = std::get_if<DualParaboloidPartition>(&without.technique.partition))
        partition->raster = options->raster; // of regions too small for a warp
    WarpLayout layout{planShadows(without, scratch), {}};
    FramePlan& plan = layout.plan;
    plan.warpTable.clear(); // of paraboloids
    std::size_t row = 0;    // of the table: regions light by light
    for (std::size_t i = 0; i < plan.lights.size(); ++i) {
        warpRegionsEvenly(input.technique.warp, plan.lookup, scratch.warps, plan.lights[i].regions);
        for (const PlannedRegion& region : plan.lights[i].regions)
            plan.regionTable[row++].warp = appendWarp(region.warp, plan.warpTable);
        if (!plan.lights[i].refused) layout.fills.push_back({i, input.technique.warp});
    }
    return layout;
}

} // namespace lixel
