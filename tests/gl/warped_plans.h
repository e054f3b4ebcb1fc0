// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/shadow_plan.h"
#include "support/random_cases.h"

namespace lixel::test {

// What a plan's tables are after its regions' warps were changed.
void rebuildWarps(FramePlan& plan);

// Gives every region of the plan a warp of a grid of up to `lines` lines, as different as any or as smooth as planned ones are, each
// region its own; one in ten stays without.
void warpRegions(FramePlan& plan, Rng& rng, WarpRaster raster, int guard = 0);

// A warp of the whole square whose functions wave softly, `lines` of each kind.
TextureWarp smoothWarp(const LixelRectangle& square, int lines, double strength, Rng& rng);

// Functions as planned ones are: of the counts of view samples in the map's lixels, smoothed over `smooth` lines to either side, a
// twentieth of the density even.
TextureWarp countedWarp(const PlannedRegion& region, const ViewSamples& samples, int smooth);

} // namespace lixel::test
