// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/fit/visible_body.h"
#include "lixel/plan/partition/partition.h"

#include <span>

// Cells that follow each other along the line of sight.
namespace lixel {

// Parallel-split maps: the depths that are visible, split between evenly and logarithmically.
//
//   F. Zhang, H. Sun, L. Xu, L. K. Lun. Parallel-Split Shadow Maps for Large-Scale Virtual Environments. VRCIA 2006:
//   C_i = lambda near (far / near)^(i / n) + (1 - lambda) (near + (far - near) i / n), lambda = 1/2 ("practical split").
//
//   Needs    a scene
//   Returns  `count` cells, nearest first; one for a count of 1
//   Refuses  NothingInView; EmptyScene
//   Differs  near and far are those of the visible body. Parallel views are split evenly.
//   Stable   near is the view's, far the scene's diagonal beyond it or the view's, and cells do not depend on the camera's
//            place; lights at a point have one cell, since their stable map is the uniform one
CellsResult splitPssm(const FitInput& input, int count, double lambda);

// Sample-distribution maps: logarithmic splits of the depths that view samples really have.
//
//   A. Lauritzen, M. Salvi, A. Lefohn. Sample Distribution Shadow Maps. I3D 2011, section 3 (logarithmic partitioning).
//
//   Needs    view samples that face the light, all that will be asked
//   Returns  `count` cells, nearest first; with `desired-view` in them their bounds are those of their samples
//   Refuses  NoViewSamples; NothingInView, where no sample faces the light
//   Differs  samples that face away from the light do not count
//   Stable   not: its splits follow the samples; in a stable technique they are widened to powers of 2^(1/4)
CellsResult splitSdsm(const FitInput& input, int count);

// Cells between the given depths, ascending; outermost bounds are not asked of anyone. `splits` has count + 1 depths.
Cells cellsBetween(const ViewDepth& depth, std::span<const double> splits);

} // namespace lixel
