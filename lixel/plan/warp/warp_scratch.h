// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/warp/importance.h"
#include "lixel/plan/warp/line_functions.h"

#include <cstdint>
#include <vector>

// Room that warps are made in.
namespace lixel {

struct WarpScratch
{
    std::vector<std::uint32_t> map;      // of importance
    std::vector<std::uint32_t> greatest; // in each column, or in each row
    std::vector<PlacedSample> moved;
    LineScratch lines;
};

// Of all regions of a light, and the storage of earlier plans' knots.
struct RegionWarpScratch
{
    ImportanceScratch importance;
    std::vector<WeighedSample> samples;
    std::vector<std::uint8_t> regionOf; // of each sample
    std::vector<PlacedSample> placed;
    WarpScratch warp;
    std::vector<std::vector<float>> spareKnots;
};

} // namespace lixel
