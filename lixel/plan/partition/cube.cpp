// SPDX-License-Identifier: MIT
#include "lixel/plan/partition/cube.h"

#include <array>

namespace lixel {
namespace {

// Room for the rounding of float half-spaces. Only an angle: bounds moved off the light would hold points behind it.
constexpr double kOverlapAngle = 1e-4;

struct Axes
{
    std::array<Vec3d, 3> axis;
};

Axes axesOf(const Light& light)
{
    if (light.kind == LightKind::Point) return {{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}}};
    const Vec3d forward = light.directionWorld, right = anyPerpendicular(forward);
    return {{forward, right, cross(right, forward)}};
}

} // namespace

CellsResult splitCube(const FitInput& input)
{
    if (input.light.kind == LightKind::Directional) return wholeSpace();
    const Axes axes = axesOf(input.light);
    const Vec3d lightLocal = input.light.positionWorld - input.originWorld;
    constexpr double kCosine45 = 0.70710678118654752;

    Cells cells;
    for (int face = 0; face < 6; ++face) {
        const std::size_t a = std::size_t(face / 2);
        const Vec3d out = (face % 2 ? -1.0 : 1.0) * axes.axis[a];
        Cell cell;
        for (const std::size_t other : {(a + 1) % 3, (a + 2) % 3})
            for (const double sign : {1.0, -1.0}) {
                const Vec3d aside = sign * axes.axis[other];
                cell.servesLocal.push_back(planeThrough(lightLocal, kCosine45 * (out + aside)));
                cell.holdsLocal.push_back(planeThrough(lightLocal, normalized((1 + kOverlapAngle) * out + aside)));
            }
        cells.push_back(cell);
    }
    return cells;
}

} // namespace lixel
