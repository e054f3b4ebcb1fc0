// SPDX-License-Identifier: MIT
// Moments of the depths around a lixel, and the light that they let through at most: one text for the CPU executor and for GLSL.
//
//   vsm     z, z^2 and Chebyshev's inequality    W. Donnelly, A. Lauritzen. Variance Shadow Maps. I3D 2006.
//   evsm2   the same of e^(cz)                   A. Lauritzen, M. McCool. Layered Variance Shadow Maps. GI 2008.
//   evsm4   of e^(cz) and -e^(-cz), the lesser of both
//   msm     z to z^4, the least that four moments allow (Hamburger's problem)
//                                                C. Peters, R. Klein. Moment Shadow Mapping. I3D 2015, section 4.
//
// z is 1 less the even depth (even_depth.h): 0 at the near side, 1 at the far and where nothing is, linear in distance.
#ifndef LIXEL_SHARED_LOOKUP_MOMENTS_H
#define LIXEL_SHARED_LOOKUP_MOMENTS_H
#include "lixel/shared/lookup/even_depth.h"
#include "lixel/shared/lookup/maps.h"

LX_SHARED_BEGIN

// c: floats hold e^(2c), and the sum of a few, up to 44.
const float LX_EVSM_EXPONENT = 40.0f;
// What rounding leaves of a variance: of z, and of the exponential against its square.
const float LX_LEAST_VARIANCE = 4.0e-7f;
const float LX_LEAST_EVSM_VARIANCE = 1.0e-6f;
// Of four moments of 2z - 1, which spreads them around 0: the share that is replaced by those of an even spread, so that rounding leaves
// them possible ones, and how much nearer a receiver must be taken for that.
const float LX_MOMENT_BIAS = 1.0e-5f;
const float LX_MOMENT_NEARER = 2.0e-3f;

// Of one even depth.
LX_FN vec4 lxMomentsOf(LxLookup how, float even)
{
    float z = 1.0f - even;
    if (how.store == LX_STORE_VSM) return vec4(z, z * z, 0.0f, 0.0f);
    if (how.store == LX_STORE_MSM) {
        float s = 2.0f * z - 1.0f;
        return vec4(s, s * s, s * s * s, s * s * s * s);
    }
    float up = exp(LX_EVSM_EXPONENT * (2.0f * z - 1.0f));
    float down = -1.0f / up;
    return vec4(up, up * up, down, down * down);
}

// The share of depths not before z that a mean and a mean of squares allow at most.
LX_FN float lxChebyshev(float mean, float meanOfSquares, float leastVariance, float z)
{
    if (z <= mean) return 1.0f;
    float variance = max(meanOfSquares - mean * mean, leastVariance);
    float away = z - mean;
    return variance / (variance + away * away);
}

LX_FN float lxLitByEvsm(vec4 m, bool hasBoth, float z)
{
    float up = exp(LX_EVSM_EXPONENT * (2.0f * z - 1.0f));
    float lit = lxChebyshev(m.x, m.y, LX_LEAST_EVSM_VARIANCE * m.x * m.x, up);
    if (!hasBoth) return lit;
    return min(lit, lxChebyshev(m.z, m.w, LX_LEAST_EVSM_VARIANCE * m.z * m.z, -1.0f / up));
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

// What mean moments say of a receiver at an even depth.
LX_FN float lxLitByMoments(LxLookup how, vec4 moments, float even)
{
    float z = 1.0f - even;
    if (how.store == LX_STORE_VSM) return lxChebyshev(moments.x, moments.y, LX_LEAST_VARIANCE, z);
    if (how.store == LX_STORE_MSM) return lxLitByFourMoments(moments, 2.0f * z - 1.0f - LX_MOMENT_NEARER);
    return lxLitByEvsm(moments, how.store == LX_STORE_EVSM4, z);
}

LX_SHARED_END

#endif
