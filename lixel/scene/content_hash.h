// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/scene.h"

#include <cstdint>

namespace lixel {

// A number that differs, but for 1 in 2^64, when anything differs that an executor draws: triangles and their origin,
// materials, texels and how they wrap.
std::uint64_t contentHash(const LocalTriangles& triangles, const Scene& scene);

} // namespace lixel
