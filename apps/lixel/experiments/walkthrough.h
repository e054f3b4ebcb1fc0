// SPDX-License-Identifier: MIT
#pragma once

#include "picture_options.h"

#include <string>

namespace lixel::app {

// The picture of Table 1 of Chong & Gortler 2007: a place to stand among the objects, a little above them, chosen by its look before
// anything was measured from there.
inline constexpr const char* kWalkthrough = "walkthrough: eye 0.6,1.3,3.4, target -1,0.5,-2, 60 degrees high";
Shooting walkthroughAt(const std::string& size);

} // namespace lixel::app
