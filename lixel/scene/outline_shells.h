// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/scene.h"

#include <string>

namespace lixel {

// Outlines drawn as an inverted hull: a black copy of a model, a little larger and turned inside out, of which back-face
// culling shows only the far side, as a rim. Our triangles have two sides for eye, light and rays, so such a shell would
// hide its model and keep all light from it.
//
// A mesh is one when all of this holds:
//   material   single-sided, opaque, without texture and emission, base colour of luminance below 0.05
//   closed     of the directed edges, positions compared, at most one in ten has no partner of the opposite direction
//   inside out the signed volumes of its connected parts, each about the middle of its own box, sum to less than minus half
//              the sum of their tetrahedra's absolute volumes. Convex parts inside out give -1, right side out +1, sheets
//              without thickness next to nothing
// Judged in model space at rest, before morphs and skins.
//
// So is a black single-sided room, that is seen only from within: where faces are culled it keeps no light out either.
bool isOutlineShell(const Mesh& mesh, const Material& material);

// Takes such meshes off the nodes, and says so in one line of Scene::warnings. A scene of nothing else keeps them: there is
// no model that they hide. For formats that cull single-sided faces (glTF 2.0, section 3.9.6), which OBJ does not say.
void leaveOutOutlineShells(Scene& scene, const std::string& file);

} // namespace lixel
