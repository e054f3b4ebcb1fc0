// SPDX-License-Identifier: MIT
#include "lixel/scene/check_scene.h"

#include "lixel/scene/input_file.h"
#include "lixel/scene/pose.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lixel {
namespace {

constexpr double kMostCoordinate = 1e30;

struct MeshFacts
{
    Box box;
    bool hasArea = false;
    int mostJoint = -1;
};

MeshFacts factsOf(const Mesh& mesh)
{
    MeshFacts facts;
    for (const Vec3f& p : mesh.position) facts.box.include(toDouble(p));
    for (std::size_t i = 0; i + 2 < mesh.indices.size() && !facts.hasArea; i += 3) {
        const Vec3d a = toDouble(mesh.position[mesh.indices[i]]);
        const Vec3d ab = toDouble(mesh.position[mesh.indices[i + 1]]) - a;
        const Vec3d ac = toDouble(mesh.position[mesh.indices[i + 2]]) - a;
        facts.hasArea = cross(ab, ac) != Vec3d{};
    }
    for (const std::uint16_t joint : mesh.joints) facts.mostJoint = std::max(facts.mostJoint, int(joint));
    return facts;
}

bool isWithin(const Box& box, const Mat4d& worldFromNode)
{
    for (const Vec3d& corner : box.corners()) {
        const Vec3d p = transformPoint(worldFromNode, corner);
        if (!(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= kMostCoordinate)) return false;
    }
    return true;
}

} // namespace

void checkScene(const Scene& scene, const std::string& file)
{
    std::vector<MeshFacts> facts;
    for (const Mesh& mesh : scene.meshes) facts.push_back(factsOf(mesh));
    const Pose rest = restPose(scene);

    std::size_t triangles = 0, vertices = 0;
    bool hasArea = false;
    for (const int n : drawnNodes(scene)) {
        const Node& node = scene.nodes[std::size_t(n)];
        for (const int m : node.meshes) {
            const Mesh& mesh = scene.meshes[std::size_t(m)];
            const MeshFacts& of = facts[std::size_t(m)];
            triangles += mesh.indices.size() / 3, vertices += mesh.position.size();
            hasArea |= of.hasArea;
            const std::string place = fmt::format("nodes[{}]", n);
            if (triangles > kMostDrawn || vertices > kMostDrawn)
                refuse(file, place, fmt::format("expected at most {} triangles and vertices in all", kMostDrawn));
            if (!isWithin(of.box, rest.worldFromNode[std::size_t(n)]))
                refuse(file, place, "expected its mesh to be within 1e30 of the origin");
            if (node.skin >= 0 && of.mostJoint >= int(scene.skins[std::size_t(node.skin)].joints.size()))
                refuse(file, place,
                       fmt::format("expected joints below {}, the number in its skin, found {}",
                                   scene.skins[std::size_t(node.skin)].joints.size(), of.mostJoint));
        }
    }
    if (triangles == 0) refuse(file, "", "has no triangles");
    if (!hasArea) refuse(file, "", "has no triangles but such without area");
}

} // namespace lixel
