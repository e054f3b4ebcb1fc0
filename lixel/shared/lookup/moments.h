// SPDX-License-Identifier: MIT
// Moments of the depths around a lixel, and the light that they let through at most: one text for the CPU executor and for GLSL.
//
// z is 1 less the even depth (even_depth.h): 0 at the near side, 1 at the far and where nothing is, linear in distance.
#ifndef LIXEL_SHARED_LOOKUP_MOMENTS_H
#define LIXEL_SHARED_LOOKUP_MOMENTS_H
#include "lixel/shared/lookup/even_depth.h"
#include "lixel/shared/lookup/evsm.h"
#include "lixel/shared/lookup/maps.h"
#include "lixel/shared/lookup/msm.h"
#include "lixel/shared/lookup/vsm.h"

LX_SHARED_BEGIN

// Of one even depth.
LX_FN vec4 lxMomentsOf(LxLookup how, float even)
{
    if (how.store == LX_STORE_VSM) return lxVsmMoments(1.0f - even);
    if (how.store == LX_STORE_MSM) return lxMsmMoments(1.0f - even);
    return lxEvsmMoments(1.0f - even);
}

// What mean moments say of a receiver at an even depth.
LX_FN float lxLitByMoments(LxLookup how, vec4 moments, float even)
{
    if (how.store == LX_STORE_VSM) return lxLitByVsm(moments, 1.0f - even);
    if (how.store == LX_STORE_MSM) return lxLitByMsm(moments, 1.0f - even);
    return lxLitByEvsm(moments, how.store == LX_STORE_EVSM4, 1.0f - even);
}

LX_SHARED_END

#endif
