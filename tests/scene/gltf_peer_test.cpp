// SPDX-License-Identifier: MIT
// A second opinion: tinygltf reads the same files, and its raw buffers must hold the positions we have.
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_INCLUDE_JSON
#include <nlohmann/json.hpp>
#include <tiny_gltf.h>

#include <gtest/gtest.h>

#include "scene/loaded.h"

#include <cstring>

namespace lixel::test {
namespace {

Vec3f peerPosition(const tinygltf::Model& model, const tinygltf::Accessor& accessor, std::size_t i)
{
    const tinygltf::BufferView& view = model.bufferViews.at(std::size_t(accessor.bufferView));
    const std::size_t at = view.byteOffset + accessor.byteOffset + i * std::size_t(accessor.ByteStride(view));
    float numbers[3];
    std::memcpy(numbers, &model.buffers.at(std::size_t(view.buffer)).data.at(at), sizeof numbers);
    return {numbers[0], numbers[1], numbers[2]};
}

std::uint32_t peerIndex(const tinygltf::Model& model, const tinygltf::Accessor& accessor, std::size_t i)
{
    const tinygltf::BufferView& view = model.bufferViews.at(std::size_t(accessor.bufferView));
    const std::size_t at = view.byteOffset + accessor.byteOffset + i * std::size_t(accessor.ByteStride(view));
    std::uint32_t index = 0; // little-endian, as the file is
    std::memcpy(&index, &model.buffers.at(std::size_t(view.buffer)).data.at(at),
                std::size_t(tinygltf::GetComponentSizeInBytes(std::uint32_t(accessor.componentType))));
    return index;
}

std::vector<Vec3f> peerCorners(const tinygltf::Model& model, const tinygltf::Primitive& primitive)
{
    const tinygltf::Accessor& positions = model.accessors.at(std::size_t(primitive.attributes.at("POSITION")));
    std::vector<Vec3f> corners;
    if (primitive.indices < 0) {
        for (std::size_t i = 0; i < positions.count; ++i) corners.push_back(peerPosition(model, positions, i));
        return corners;
    }
    const tinygltf::Accessor& indices = model.accessors.at(std::size_t(primitive.indices));
    for (std::size_t i = 0; i < indices.count; ++i)
        corners.push_back(peerPosition(model, positions, peerIndex(model, indices, i)));
    return corners;
}

bool ignoreImage(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int, void*)
{
    return true;
}

TEST(GltfPeer, BothReadersFindTheSameCornersInEveryMesh)
{
    const char* const files[] = {
        "sponza_crytek.glb",  "hospital_electrical.glb", "cesium_man.glb", "robot_expressive.glb",
        "littlest_tokyo.glb", "conference.glb",          "fox.glb"};
    for (const char* file : files) {
        LX_SKIP_WITHOUT_SCENE(file);
        const std::string path = (sceneFolder() / file).string();
        tinygltf::TinyGLTF reader;
        reader.SetImageLoader(ignoreImage, nullptr);
        tinygltf::Model model;
        std::string error, warning;
        ASSERT_TRUE(reader.LoadBinaryFromFile(&model, &error, &warning, path)) << error;

        const Scene scene = loadScene(path);
        std::size_t m = 0;
        for (const tinygltf::Mesh& peerMesh : model.meshes)
            for (const tinygltf::Primitive& primitive : peerMesh.primitives) {
                const Mesh& mesh = scene.meshes.at(m++);
                std::vector<Vec3f> ours;
                for (const std::uint32_t i : mesh.indices) ours.push_back(mesh.position.at(i));
                EXPECT_TRUE(ours == peerCorners(model, primitive)) << file << ", primitive " << m - 1;
            }
        EXPECT_EQ(m, scene.meshes.size()) << file;
    }
}

} // namespace
} // namespace lixel::test
