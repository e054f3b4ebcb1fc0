// SPDX-License-Identifier: MIT
// The light that depth's mean and the mean of its squares let through at most: Chebyshev's inequality.
//
//   W. Donnelly, A. Lauritzen. Variance Shadow Maps. I3D 2006.
#ifndef LIXEL_SHARED_LOOKUP_VSM_H
#define LIXEL_SHARED_LOOKUP_VSM_H
#include "lixel/shared/lookup/how.h"

LX_SHARED_BEGIN

// What rounding leaves of a variance.
const float LX_LEAST_VARIANCE = 4.0e-7f;

// The share of depths not before z that a mean and a mean of squares allow at most.
LX_FN float lxChebyshev(float mean, float meanOfSquares, float leastVariance, float z)
{
    if (z <= mean) return 1.0f;
    float variance = max(meanOfSquares - mean * mean, leastVariance);
    float away = z - mean;
    return variance / (variance + away * away);
}

LX_FN vec4 lxVsmMoments(float z) { return vec4(z, z * z, 0.0f, 0.0f); }

LX_FN float lxLitByVsm(vec4 m, float z) { return lxChebyshev(m.x, m.y, LX_LEAST_VARIANCE, z); }

LX_SHARED_END

#endif
