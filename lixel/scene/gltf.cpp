// SPDX-License-Identifier: MIT
#include "lixel/scene/check_scene.h"
#include "lixel/scene/gltf_animation.h"
#include "lixel/scene/gltf_file.h"
#include "lixel/scene/gltf_materials.h"
#include "lixel/scene/gltf_meshes.h"
#include "lixel/scene/gltf_nodes.h"
#include "lixel/scene/input_file.h"
#include "lixel/scene/load.h"
#include "lixel/scene/outline_shells.h"

#include <new>

namespace lixel {

Scene loadGltf(InputBytes& bytes, const std::string& name, const std::string& baseDirectory)
{
    try {
        gltf::File file(bytes, name, baseDirectory);
        Scene scene;
        scene.name = sceneName(name);
        const auto uvSources = gltf::readMaterials(file, scene);
        const auto meshes = gltf::readMeshes(file, uvSources, scene);
        gltf::readNodes(file, meshes, scene);
        gltf::readSkins(file, scene);
        gltf::readCameras(file, scene);
        gltf::readLights(file, scene);
        gltf::readAnimations(file, scene);
        scene.warnings = std::move(file.warnings);
        leaveOutOutlineShells(scene, name);
        checkScene(scene, name);
        return scene;
    } catch (const std::bad_alloc&) {
        refuse(name, "", "expected a scene that fits into memory");
    }
}

} // namespace lixel
