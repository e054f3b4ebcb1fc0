// SPDX-License-Identifier: MIT
#include "lixel/plan/warp/warp_fill.h"

#include <algorithm>
#include <utility>

namespace lixel {

std::optional<WarpLayout> layoutWarps(const PlanInput& input, FitScratch& scratch)
{
    const WarpOptions* options = warpOptionsOf(input.technique.warp);
    if (!options || options->analysis != Analysis::Backward || options->importance.has(kBoundariesWeight) ||
        options->importance.has(kShadowEdgesWeight))
        return std::nullopt;
    WarpLayout layout{planShadows(input, scratch), {}};
    for (std::size_t i = 0; i < layout.plan.lights.size(); ++i)
        if (!layout.plan.lights[i].refused) layout.fills.push_back({i, input.technique.warp});
    return layout;
}

} // namespace lixel
