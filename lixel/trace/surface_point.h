// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/view_samples.h"

namespace lixel {

// One entry of ViewSamples: what rays start from.
struct SurfacePoint
{
    Vec3f positionLocal;
    Vec3f normal;                         // geometric, unit, turned to the eye
    std::uint32_t triangle = kNoTriangle; // of the casters
};

inline SurfacePoint surfacePoint(const ViewSamples& samples, std::size_t i)
{
    return {samples.positionLocal[i], samples.normal[i], samples.triangle[i]};
}

} // namespace lixel
