// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/builtin.h"

// The built-in scenes, one file each. `values` has one value for each of their parameters.
namespace lixel::builtin {

extern const BuiltinScene kBunnies, kTable, kObjects, kColonnade, kFence, kCity, kLamp, kBalls;

} // namespace lixel::builtin
