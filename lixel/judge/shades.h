// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/view_samples.h"
#include "lixel/judge/score.h"

#include <cstdint>
#include <span>

// Partial shadow: how many shades a technique has, how wide its transitions are, and how far it is from what they stand for.
namespace lixel {

// Of values against a truth of the same samples.
struct ShadeError
{
    std::int64_t samples = 0;
    double sumOfSquares = 0;
    double largest = 0;

    double rootMeanSquare() const;
};
ShadeError shadeError(std::span<const float> visibility, std::span<const float> truth);

struct Shades
{
    std::int64_t distinct = 0;     // values of light-facing samples, told apart to 1e-5
    std::int64_t inTransition = 0; // light-facing samples between 5 and 95 % lit
    double boundaryPixels =
        0; // length of the boundaries of exact visibility (score.h), in the mean over their directions
    std::int64_t darkInterior = 0;    // interior samples that are exactly dark, and ...
    double lightInDarkInterior = 0;   // the sum of their visibility: light that bleeds through
    std::int64_t litDarkInterior = 0; // of them, those that are lit when rounded: false lit far from any edge

    // Samples in transition per pixel of boundary; 0 without boundaries.
    double transitionPixels() const { return boundaryPixels > 0 ? double(inTransition) / boundaryPixels : 0; }
    double bleedingPercent() const { return darkInterior > 0 ? 100 * lightInDarkInterior / double(darkInterior) : 0; }
};

// All arrays have an entry a sample; with several samples in a pixel the first one stands for it in lengths.
Shades shadesOf(const ViewSamples& samples, std::span<const Zone> zones, std::span<const float> visibility,
                std::span<const float> exactVisibility);

} // namespace lixel
