// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/scene.h"

#include <cstddef>
#include <string>

namespace lixel {

inline constexpr std::size_t kMostDrawn = std::size_t(1) << 26; // triangles, and vertices, of a scene

// What every loaded scene must keep, whatever the format; throws InputError with the file's name. Some triangle with area; at
// most 2^26 triangles and vertices, instances counted; all meshes within 1e30 of the origin at rest; skins that have every
// joint their meshes name.
void checkScene(const Scene& scene, const std::string& file);

} // namespace lixel
