// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/gltf_file.h"
#include "lixel/scene/scene.h"

namespace lixel::gltf {

// Fills Scene::animations; after readNodes(). Channels of other targets than a node's place and morph weights (by
// extensions) are left out with a warning.
void readAnimations(File& file, Scene& scene);

} // namespace lixel::gltf
