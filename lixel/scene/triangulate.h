// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lixel {

// A simple polygon, nearly flat, convex or not, cut into corners.size() - 2 triangles of the same orientation by
// clipping ears (G. Meisters. Polygons Have Ears. American Mathematical Monthly 82, 1975). Appends indices into
// `corners`. What is not simple, or longer than 512 corners, becomes a fan.
void triangulatePolygon(std::span<const Vec3d> corners, std::vector<std::uint32_t>& triangles);

} // namespace lixel
