// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/pose.h"

#include <vector>

namespace lixel {

// A mesh as one node places it: morph targets, then the skin or the node's own transform (glTF 2.0, sections 3.7.2.2
// and 3.7.3). A skinned mesh ignores where its node is; its vertices without weight stay with the node.
//
//   Needs    a mesh of Scene::meshes and the node that has it, posed
//   Returns  positions relative to originWorld, worked out in double and not yet rounded; not finite where the
//            file's numbers overflow. Normals are unit or zero, empty where the mesh has none.
struct PlacedMesh
{
    std::vector<Vec3d> positionLocal;
    std::vector<Vec3f> normal;
};

PlacedMesh placeMesh(const Scene& scene, const Pose& pose, int node, const Mesh& mesh, Vec3d originWorld);

} // namespace lixel
