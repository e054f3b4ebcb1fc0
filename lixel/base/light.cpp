// SPDX-License-Identifier: MIT
#include "lixel/base/light.h"

namespace lixel {

bool isLightFacing(const Light& light, Vec3d originWorld, Vec3d pointLocal, Vec3d normal)
{
    if (light.kind == LightKind::Directional) return dot(normal, light.directionWorld) < 0;
    const Vec3d toLight = (light.positionWorld - originWorld) - pointLocal;
    const double distance = length(toLight);
    if (!(dot(normal, toLight) > 0) || distance > light.range) return false;
    return light.kind == LightKind::Point ||
           dot(toLight, light.directionWorld) <= -distance * std::cos(light.coneAngle / 2);
}

} // namespace lixel
