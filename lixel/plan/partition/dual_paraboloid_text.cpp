// SPDX-License-Identifier: MIT
#include "lixel/plan/partition/dual_paraboloid_text.h"

#include "lixel/plan/warp/warp_text.h"

namespace lixel {

std::optional<Expected<DualParaboloidPartition, std::string>> readDualParaboloid(const Word& word)
{
    if (word.name != "dual-paraboloid") return std::nullopt;
    Arguments arguments(word);
    DualParaboloidPartition out;
    const auto text = arguments.take("raster");
    if (text) out.raster = rasterNamed(*text);
    if ((text && !out.raster) || !arguments.areAllTaken())
        return Unexpected{std::string("dual-paraboloid takes raster=exact, tessellate or vertices")};
    return out;
}

std::string checkDualParaboloid(const MapTechnique& map)
{
    const auto* desiredView = std::get_if<DesiredViewFit>(&map.fit);
    const bool isFitted = std::holds_alternative<UniformFit>(map.fit) || std::holds_alternative<FocusedFit>(map.fit) ||
                          (desiredView && !desiredView->isRotated);
    if (!isFitted || map.isStable)
        return "dual-paraboloid is a projection of its own: it goes with uniform, focused and desired-view, which say "
               "how much of it maps hold, neither turned nor stable";
    if (map.otherwise) return "dual-paraboloid serves all light rays: no else(...) goes with it";
    const WarpOptions* warp = warpOptionsOf(map.warp);
    if (warp && std::get<DualParaboloidPartition>(map.partition).raster)
        return "with a warp, raster= is the warp's and not dual-paraboloid's";
    if (warp && warp->analysis != Analysis::Backward)
        return "analysis=forward and hybrid look through the light's maps as through a camera, which a paraboloid is "
               "not";
    return "";
}

} // namespace lixel
