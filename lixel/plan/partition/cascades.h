// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/fit/visible_body.h"
#include "lixel/plan/partition/partition.h"

#include <span>

// Cells that follow each other along the line of sight.
namespace lixel {

// Parallel-split maps: the depths that are visible, split between evenly and logarithmically.
//
//   F. Zhang, H. Sun, L. Xu, L. K. Lun. Parallel-Split Shadow Maps for Large-Scale Virtual Environments. VRCIA 2006 ("practical
//   split"); with lambda, 1/2 by default, as in F. Zhang, H. Sun, O. Nyman. Parallel-Split Shadow Maps on Programmable GPUs.
//   GPU Gems 3, 2007, chapter 10:
//   C_i = lambda near (far / near)^(i / n) + (1 - lambda) (near + (far - near) i / n).
//
//   Needs    a scene
//   Returns  `count` cells, nearest first; one for a count of 1
//   Refuses  EmptyScene; NothingInView, unless stable
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
//   Refuses  EmptyScene; NoViewSamples; NothingInView, where no sample faces the light
//   Differs  samples that face away from the light do not count. No histogram: only the nearest and the farthest depth decide.
//            Parallel views are split evenly
//   Stable   not: its splits follow the samples. In a stable technique the nearest and the farthest depth, where both are before the
//            eye, are widened to powers of 2^(1/4)
CellsResult splitSdsm(const FitInput& input, int count);

// Cells between the given depths, ascending; outermost bounds are not asked of anyone. `splits` has count + 1 depths. A cell serves
// what is before its far bound and in no earlier one. It holds more than lies between its bounds, for the rounding of floats: on both
// sides 1e-5 of the far one, or where that is more 4e-7 of the distance from the eye's plane to the frame's origin.
Cells cellsBetween(const ViewDepth& depth, std::span<const double> splits);

} // namespace lixel
