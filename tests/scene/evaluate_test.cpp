// SPDX-License-Identifier: MIT
#include "lixel/scene/evaluate.h"

#include <gtest/gtest.h>

#include "scene/loaded.h"
#include "support/random_cases.h"

namespace lixel::test {
namespace {

// Some triangles under a random chain of nodes.
std::shared_ptr<Scene> anyScene(Rng& rng, double extent)
{
    auto scene = std::make_shared<Scene>();
    scene->materials.resize(2);
    for (int m = 0; m < 3; ++m) {
        Mesh mesh;
        mesh.material = m % 2;
        for (int v = 0; v < 9; ++v) mesh.position.push_back(toFloat(rng.inBox(1)));
        for (std::uint32_t i = 0; i < 9; ++i) mesh.indices.push_back(i);
        scene->meshes.push_back(mesh);
        Node node;
        node.parentFromNode.translation = rng.inBox(extent);
        node.meshes = {m};
        if (m < 2) node.children = {m + 1};
        scene->nodes.push_back(node);
    }
    scene->roots = {0};
    return scene;
}

TEST(Evaluate, TwiceIsBitEqual)
{
    for (const char* file : {"skin.glb", "morph.gltf", "node_animation.gltf", "texture_mask.glb"}) {
        const SceneBuffers a = evaluateData(file, {0.3, 0}), b = evaluateData(file, {0.3, 0});
        EXPECT_EQ(a.triangles.positionLocal, b.triangles.positionLocal) << file;
        EXPECT_EQ(a.triangles.indices, b.triangles.indices) << file;
        EXPECT_EQ(a.version, b.version) << file;
    }
}

TEST(Evaluate, AnotherOriginMovesLocalPositionsByTheDifferenceWithinRounding)
{
    forEachCase(kCases, [](Rng& rng) {
        const auto scene = anyScene(rng, 10);
        const Vec3d from = rng.inBox(50), to = rng.inBox(50);
        const SceneBuffers a = evaluate(scene, {}, from), b = evaluate(scene, {}, to);
        ASSERT_EQ(a.triangles.positionLocal.size(), b.triangles.positionLocal.size());
        for (std::size_t i = 0; i < a.triangles.positionLocal.size(); ++i) {
            const Vec3d pa = toDouble(a.triangles.positionLocal[i]) + from,
                        pb = toDouble(b.triangles.positionLocal[i]) + to;
            EXPECT_LE(length(pa - pb), 2e-5); // two roundings of numbers up to 100
        }
        EXPECT_NE(a.version, b.version);
    });
}

TEST(Evaluate, FarFromTheOriginANearOriginKeepsEveryDigit)
{
    forEachCase(kCases, [](Rng& rng) {
        const auto scene = anyScene(rng, 1);
        const Vec3d far = 1e5 * rng.onSphere();
        const SceneBuffers near = evaluate(scene, {}, {});
        scene->nodes[0].parentFromNode.translation = scene->nodes[0].parentFromNode.translation + far;
        const SceneBuffers moved = evaluate(scene, {}, far);
        for (std::size_t i = 0; i < near.triangles.positionLocal.size(); ++i)
            EXPECT_LE(length(toDouble(near.triangles.positionLocal[i]) - toDouble(moved.triangles.positionLocal[i])),
                      1e-6);
    });
}

TEST(Evaluate, BoundsHoldEveryTriangleAndAgreeWithTheScenes)
{
    forEachCase(kCases, [](Rng& rng) {
        const auto scene = anyScene(rng, 100);
        const SceneBuffers buffers = evaluate(scene, {}, rng.inBox(100));
        ASSERT_EQ(buffers.bounds.boxesWorld.size(), 3u);
        const Box total = buffers.bounds.total(), expected = sceneBounds(*scene, {});
        expectNear(total.min, expected.min, 1e-4);
        expectNear(total.max, expected.max, 1e-4);
        for (std::size_t t = 0; t < buffers.triangles.triangleCount(); ++t)
            for (std::size_t c = 0; c < 3; ++c) {
                const Vec3d p = toDouble(buffers.triangles.positionLocal[buffers.triangles.indices[3 * t + c]]) +
                                buffers.triangles.originWorld;
                const Box& box = buffers.bounds.boxesWorld[t / 3];
                EXPECT_TRUE(p.x >= box.min.x && p.y >= box.min.y && p.z >= box.min.z);
                EXPECT_TRUE(p.x <= box.max.x && p.y <= box.max.y && p.z <= box.max.z);
            }
    });
}

TEST(Evaluate, TrianglesWithoutAreaAreLeftOut)
{
    auto scene = std::make_shared<Scene>();
    scene->materials.emplace_back();
    scene->meshes.resize(1);
    scene->meshes[0].position = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}};
    scene->meshes[0].indices = {0, 1, 2, 0, 1, 3, 1, 1, 3};
    scene->nodes.resize(1);
    scene->nodes[0].meshes = {0};
    scene->roots = {0};
    const SceneBuffers buffers = evaluate(scene, {}, {});
    EXPECT_EQ(buffers.triangles.indices, (std::vector<std::uint32_t>{0, 1, 3}));
    EXPECT_EQ(buffers.triangles.material.size(), 1u);
}

