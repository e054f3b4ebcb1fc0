// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "scene/loaded.h"

namespace lixel::test {
namespace {

TEST(GltfMaterial, AMaskedTextureKeepsItsTexelsCutoffWrapAndUvSet)
{
    const SceneBuffers buffers = evaluateData("texture_mask.glb");
    const Material& material = buffers.scene->materials.at(buffers.triangles.material.at(0));
    EXPECT_EQ(material.baseColour, (Vec4f{1, 0.5f, 0.25f, 0.75f}));
    EXPECT_EQ(material.alphaMode, AlphaMode::Mask);
    EXPECT_EQ(material.alphaCutoff, 0.25f);
    EXPECT_TRUE(material.doubleSided);
    EXPECT_EQ(material.emission, (Vec3f{0, 0.5f, 1}));

    const Texture& texture = buffers.scene->textures.at(std::size_t(material.texture));
    EXPECT_EQ(texture.wrapU, Wrap::ClampToEdge);
    EXPECT_EQ(texture.wrapV, Wrap::MirroredRepeat);
    ASSERT_EQ(texture.pixels.width(), 4);
    ASSERT_EQ(texture.pixels.height(), 4);
    // Row 0 is v = 0, which in glTF is the first row of the file: there the right half has alpha 0.
    EXPECT_EQ(texture.pixels(0, 0).r, 255);
    EXPECT_EQ(texture.pixels(3, 0).a, 0);
    EXPECT_EQ(texture.pixels(3, 3).a, 192);
    EXPECT_EQ(buffers.triangles.uv, (std::vector<Vec2f>{{0, 1}, {1, 1}, {1, 0}, {0, 0}}));
}

TEST(GltfMaterial, AnImageBesideTheFileIsRead)
{
    const auto scene = loadData("texture_file.gltf");
    ASSERT_EQ(scene->textures.size(), 1u);
    EXPECT_EQ(scene->textures[0].pixels(1, 0).r, 255);
    EXPECT_EQ(scene->textures[0].pixels(1, 0).g, 0);
    EXPECT_EQ(scene->textures[0].pixels(0, 1).g, 255);
}

TEST(GltfMaterial, BlendBecomesAMaskOfOneHalf)
{
    const auto scene = loadData("blend.glb");
    for (const std::size_t i : {0u, 1u}) {
        EXPECT_EQ(scene->materials.at(i).alphaMode, AlphaMode::Mask);
        EXPECT_EQ(scene->materials.at(i).alphaCutoff, 0.5f);
    }
    EXPECT_EQ(scene->materials[0].baseColour.w, 0.3f);
    EXPECT_EQ(scene->materials[1].baseColour.w, 0.6f);
}

TEST(GltfMaterial, WithoutAMaterialTheSurfaceIsOpaqueWhite)
{
    const SceneBuffers buffers = evaluateData("data_uri.gltf");
    const Material& material = buffers.scene->materials.at(buffers.triangles.material.at(0));
    EXPECT_EQ(material.baseColour, (Vec4f{1, 1, 1, 1}));
    EXPECT_EQ(material.alphaMode, AlphaMode::Opaque);
    EXPECT_EQ(material.texture, -1);
}

// offset (1/2, 1/4), a quarter turn, scale (2, 3): by the extension's matrices (u, v) becomes (1/2 + 3v, 1/4 - 2u).
TEST(GltfMaterial, ATextureTransformIsAppliedToTheUv)
{
    const std::vector<Vec2f> uv = loadData("texture_transform.gltf")->meshes.at(0).uv;
    ASSERT_EQ(uv.size(), 3u);
    const Vec2d expected[] = {{0.5, 0.25}, {0.5, -1.75}, {3.5, 0.25}};
    for (std::size_t i = 0; i < 3; ++i) EXPECT_LE(length(toDouble(uv[i]) - expected[i]), 1e-6) << i;
}

TEST(GltfMaterial, VertexColoursOfBytesAndOfFloatsAreRead)
{
    const auto scene = loadData("vertex_colours.gltf");
    EXPECT_EQ(scene->meshes.at(0).colour, (std::vector<Vec4f>{{1, 0, 0, 1}, {0, 1, 0, 0.2f}, {0, 0, 1, 0}}));
    EXPECT_EQ(scene->meshes.at(1).colour, (std::vector<Vec4f>(3, {0.25f, 0.5f, 0.75f, 1})));
}

} // namespace
} // namespace lixel::test
