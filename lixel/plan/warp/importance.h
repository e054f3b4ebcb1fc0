// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/light.h"
#include "lixel/base/observation.h"
#include "lixel/base/view.h"
#include "lixel/base/view_samples.h"
#include "lixel/plan/warp/warp_choice.h"

#include <cstdint>
#include <span>
#include <vector>

// Which samples a warp is made from, how much each counts, and how many fall into each lixel.
//
//   P. Rosen. Rectilinear Texture Warping for Fast Adaptive Shadow Mapping. 2012.
//   T. Milet, J. Navratil, P. Zemcik. An Improved Non-Orthogonal Texture Warping for Better Shadow Rendering. 2015, section 3,
//   step 2.
//
//   Differs  sums are of integers (LX_IMPORTANCE_UNIT), of 32 bits where the paper has 16: whatever counts them, in whatever order,
//            comes to the same map
namespace lixel {

// What one light's samples are weighed by.
struct ImportanceSource
{
    const View& view;
    const Light& light;
    Vec3d originWorld;
    const ViewSamples* seen = nullptr;             // by the view; for backward analysis and hybrid
    std::span<const ViewSamples> seenByLight = {}; // a picture a region; for forward analysis and hybrid
    const Observation* observed = nullptr;         // where shadows end; nothing: no weight knows
    std::size_t lightNumber = 0;                   // in the observation
};

// A sample that faces the light.
struct WeighedSample
{
    Vec3f positionLocal;
    std::uint32_t units = 0; // of LX_IMPORTANCE_UNIT
};

// Room to work in.
struct ImportanceScratch
{
    std::vector<std::uint32_t> sampleOfPixel; // kNoSample where there is none
    std::vector<std::uint8_t> atEdge;
    std::vector<std::uint8_t> nearBoundary; // of the observation's cells
};

// Those that count; `out` is cleared first. A weight that nothing is known for is left out of products and maxima.
void weighSamples(const ImportanceSource& source, const WarpOptions& options, ImportanceScratch& scratch,
                  std::vector<WeighedSample>& out);

// A sample in the square that is warped, within [0, 1).
struct PlacedSample
{
    float x = 0, y = 0;
    std::uint32_t units = 0;
};

// What falls into each cell, row by row: the sum, or the greatest.
void countSamples(std::span<const PlacedSample> samples, int columns, int rows, bool isCounted,
                  std::vector<std::uint32_t>& map);

} // namespace lixel