TEST(Evaluate, WhatIsDrivenBeyondAllNumbersIsNotDrawnAndNothingIsInfinite)
{
    auto scene = std::make_shared<Scene>();
    scene->materials.emplace_back();
    scene->meshes.resize(1);
    scene->meshes[0].position = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    scene->meshes[0].indices = {0, 1, 2};
    scene->nodes.resize(2);
    for (Node& node : scene->nodes) node.meshes = {0};
    scene->nodes[1].parentFromNode.scale = {1e300, 1, 1};
    scene->roots = {0, 1};
    const SceneBuffers buffers = evaluate(scene, {}, {});
    EXPECT_EQ(buffers.triangles.triangleCount(), 1u);
    EXPECT_EQ(buffers.bounds.boxesWorld.size(), 1u);
    for (const Vec3f& p : buffers.triangles.positionLocal) EXPECT_TRUE(isFinite(toDouble(p)));
}

TEST(Evaluate, TheVersionTellsContentsApart)
{
    const auto scene = std::make_shared<Scene>(*loadData("texture_mask.glb"));
    const std::uint64_t version = evaluate(scene, {}, {}).version;
    EXPECT_EQ(evaluate(scene, {7, 0}, {}).version, version) << "nothing moves";
    EXPECT_NE(evaluate(scene, {}, {1, 0, 0}).version, version);
    scene->textures[0].pixels(0, 0).a = 7;
    const std::uint64_t otherTexel = evaluate(scene, {}, {}).version;
    EXPECT_NE(otherTexel, version);
    scene->materials[0].alphaCutoff = 0.75f;
    EXPECT_NE(evaluate(scene, {}, {}).version, otherTexel);
    const auto moving = loadData("skin.glb");
    EXPECT_NE(evaluate(moving, {0.25, 0}, {}).version, evaluate(moving, {0.5, 0}, {}).version);
}

TEST(Evaluate, CastersAreTheTriangles)
{
    const SceneBuffers buffers = evaluateData("texture_mask.glb");
    const CasterBuffers casters = buffers.casters();
    const LocalTriangles flat = flatten(casters);
    EXPECT_EQ(flat.positionLocal, buffers.triangles.positionLocal);
    EXPECT_EQ(flat.indices, buffers.triangles.indices);
    EXPECT_EQ(flat.uv, buffers.triangles.uv);
    EXPECT_EQ(flat.material, buffers.triangles.material);
    EXPECT_EQ(casters.materials.size(), buffers.scene->materials.size());
    EXPECT_EQ(casters.textures.data(), buffers.scene->textures.data());
    EXPECT_EQ(casters.version, buffers.version);
}

TEST(Evaluate, ARuleOfTheScenesOwnIsAskedFirstAndTheSceneIsLeftAsItWas)
{
    auto scene = std::make_shared<Scene>(*loadData("data_uri.gltf"));
    scene->animate = [](Scene& copy, double time) { copy.nodes.at(0).parentFromNode.translation.x = time; };
    const SceneBuffers buffers = evaluate(scene, {3, 0}, {});
    EXPECT_EQ(corners(buffers), (std::vector<Vec3f>{{3, 0, 0}, {4, 0, 0}, {3, 1, 0}}));
    EXPECT_EQ(sceneBounds(*scene, {3, 0}).min.x, 3);
    EXPECT_EQ(scene->nodes.at(0).parentFromNode.translation.x, 0);
}

TEST(ChooseOrigin, IsNearAnEyeInTheSceneAndStaysWhileItMovesALittle)
{
    forEachCase(kCases, [](Rng& rng) {
        const double size = rng.logUniform(1e-3, 1e4);
        const Vec3d centre = 1e5 * rng.onSphere();
        const Box box{centre - size * Vec3d{1, 1, 1}, centre + size * Vec3d{1, 1, 1}};
        const Vec3d eye = centre + rng.inBox(2 * size);
        const Vec3d origin = chooseOrigin(eye, box);
        EXPECT_LE(length(origin - eye), 0.5 * box.diagonal());
        int changes = 0;
        Vec3d before = origin;
        for (int step = 1; step <= 10; ++step) {
            const Vec3d now = chooseOrigin(eye + 0.001 * step * Vec3d{size, 0, 0}, box);
            changes += now == before ? 0 : 1;
            before = now;
        }
        EXPECT_LE(changes, 1);
    });
}

TEST(ChooseOrigin, OfAnEyeFarOutsideIsWithinReachOfTheScene)
{
    const Box box{{-1, -1, -1}, {1, 1, 1}};
    EXPECT_LE(length(chooseOrigin({1e6, 0, 0}, box)), 4 * box.diagonal());
    EXPECT_EQ(chooseOrigin({1, 2, 3}, Box{}), (Vec3d{1, 2, 3}));
}

} // namespace
} // namespace lixel::test
