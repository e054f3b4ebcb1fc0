// SPDX-License-Identifier: MIT
// The same as vsm.h of e^(cz), evsm2; of -e^(-cz) too, the lesser of both, evsm4.
//
//   A. Lauritzen, M. McCool. Layered Variance Shadow Maps. GI 2008.
#ifndef LIXEL_SHARED_LOOKUP_EVSM_H
#define LIXEL_SHARED_LOOKUP_EVSM_H
#include "lixel/shared/lookup/vsm.h"

LX_SHARED_BEGIN

// c: floats hold e^(2c), and the sum of a few, up to 44.
const float LX_EVSM_EXPONENT = 40.0f;
// What rounding leaves of the exponential's variance, against its square.
const float LX_LEAST_EVSM_VARIANCE = 1.0e-6f;

LX_FN vec4 lxEvsmMoments(float z)
{
    float up = exp(LX_EVSM_EXPONENT * (2.0f * z - 1.0f));
    float down = -1.0f / up;
    return vec4(up, up * up, down, down * down);
}

LX_FN float lxLitByEvsm(vec4 m, bool hasBoth, float z)
{
    float up = exp(LX_EVSM_EXPONENT * (2.0f * z - 1.0f));
    float lit = lxChebyshev(m.x, m.y, LX_LEAST_EVSM_VARIANCE * m.x * m.x, up);
    if (!hasBoth) return lit;
    return min(lit, lxChebyshev(m.z, m.w, LX_LEAST_EVSM_VARIANCE * m.z * m.z, -1.0f / up));
}

LX_SHARED_END

#endif
