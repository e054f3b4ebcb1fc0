// SPDX-License-Identifier: MIT
#include "lixel/scene/outline_shells.h"

#include <gtest/gtest.h>

#include "scene/loaded.h"

#include <algorithm>

namespace lixel::test {
namespace {

bool isDrawn(const Scene& scene, const std::string& node)
{
    const auto found =
        std::find_if(scene.nodes.begin(), scene.nodes.end(), [&](const Node& n) { return n.name == node; });
    EXPECT_NE(found, scene.nodes.end()) << node;
    return found != scene.nodes.end() && !found->meshes.empty();
}

TEST(OutlineShells, BlackSingleSidedShellsTurnedInsideOutAreLeftOutAndOneLineSaysSo)
{
    const auto scene = loadData("outlines.glb");
    for (const char* shell : {"shell", "mirrored shell", "shell of three", "shell without indices"})
        EXPECT_FALSE(isDrawn(*scene, shell)) << shell;
    ASSERT_EQ(scene->warnings.size(), 1u);
    EXPECT_NE(scene->warnings[0].find("outlines.glb: 4 meshes left out"), std::string::npos) << scene->warnings[0];
    EXPECT_NE(scene->warnings[0].find("(first: 'shell')"), std::string::npos) << scene->warnings[0];
}

TEST(OutlineShells, WhateverLacksOneOfTheMarksStays)
{
    const auto scene = loadData("outlines.glb");
    for (const char* other : {"model", "coloured room", "two-sided room", "textured room", "glowing room",
                              "blended room", "black box", "black room without a side", "black sheet"})
        EXPECT_TRUE(isDrawn(*scene, other)) << other;
}

TEST(OutlineShells, AFileOfNothingElseKeepsItsShell)
{
    const SceneBuffers buffers = evaluateData("only_a_shell.gltf");
    EXPECT_EQ(buffers.triangles.triangleCount(), 12u);
    EXPECT_TRUE(buffers.scene->warnings.empty());
}

// The rule is one of shape: where the shell lies and how large it is makes no difference.
TEST(OutlineShells, SizeAndPlaceCountForNothing)
{
    const auto scene = loadData("only_a_shell.gltf");
    for (const float scale : {1e-6f, 1.0f, 1e6f, 1e20f})
        for (const Vec3f offset : {Vec3f{}, Vec3f{30, -20, 10}}) {
            Mesh mesh = scene->meshes.at(0);
            const Material& material = scene->materials.at(std::size_t(mesh.material));
            for (Vec3f& p : mesh.position)
                p = {scale * (p.x + offset.x), scale * (p.y + offset.y), scale * (p.z + offset.z)};
            EXPECT_TRUE(isOutlineShell(mesh, material)) << scale << " " << offset.x;
            std::reverse(mesh.indices.begin(), mesh.indices.end());
            EXPECT_FALSE(isOutlineShell(mesh, material)) << scale << " " << offset.x;
        }
}

} // namespace
} // namespace lixel::test
