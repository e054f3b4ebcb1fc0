// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/vec.h"

#include <limits>
#include <string>

namespace lixel {

enum class LightKind { Directional, Spot, Point };

// A light without extent. A spot's cone and range, and a point's range, bound what it lights; outside is dark.
struct Light
{
    std::string name = "light";
    LightKind kind = LightKind::Directional;
    Vec3d positionWorld;                                    // spot, point
    Vec3d directionWorld{0, -1, 0};                         // directional, spot: unit, the way light travels
    double coneAngle = 1.5707963267948966;                  // spot: full angle of the cone, radians, in (0, pi)
    double range = std::numeric_limits<double>::infinity(); // spot, point: world units
    Vec3d colour{1, 1, 1};                                  // of the picture only; brightest lit surface about 1
};

// The light's place, w = 1, or the way its light travels, w = 0.
inline Vec4d homogeneousWorld(const Light& light)
{
    const bool isDirectional = light.kind == LightKind::Directional;
    const Vec3d v = isDirectional ? light.directionWorld : light.positionWorld;
    return {v.x, v.y, v.z, isDirectional ? 0.0 : 1.0};
}

// Unit vector from a point towards the light.
inline Vec3d towardsLight(const Light& light, Vec3d originWorld, Vec3d pointLocal)
{
    if (light.kind == LightKind::Directional) return -light.directionWorld;
    return normalized((light.positionWorld - originWorld) - pointLocal);
}

// True when the surface point with this geometric normal can be lit at all: the normal's dot product with the direction to
// the light is positive, and the point is inside the spot's cone and the range. All other points are dark without a test.
bool isLightFacing(const Light& light, Vec3d originWorld, Vec3d pointLocal, Vec3d normal);

} // namespace lixel
