// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/image.h"
#include "lixel/base/surfaces.h"
#include "lixel/plan/shadow_plan.h"

#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

// What a warp does to a map, as the figures of Milet et al. 2015 show it.
namespace lixel::app {

// Where the view samples of a light's first region lie in the square that its warp warps, within [0, 1).
std::vector<Vec2d> placesInSquare(const PlannedRegion& region, const ViewSamples& samples, const Light& light);

// How many of them fall into each cell, from dark (one) to white (most), on a log scale; black: none.
struct CountedPlate
{
    Image<Rgba8> picture;
    double usedShare = 0; // cells with a sample
};
CountedPlate countedPlate(std::span<const Vec2d> places, int columns, int rows,
                          const std::function<Vec2d(Vec2d)>& move);

// The offsets of every row's function: yellow to the right, blue to the left, black where nothing moves; full at `most` of the map.
Image<Rgba8> offsetsPlate(const TextureWarp& warp, double most);
double mostOffset(const TextureWarp& warp);

// Depths of a map, white near and dark far, stretched to what it holds; black: nothing.
Image<Rgba8> depthPlate(const Image<float>& layer, const LixelRectangle& rectangle);

} // namespace lixel::app
