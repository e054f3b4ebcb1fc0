// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace lixel {

// Why shadow volumes cannot be had.
enum class VolumeFailure {
    MaskedCasters, // a silhouette says nothing of holes in a surface
    ParallelView   // rays of the view that never meet have no depth at which all volumes end
};
std::string_view nameOf(VolumeFailure failure);      // "masked-casters"
std::string_view sentenceFor(VolumeFailure failure); // for people

} // namespace lixel
