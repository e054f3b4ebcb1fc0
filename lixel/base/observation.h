// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/view.h"
#include "lixel/base/view_samples.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lixel {

// Lights that a sample's word has bits for; those behind them in the list are not observed.
inline constexpr std::size_t kObservedLights = 32;

// How densely a picture is observed. 180 x 180 was enough for the scenes of Chong & Gortler 2007 (section 2.4).
struct ObservationGrid
{
    int width = 180, height = 180; // cells; never more than the picture has pixels
    friend bool operator==(const ObservationGrid&, const ObservationGrid&) = default;
};

// What an executor saw of a view at low resolution, for the plan of this or of a later frame.
//
//   H. Chong, S. Gortler. Scene Optimized Shadow Mapping. 2007, Algorithm 1, steps 1-3.
//
// Each cell of a grid over the picture gives the sample of the pixel nearest to its centre, if that pixel sees a surface; cells
// go row by row from the bottom. Neighbours are the four cells beside one. Arrays have samples.size() entries, but `lit` and
// `atBoundary` are empty where no light was looked up.
struct Observation
{
    // Pixels are those of the whole picture; a sample's weight is the number of pixels of its cell. `atDepthJump` marks samples
    // with a neighbour that sees another surface, or nothing.
    ViewSamples samples;

    std::vector<std::uint32_t> lit; // bit i: the sample faces light i, and its visibility, rounded (0.5 is lit), is 1

    // Bit i: at a shadow boundary of light i. A neighbour on the same surface, both facing the light, is not lit alike.
    std::vector<std::uint32_t> atBoundary;

    ObservationGrid grid; // cells, whether they see a surface or not
    View view;            // that it was taken with
    int ageFrames = 0;    // 0: of this very frame, 1: of the one before
};

} // namespace lixel
