// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/plane.h"
#include "lixel/base/view_samples.h"
#include "lixel/judge/score.h"

#include <span>
#include <vector>

// Errors on planes of interest apart from all others.
namespace lixel {

inline constexpr int kOnNoPlane = -1;

// Of every sample the first plane that it lies on: nearer to it than the floats of its position tell, with the same normal but for
// a thousandth of a radian, and within its polygon where it has one; else kOnNoPlane.
std::vector<int> planeOfSamples(const ViewSamples& samples, std::span<const NamedPlane> planes);

// Light-facing samples and misclassified ones of each plane, then of those on none.
std::vector<ZoneScore> scoreOfPlanes(std::span<const int> planeOf, std::size_t planes, std::span<const Zone> zones,
                                     std::span<const float> visibility, std::span<const float> exactVisibility);

} // namespace lixel
