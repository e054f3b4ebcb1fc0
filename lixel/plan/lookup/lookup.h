// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/technique.h"

namespace lixel {

// What a store and kernel need and cost, as executors and allocation must know it. The lookup itself is
// lixel/shared/lookup.h, one text for both executors.
struct LookupLayout
{
    int tapsPerSide = 1;   // a square grid of taps, one lixel apart
    int bytesPerLixel = 4; // one depth of 32 bits
    double reach = 1;      // lixels from the sample's place to the farthest border of a tapped lixel, per axis
};

LookupLayout lookupLayout(const Store& store, const Kernel& kernel);

} // namespace lixel
