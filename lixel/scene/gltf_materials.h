// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/gltf_file.h"
#include "lixel/scene/scene.h"

#include <vector>

namespace lixel::gltf {

// Where a material's base colour texture is looked up: uv = offset + turn * (scale * TEXCOORD_set), as
// KHR_texture_transform has it. Meshes apply it once, when they are read.
struct UvSource
{
    int set = 0;
    Vec2d rowU{1, 0}, rowV{0, 1}, offset{0, 0};
    bool isIdentity = true;
};

// Fills Scene::materials and Scene::textures: one material for each of the file, and glTF's default (white, opaque)
// after them. Only images that are used are decoded. BLEND becomes Mask with cutoff 0.5; an emissive texture counts by
// its mean. Returns one UvSource a material.
std::vector<UvSource> readMaterials(File& file, Scene& scene);

} // namespace lixel::gltf
