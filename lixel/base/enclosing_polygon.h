// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/vec.h"

#include <cstddef>
#include <span>

namespace lixel {

// Drops sides of a convex polygon, counter-clockwise without repeated corners, until at most `most` are left, each time the one
// that adds the least area: its two neighbours then run on until they meet. The polygon that is left holds the one that was
// given, but for rounding, and its sides lie on sides of that. Works in place and returns the count of corners; `most` is
// at least four, since a parallelogram has no side to drop.
std::size_t encloseWithFewerCorners(std::span<Vec2d> corners, std::size_t most);

} // namespace lixel
