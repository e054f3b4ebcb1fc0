// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/lookup/lookup.h"
#include "lixel/plan/warp/warp_scratch.h"

#include <span>

// Warps for the regions of a light, once they have their matrices and rectangles.
namespace lixel {

struct PlannedRegion; // shadow_plan.h
struct FramePlan;

// Takes back the knots of a plan that is about to be made anew.
void recycleKnots(FramePlan& plan, RegionWarpScratch& scratch);

// Every sample counts for the first region that serves it. A region that serves none, or is too small to leave a lixel within its guard
// bands, has no warp.
void warpRegions(const ImportanceSource& source, const WarpChoice& choice, const LookupLayout& lookup,
                 RegionWarpScratch& scratch, std::span<PlannedRegion> regions);

// Regions on paraboloids that have none get the identity, in one cell: what is drawn and looked up then goes one way with that of warps.
void warpParaboloids(WarpRaster raster, RegionWarpScratch& scratch, std::span<PlannedRegion> regions);

// Even ones, for a device to fill.
void warpRegionsEvenly(const WarpChoice& choice, const LookupLayout& lookup, RegionWarpScratch& scratch,
                       std::span<PlannedRegion> regions);

} // namespace lixel
