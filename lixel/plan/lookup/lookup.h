// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/technique.h"
#include "lixel/shared/lookup/how.h"

#include <string_view>

namespace lixel {

// What a technique's lookup needs and costs, as executors and allocation must know it. The lookup itself is
// lixel/shared/lookup/visibility.h, one text for both executors.
struct LookupLayout
{
    int tapsPerSide = 1; // a square grid of taps, one lixel apart; 2 where the four lixels around are weighed
    double reach = 1;    // lixels from the sample's place to the farthest border of a lixel that counts, per axis

    // Textures of every lixel beside the map of one 32-bit depth. Lookups of one depth read the map itself, others what is prepared from it.
    int preparedWords = 0;     // of several depths: words of 32 bits in one texture, 1, 2 or 4, and ...
    bool hasMoreWords = false; // one more in another
    int momentChannels =
        0; // of 32-bit floats: 0, 2 or 4, and as many more for the first of the two passes that average them
    bool hasGradients = false; // two 16-bit floats

    bool isPrepared() const { return preparedWords > 0 || momentChannels > 0 || hasGradients; }

    int bytesPerLixel = 4;     // of all these textures and the map
    int bytesReadPerLixel = 4; // of those that a lookup reads

    shared::LxLookup how = shared::lxOneDepth(1);
};

LookupLayout lookupLayout(const MapTechnique& technique);

// The square around a receiver that a lookup averages over, which is what its partial shadows stand for.
struct LixelFilter
{
    double side = 1;        // lixels
    bool isRotated = false; // by the angle of each receiver (lxTurned), as its taps are
};

LixelFilter filterOf(const LookupLayout& lookup);

// Why the lit share of such a square is not what visibility stands for; empty where it is.
std::string_view whyNoShare(const LookupLayout& lookup);

} // namespace lixel
