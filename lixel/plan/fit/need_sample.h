// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/vec.h"

namespace lixel {

// A receiver that predictions of errors and energies of light images ask.
struct NeedSample
{
    Vec3d pointLocal, normal;
    double weight = 1; // pixels that it stands for, times how likely a shadow ends there
    Vec2d across{};    // unit, in the picture, at right angles to the shadow's edge; zero where that is unknown
};

} // namespace lixel
