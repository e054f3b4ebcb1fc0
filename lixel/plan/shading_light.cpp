// SPDX-License-Identifier: MIT
#include "lixel/plan/shading_light.h"

#include <cmath>

namespace lixel {
namespace {

shared::vec4 toShared(Vec3d v, double w) { return {float(v.x), float(v.y), float(v.z), float(w)}; }

} // namespace

shared::ShadingLight shadingLight(const Light& light, Vec3d originWorld)
{
    const bool isDirectional = light.kind == LightKind::Directional, isSpot = light.kind == LightKind::Spot;
    shared::ShadingLight out;
    out.place = isDirectional ? toShared(-light.directionWorld, 0) : toShared(light.positionWorld - originWorld, 1);
    out.axis = toShared(light.directionWorld, isSpot ? std::cos(light.coneAngle / 2) : -2);
    out.colour = toShared(light.colour, !isDirectional && std::isfinite(light.range) ? light.range : 0);
    return out;
}

} // namespace lixel
