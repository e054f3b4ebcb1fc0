// SPDX-License-Identifier: MIT
// From a receiver to its visibility through one region: one text for the CPU executor and for GLSL.
#ifndef LIXEL_SHARED_LOOKUP_VISIBILITY_H
#define LIXEL_SHARED_LOOKUP_VISIBILITY_H
#include "lixel/shared/lookup/bilinear.h"
#include "lixel/shared/lookup/pcf.h"
#ifndef LX_ONE_DEPTH
#include "lixel/shared/lookup/filtered_moments.h"
#include "lixel/shared/lookup/hardware_pcf.h"
#endif

LX_SHARED_BEGIN

// Visibility: 1 lit, 0 in shadow. Taps stop at the region's rectangle. `seed` is lxSeedOf the receiver.
LX_MAP_FN float lxVisibility(LxLookup how, ShadowRegion region, LxReceiver r, uint seed LX_MAP)
{
#ifndef LX_ONE_DEPTH
    if (lxHasMoments(how)) return lxLitByMomentsAround(how, region, r LX_PASS_MAP);
    if (how.kernel == LX_KERNEL_HARDWARE) return lxLitByHardware(region, r LX_PASS_MAP);
#endif
    if (how.kernel == LX_KERNEL_BILINEAR) return lxLitByAreas(how, region, r LX_PASS_MAP) >= 0.5f ? 1.0f : 0.0f;
    return lxLitByTaps(how, region, r, seed LX_PASS_MAP);
}

LX_SHARED_END

#endif
