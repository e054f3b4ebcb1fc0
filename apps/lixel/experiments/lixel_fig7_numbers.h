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

// What no one size of map tells: planes with a lixel a pixel, and without a map for the rest; both in frames that are shown.
inline constexpr const char* kPlanesExactly = "planes(floor,wall)+plane-optimal+allocation=exact";
inline constexpr const char* kPlanesAlone = "planes(floor,wall)+plane-optimal(uncovered=lit)";

// Of a camera close to the floor, that looks at the wall: a map for the floor, with and without one for the rest.
inline constexpr const char* kLowCamera = "low-wall";
inline constexpr const char* kFloor = "planes(floor)+plane-optimal";
inline constexpr const char* kFloorAlone = "planes(floor)+plane-optimal(uncovered=lit)";

// Of the light, which name it.
inline constexpr const char* kElongated = "elongated";
inline constexpr const char* kInFront = "in-front";

// Mean and worst frame of each technique, then the claims; of one scene, one row a frame and technique, the low camera's view named by
// kLowCamera at its end.
std::vector<ReproducedNumber> numbersOfScene(const std::string& scene, std::span<const ResultRow> rows);

// Frames a second and against the conventional map's, of the rows with times. Nothing without times.
std::vector<ReproducedNumber> timingNumbersOf(const std::string& scene, std::span<const ResultRow> rows);

} // namespace lixel::app
