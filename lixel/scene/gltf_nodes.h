// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/gltf_meshes.h"

namespace lixel::gltf {

// Fills Scene::nodes and roots (of the default scene, else the first, else all nodes without a parent). Refuses node
// graphs that are not trees.
void readNodes(File& file, const std::vector<MeshRange>& meshes, Scene& scene);

// Fills Scene::skins; after readNodes().
void readSkins(File& file, Scene& scene);

// Fills Scene::cameras, in the space of their node: at 0, looking along -z, y up. The file's aspect ratio is left to
// the picture.
void readCameras(File& file, Scene& scene);

// Fills Scene::lights from KHR_lights_punctual, in the space of their node: at 0, shining along -z. Colours: colour
// times intensity, divided by the largest among the file's directional lights (lux), or among its others (candela):
// intensities are absolute, pictures are not. A spot's cone is twice its outer angle, its inner angle is not used.
void readLights(File& file, Scene& scene);

} // namespace lixel::gltf
