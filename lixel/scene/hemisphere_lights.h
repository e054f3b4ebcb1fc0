// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/light.h"

#include <cstdint>
#include <vector>

namespace lixel {

// Parallel lights from places uniform on the upper hemisphere (y up), all infinitely far: sun-000, sun-001, ... The same seed
// gives the same lights on every machine, and more of them begin with the fewer ones.
std::vector<Light> hemisphereLights(std::uint64_t seed, int count);

} // namespace lixel
