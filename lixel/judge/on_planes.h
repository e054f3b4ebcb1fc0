// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/plane.h"
#include "lixel/base/view_samples.h"
#include "lixel/judge/score.h"

#include <cstdint>
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

// Of a plane whose lixels are its pixels nothing but rounding can go wrong. Which, of a misclassified sample:
enum class PlaneErrorCause : std::uint8_t {
    NearEdge, // at some point 1/64 lixel beside it on the plane exact visibility is another: a caster's edge is that near
    NearCaster,  // dark, but the caster is nearer than the depth precision of the map
    Unexplained, // an error of the technique or its executor
};

// `exactBeside` is the exact visibility of points kBesideLixels along +-x and +-y of the light image; `isNearCaster` whether an ideal map, with the same lookup, would call the sample lit as well though the ray meets a caster.
inline constexpr double kBesideLixels = 1.0 / 64;
PlaneErrorCause causeOfPlaneError(float exact, std::span<const float> exactBeside, bool isNearCaster);

struct PlaneErrorCauses
{
    std::int64_t nearEdge = 0, nearCaster = 0, unexplained = 0;

    void add(PlaneErrorCause cause);
};

} // namespace lixel
