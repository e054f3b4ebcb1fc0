// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/scene.h"

#include <string>

namespace lixel {

// What every loaded scene must keep, whatever the format; throws InputError with the file's name. Some triangle with area; at
// most 2^26 triangles and vertices, instances counted; all meshes within 1e30 of the origin at rest; skins that have every
// joint their meshes name.
void checkScene(const Scene& scene, const std::string& file);

} // namespace lixel
