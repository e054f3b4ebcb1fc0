// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/shadow_plan.h"

#include <span>
#include <string>
#include <vector>

// A plan as a file: what matrix(file) and plan(file) read, and what render --plan writes. JSON, one object:
//
//   convention  {"depth": "-1..1" | "0..1" | "1..0", "y": "up" | "down"}    of all matrices; the first of each by default
//   lights      [{"name": text, for any light where it is left out
//                 , "lightClipFromWorld": 4 rows of 4, applied to columns                        for matrix(file)
//                 | "regions": [{"lightClipFromWorld": likewise
//                                , "paraboloid": {...} where there is one, which is written and not read
//                                , "rectangle": [x0, y0, x1, y1] lixels, ends not included, row 0 at the bottom
//                                , "halfSpaces": [[nx, ny, nz, d], ...] world, inside where n . p + d >= 0}]   in the order they serve
//                }]
namespace lixel::app {

// Throws InputError: file, place, what was expected there. With `needsRectangles` every region must have one.
std::vector<GivenLight> readPlanFile(const std::string& path, bool needsRectangles);

// The regions of all lights that were not refused, in lixel's convention.
std::string toPlanJson(const FramePlan& plan, std::span<const Light> lights);

} // namespace lixel::app
