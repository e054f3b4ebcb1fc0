// SPDX-License-Identifier: MIT
#include "lixel/scene/deform.h"

#include <gtest/gtest.h>

#include "scene/loaded.h"
#include "support/random_cases.h"

namespace lixel::test {
namespace {

TEST(Skin, InItsBindPoseItIsTheRestMeshWhereverItsNodeIs)
{
    const SceneBuffers buffers = evaluateData("skin.glb", {0, 0});
    EXPECT_EQ(buffers.triangles.positionLocal, buffers.scene->meshes.at(0).position);
}

// The upper joint at (0, 1) has turned by 90 degrees: (x, 2) goes to (-1, 1 + x), and the middle row half way.
TEST(Skin, VerticesFollowTheirJointsByWeight)
{
    const SceneBuffers buffers = evaluateData("skin.glb", {1, 0});
    expectNear(buffers.triangles.positionLocal,
               {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5f, 1.5f, 0}, {-1, 1, 0}, {-1, 2, 0}}, 1e-6);
}

TEST(Skin, MoreThanFourInfluencesAVertexAreRead) { EXPECT_EQ(loadData("skin.glb")->meshes.at(0).influences, 8); }

// Weights that all go to one joint, in any number of shares, are a node's transform.
TEST(Skin, OfOneJointAloneItIsThatNodesTransform)
{
    forEachCase(kCases, [](Rng& rng) {
        Scene scene;
        scene.materials.emplace_back();
        Mesh mesh;
        mesh.influences = 4;
        for (int v = 0; v < 3; ++v) {
            mesh.position.push_back(toFloat(rng.inBox(5)));
            mesh.normal.push_back(toFloat(rng.onSphere()));
            for (int i = 0; i < 4; ++i) mesh.joints.push_back(0), mesh.weights.push_back(float(rng.uniform(0.1, 1)));
        }
        mesh.indices = {0, 1, 2};
        Node joint, skinned;
        joint.parentFromNode.translation = rng.inBox(10);
        joint.parentFromNode.scale = {rng.uniform(0.5, 2), rng.uniform(0.5, 2), -rng.uniform(0.5, 2)};
        const Vec3d axis = rng.onSphere();
        const double half = rng.uniform(0, 3);
        joint.parentFromNode.rotation = {std::sin(half) * axis.x, std::sin(half) * axis.y, std::sin(half) * axis.z,
                                         std::cos(half)};
        skinned.skin = 0;
        scene.nodes = {joint, skinned};
        scene.skins = {{{0}, {Mat4d{}}}};
        const Pose pose = restPose(scene);
        const PlacedMesh bySkin = placeMesh(scene, pose, 1, mesh, {}), byNode = placeMesh(scene, pose, 0, mesh, {});
        for (std::size_t v = 0; v < 3; ++v) {
            EXPECT_LE(length(bySkin.positionLocal[v] - byNode.positionLocal[v]), 1e-12);
            EXPECT_LE(length(toDouble(bySkin.normal[v]) - toDouble(byNode.normal[v])), 1e-6);
        }
    });
}

// A transformed normal stays at right angles to the transformed surface, on the side the surface faces.
TEST(Normals, StayPerpendicularUnderAnyAffineTransform)
{
    forEachCase(kCases, [](Rng& rng) {
        Scene scene;
        Node node;
        Mat4d matrix;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 4; ++j) matrix.m[i][j] = rng.uniform(-2, 2);
        node.parentFromNode.matrix = matrix;
        scene.nodes = {node};
        const Vec3d n = rng.onSphere(), s = anyPerpendicular(n), t = cross(n, s);
        Mesh mesh;
        mesh.position = {{0, 0, 0}, toFloat(s), toFloat(t)};
        mesh.normal.assign(3, toFloat(n));
        mesh.indices = {0, 1, 2};
        const PlacedMesh placed = placeMesh(scene, restPose(scene), 0, mesh, {});
        const Vec3d a = placed.positionLocal[1] - placed.positionLocal[0],
                    b = placed.positionLocal[2] - placed.positionLocal[0];
        const Vec3d normal = toDouble(placed.normal[0]), across = cross(a, b);
        if (length(across) < 1e-3) return; // nearly flattened
        EXPECT_NEAR(length(normal), 1, 1e-6);
        EXPECT_NEAR(dot(normal, normalized(a)), 0, 1e-4);
        EXPECT_NEAR(dot(normal, normalized(b)), 0, 1e-4);
        // The image of the direction out of the surface stays on the normal's side.
        EXPECT_GT(dot(normal, transformDirection(matrix, n)), -1e-5);
    });
}

TEST(Morph, WeightsOfTheMeshTheNodeAndTheAnimationEachTakeTheirPlace)
{
    const std::vector<Vec3f> found = corners(evaluateData("morph.gltf", {1, 0}));
    expectNear(found,
               {{0, 0, 0.5f},
                {1, 0, 0.5f},
                {0, 1, 0.5f}, // the mesh's own: half of the first target
                {0, 0, 0},
                {3, 0, 0},
                {0, 1, 0}, // the node's: all of the second
                {0, 0, 0.5f},
                {2, 0, 0.5f},
                {0, 1, 0.5f}}, // the animation's, half way: half of both
               1e-6);
}

TEST(Morph, WithoutWeightsTheMeshRests)
{
    forEachCase(kCases, [](Rng& rng) {
        Scene scene;
        scene.nodes.emplace_back();
        Mesh mesh;
        mesh.position = {toFloat(rng.inBox(3)), toFloat(rng.inBox(3)), toFloat(rng.inBox(3))};
        mesh.morphTargets.resize(2);
        mesh.morphTargets[0].position.assign(3, toFloat(rng.inBox(3)));
        if (rng.chance(0.5)) mesh.defaultMorphWeights = {0, 0};
        const PlacedMesh placed = placeMesh(scene, restPose(scene), 0, mesh, {});
        for (std::size_t v = 0; v < 3; ++v) EXPECT_EQ(placed.positionLocal[v], toDouble(mesh.position[v]));
    });
}

} // namespace
} // namespace lixel::test
