// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/fit/map_search.h"

namespace lixel {

// Light images from axes all over a hemisphere: far too slow for a frame, and what searchWidely() is held against.
struct Exhaustion
{
    int axes = 2000;          // evenly over the hemisphere around (0, 0, 1)
    std::size_t refined = 20; // the best of them
    int refinements = 60;     // of each
    std::size_t samplesOfAll =
        4096; // where there are more, these choose which axes and which rectangles all are asked of
};

// The rectangles are those of searchWidely(), or, with shear, the parallelograms too.
FoundMap searchExhaustively(const MapQuestion& question, const Exhaustion& exhaustion = {});

} // namespace lixel
