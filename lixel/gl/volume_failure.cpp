// SPDX-License-Identifier: MIT
#include "lixel/gl/volume_failure.h"

#include "lixel/base/assert.h"

namespace lixel {

std::string_view nameOf(VolumeFailure failure)
{
    switch (failure) {
    case VolumeFailure::MaskedCasters: return "masked-casters";
    case VolumeFailure::ParallelView: return "parallel-view";
    }
    LX_ASSERT(false);
    return "";
}

std::string_view sentenceFor(VolumeFailure failure)
{
    switch (failure) {
    case VolumeFailure::MaskedCasters:
        return "the scene has alpha-masked surfaces, whose holes have no silhouette that a volume could hang from";
    case VolumeFailure::ParallelView: return "shadow volumes that end at infinity need a perspective view";
    }
    LX_ASSERT(false);
    return "";
}

} // namespace lixel
