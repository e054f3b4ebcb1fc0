// SPDX-License-Identifier: MIT
// The light that the means of z to z^4 let through at most: Hamburger's problem.
//
//   C. Peters, R. Klein. Moment Shadow Mapping. I3D 2015, section 4.
#ifndef LIXEL_SHARED_LOOKUP_MSM_H
#define LIXEL_SHARED_LOOKUP_MSM_H
#include "lixel/shared/lookup/how.h"

LX_SHARED_BEGIN

// The moments are of 2z - 1, which spreads them around 0. The share that is replaced by those of an even spread, so that rounding leaves
// them possible ones, and how much nearer a receiver must be taken for that.
const float LX_MOMENT_BIAS = 1.0e-5f;
const float LX_MOMENT_NEARER = 2.0e-3f;

LX_FN vec4 lxMsmMoments(float z)
{
    float s = 2.0f * z - 1.0f;
    return vec4(s, s * s, s * s * s, s * s * s * s);
}

// The three depths that have the four moments, z one of them; 1 less what must at least be before z. The matrix of moments is taken apart
// as L D L^T, which gives the polynomial whose roots are the other two.
LX_FN float lxLitByFourMoments(vec4 moments, float z)
{
    vec4 b = (1.0f - LX_MOMENT_BIAS) * moments + LX_MOMENT_BIAS * vec4(0.0f, 0.33333333f, 0.0f, 0.2f);
    float d2 = b.y - b.x * b.x;
    float l32d2 = b.z - b.x * b.y;
    float l32 = l32d2 / d2;
    float d3 = b.w - b.y * b.y - l32 * l32d2;
    // Solves the matrix times c = (1, z, z^2).
    float c1 = z - b.x;
    float c2 = z * z - b.y - l32 * c1;
    c1 = c1 / d2;
    c2 = c2 / d3;
    c1 = c1 - l32 * c2;
    float c0 = 1.0f - c1 * b.x - c2 * b.y;
    // c0 + c1 y + c2 y^2 = 0 has the other two.
    float middle = -0.5f * c1 / c2;
    float root = sqrt(max(middle * middle - c0 / c2, 0.0f));
    float z1 = middle - root;
    float z2 = middle + root;
    float before = 0.0f;
    if (z2 < z) before = 1.0f + (z1 * z2 - b.x * (z1 + z2) + b.y) / ((z - z1) * (z2 - z));
    else if (z1 < z) before = (z * z2 - b.x * (z + z2) + b.y) / ((z2 - z1) * (z - z1));
    return clamp(1.0f - before, 0.0f, 1.0f);
}

LX_FN float lxLitByMsm(vec4 m, float z) { return lxLitByFourMoments(m, 2.0f * z - 1.0f - LX_MOMENT_NEARER); }

LX_SHARED_END

#endif
