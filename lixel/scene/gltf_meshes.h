// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/gltf_materials.h"

namespace lixel::gltf {

// Which of Scene::meshes come from one mesh of the file: its primitives of triangles.
struct MeshRange
{
    int first = 0, count = 0;
};

// Fills Scene::meshes; strips and fans become triangles, points and lines are left out with a warning. Only vertices
// that triangles use are kept, in the file's order. Returns one range a mesh of the file.
std::vector<MeshRange> readMeshes(File& file, const std::vector<UvSource>& uvSources, Scene& scene);

} // namespace lixel::gltf
