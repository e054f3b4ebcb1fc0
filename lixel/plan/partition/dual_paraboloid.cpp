// SPDX-License-Identifier: MIT
#include "lixel/plan/partition/dual_paraboloid.h"

namespace lixel {

CellsResult splitDualParaboloid(const FitInput& input)
{
    const Light& light = input.light;
    if (light.kind == LightKind::Directional) return Unexpected{FitFailure::NoPlaceOfLight};
    const Vec3d axis = light.kind == LightKind::Spot ? light.directionWorld : Vec3d{1, 0, 0};
    Cells cells;
    for (const double side : {1.0, -1.0}) {
        Cell cell;
        cell.paraboloidAxis = side * axis;
        cell.servesLocal.push_back(planeThrough(light.positionWorld - input.originWorld, side * axis));
        cell.holdsLocal = cell.servesLocal;
        cells.push_back(cell);
    }
    return cells;
}

} // namespace lixel
