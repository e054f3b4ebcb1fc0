// SPDX-License-Identifier: MIT
#include "lixel/plan/warp/light_view.h"

#include <algorithm>

namespace lixel {
namespace {

// Of the maps' sides: edges need be found, not drawn.
constexpr int kOfSide = 4;

} // namespace

View lightViewOf(const PlannedRegion& region, const Light& light, Vec3d originWorld)
{
    const Vec4d at = homogeneousWorld(light);
    const Vec3d eye = at.w > 0 ? xyz(at) - originWorld : -xyz(at);
    return {region.lightClipFromLocal,
            originWorld,
            {eye.x, eye.y, eye.z, at.w},
            region.rectangle.width(),
            region.rectangle.height()};
}

std::optional<LightLook> lightLookOf(const MapTechnique& technique, LixelSize lixels)
{
    const WarpOptions* options = warpOptionsOf(technique.warp);
    if (!options || options->analysis == Analysis::Backward) return std::nullopt;
    LightLook look{technique, {std::max(1, lixels.width / kOfSide), std::max(1, lixels.height / kOfSide)}};
    look.technique.warp = NoWarp{};
    return look;
}

} // namespace lixel
