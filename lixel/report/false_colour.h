// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/image.h"
#include "lixel/base/observation.h"
#include "lixel/base/surfaces.h"
#include "lixel/judge/score.h"

// What numbers look like in pictures; the report's legends are drawn by the same functions.
namespace lixel {

// Apart for people who cannot tell red from green; NotCounted and Right are transparent.
Rgba8 verdictColour(Verdict verdict);

// On a log scale from 2^-kDensityOctaves (red: one lixel for many pixels) over 1 (pale) to 2^kDensityOctaves (blue:
// more lixels than the picture can show); ends clamp, NaN is transparent.
inline constexpr int kDensityOctaves = 6;
Rgba8 densityColour(double lixelsPerPixel);

// The same scale of lengths, the other way round: red where a lixel is many pixels long, from 2^kDensityOctaves.
Rgba8 footprintColour(double pixelsPerLixel);

// Transparent where nothing is wrong: laid over the shaded picture.
Image<Rgba8> errorPicture(const Image<Verdict>& verdicts);

// Transparent where the value is NaN: no surface, or no lixel serves it.
Image<Rgba8> densityPicture(const Image<float>& lixelsPerPixel);
Image<Rgba8> footprintPicture(const Image<float>& pixelsPerLixel);

// The observed samples near shadow boundaries of a light, those at depth jumps left out, as a square in each one's cell;
// transparent elsewhere. Figure 2 of H. Chong, S. Gortler, Scene Optimized Shadow Mapping, 2007, over the shaded picture.
inline constexpr Rgba8 kBoundaryColour{255, 0, 200, 255};
Image<Rgba8> boundaryPicture(const Observation& observed, std::size_t light);

} // namespace lixel
