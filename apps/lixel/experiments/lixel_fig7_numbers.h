// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/reproduction.h"

#include <array>
#include <span>
#include <string>
#include <vector>

// What section 4 of "A Lixel for every Pixel" claims of its Figure 7, as numbers of rows.
namespace lixel::app {

// Rows name them so. The paper's conventional map includes the hull of its extent, as `focused` does.
inline constexpr const char* kConventional = "focused";
inline constexpr const char* kPerspective = "psm";
inline constexpr const char* kPlanes = "planes(floor,wall)+plane-optimal";
inline constexpr std::array<const char*, 6> kComparedMaps{"uniform", kConventional, kPerspective,
                                                          "lispsm",  kPlanes,       "planes(auto)+plane-optimal"};

// Of the light, which name it.
inline constexpr const char* kElongated = "elongated";
inline constexpr const char* kInFront = "in-front";

// Mean and worst frame of each technique, then the claims; of one scene, one row a frame and technique.
std::vector<ReproducedNumber> numbersOfScene(const std::string& scene, std::span<const ResultRow> rows);

// Frames a second, of the rows with times.
std::vector<ReproducedNumber> timingNumbersOf(std::span<const ResultRow> rows);

} // namespace lixel::app
