// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "scene/loaded.h"

#include <ctime>
#include <filesystem>
#include <map>

namespace lixel::test {
namespace {

// Every file of tests/data/bad, and what is said about it after its name.
const std::map<std::string, std::string> kMessages{
    {"accessor_type.gltf",
     "meshes[0].primitives[0].attributes.POSITION: expected an accessor of 3 components, found 2"},
    {"accessor_word.gltf", "accessors[0].type: expected SCALAR, VEC2, VEC3, VEC4 or MAT4 here, found 'VEC7?'"},
    {"animation_node.gltf", "animations[0].channels[0].target.node: expected the index of one of the 1 nodes"},
    {"animation_times.gltf", "animations[0].samplers[0].input: expected times in ascending order"},
    {"animation_values.gltf", "animations[0].samplers[0].output: expected 6 numbers for 2 keys, found 9"},
    {"array.gltf", "JSON: expected an object"},
    {"bad_accessor.gltf", "meshes[0].primitives[0].attributes.POSITION: expected the index of one of the 1 accessors"},
    {"bad_alpha.gltf", "materials[0].alphaMode: expected OPAQUE, MASK or BLEND, found 'GLASS'"},
    {"bad_buffer.gltf", "bufferViews[0].buffer: expected the index of one of the 1 buffers"},
    {"bad_camera.gltf", "cameras[0].perspective.yfov: expected a number from 1e-06 to 3.14159"},
    {"bad_light.gltf",
     "extensions.KHR_lights_punctual.lights[0].type: expected directional, point or spot, found 'area'"},
    {"bad_material.gltf", "meshes[0].primitives[0].material: expected no index: the file has no materials"},
    {"bad_mode.gltf", "meshes[0].primitives[0].mode: expected an integer from 0 to 6"},
    {"bad_near.gltf", "cameras[0].perspective.zfar: expected more than znear, 2, found 1"},
    {"bad_root.gltf", "scenes[0].nodes[0]: expected the index of one of the 1 nodes"},
    {"bad_scene.gltf", "scene: expected the index of one of the 1 scenes"},
    {"bad_view.gltf", "accessors[0].bufferView: expected the index of one of the 1 bufferViews"},
    {"bomb.gltf", "nodes[64]: expected at most 67108864 triangles and vertices in all"},
    {"buffer_absolute.gltf", "buffers[0].uri: expected a file beside this one, found '/etc/passwd'"},
    {"buffer_base64.gltf", "buffers[0].uri: expected base64 after 'data:...;base64,'"},
    {"buffer_beyond.gltf", "buffers[0].byteLength: expected at most 36, the bytes that are there"},
    {"buffer_missing.gltf", "buffers[0].uri: @/no such file.bin: no such file"},
    {"buffer_network.gltf", "buffers[0].uri: expected a file beside this one, found 'https://example.org/a.bin'"},
    {"buffer_none.gltf", "buffers[0]: expected a 'uri', or to be the binary chunk of a GLB file"},
    {"chunk_too_long.glb", "GLB chunk 0: expected 4294967280 bytes, found 380"},
    {"component_type.gltf",
     "accessors[0].componentType: expected a component type of glTF: 5120 to 5123, 5125 or 5126"},
    {"corner.obj", "line 4: expected a corner i, i/j, i//k or i/j/k, found '1/'"},
    {"count_beyond.gltf", "accessors[0].count: expected an integer from 1 to 4294967295"},
    {"count_huge.gltf", "accessors[0]: expected 4000000000 elements within the 36 bytes of its bufferView, found the "
                        "last to end at 48000000000"},
    {"count_negative.gltf", "accessors[0].count: expected an integer from 1 to 4294967295"},
    {"count_zero.gltf", "accessors[0].count: expected an integer from 1 to 4294967295"},
    {"cycle.gltf", "nodes[1]: expected a tree of nodes, found a cycle"},
    {"deep.gltf", "expected JSON of at most 64 levels"},
    {"draco.gltf", "extensionsRequired[0]: the file needs 'KHR_draco_mesh_compression', which is not supported"},
    {"empty.glb", "is empty"},
    {"empty.obj", "is empty"},
    {"far_away.gltf", "nodes[0].translation[0]: expected a number from -1e+30 to 1e+30"},
    {"far_scaled.gltf", "nodes[0]: expected its mesh to be within 1e30 of the origin"},
    {"fraction_index.gltf", "nodes[0].mesh: expected the index of one of the 1 meshes"},
    {"header_only.glb", "GLB header: expected 20 bytes, found 16"},
    {"huge_mesh_index.gltf", "nodes[0].mesh: expected the index of one of the 1 meshes"},
    {"huge_number.gltf", "expected numbers that fit a double"},
    {"image_bomb.gltf", "images[0]: expected 16000x16000 pixels, found only 96 bytes"},
    {"image_broken.gltf", "images[0]: expected a PNG, JPEG, BMP or TGA image of at most 16384x16384 pixels"},
    {"image_huge.gltf", "images[0]: expected an image of at most 16384x16384 pixels, found 20000x20"},
    {"image_missing.gltf", "images[0].uri: @/no such.png: no such file"},
    {"image_none.gltf", "images[0]: expected 'bufferView'"},
    {"image_truncated.gltf", "images[0]: expected a whole image: outofdata"},
    {"index_before.obj", "line 4: expected indices from -3, found -4"},
    {"index_beyond.gltf", "meshes[0].primitives[0].indices: expected indices below 3, the number of vertices, found 3"},
    {"index_beyond.obj", "line 5: expected indices up to 3, found 4"},
    {"index_huge.obj", "line 4: expected an index other than 0, up to 1e9, found '4294967299'"},
    {"index_zero.obj", "line 4: expected an index other than 0, up to 1e9, found '0'"},
    {"infinite.obj", "line 2: expected a number up to 1e30, found '1e99'"},
    {"infinite_vertex.gltf",
     "meshes[0].primitives[0].attributes.POSITION: expected finite numbers up to 1e30, found inf in element 2"},
    {"joint_beyond.gltf", "nodes[0]: expected joints below 1, the number in its skin, found 4"},
    {"joints_alone.gltf", "meshes[0].primitives[0].attributes: expected JOINTS_0 and WEIGHTS_0 together"},
    {"nan.obj", "line 2: expected a number up to 1e30, found 'nan'"},
    {"nan_vertex.gltf",
     "meshes[0].primitives[0].attributes.POSITION: expected finite numbers up to 1e30, found nan in element 1"},
    {"negative_index.gltf", "nodes[0].mesh: expected the index of one of the 1 meshes"},
    {"no_asset.gltf", "asset: expected glTF 2.0, found JSON without 'asset'"},
    {"no_faces.obj", "has no triangles"},
    {"no_source.gltf", "textures[0]: expected a 'source': images in other formats (KTX2, WebP) are not supported"},
    {"no_triangles.gltf", "has no triangles"},
    {"not_gltf.glb", "expected glTF: a GLB file, or JSON in UTF-8"},
    {"not_json.gltf", "line 2, column 17: expected JSON"},
    {"not_utf8.gltf", "expected glTF: a GLB file, or JSON in UTF-8"},
    {"nothing_huge.gltf", "accessors[0].count: expected at most 256 MiB of accessors without bytes"},
    {"offset_beyond.gltf",
     "accessors[0]: expected 3 elements within the 36 bytes of its bufferView, found the last to end at 44"},
    {"offset_overflow.gltf", "bufferViews[0].byteOffset: expected an integer from 0 to 1099511627776"},
    {"only_points.gltf", "has no triangles"},
    {"own_child.gltf", "nodes[0]: expected a tree of nodes, found a cycle"},
    {"projective_matrix.gltf", "nodes[0].matrix: expected an affine matrix: elements 3, 7, 11, 15 must be 0, 0, 0, 1"},
    {"root_twice.gltf", "scenes[0].nodes[1]: expected a node without a parent, named once"},
    {"short_matrix.gltf", "nodes[0].matrix: expected 16 numbers"},
    {"short_vertex.obj", "line 1: expected 3 numbers, found 2"},
    {"signed_indices.gltf", "meshes[0].primitives[0].indices: expected an accessor of unsigned integers"},
    {"skin_joint.gltf", "skins[0].joints[0]: expected the index of one of the 1 nodes"},
    {"skin_matrices.gltf", "skins[0].inverseBindMatrices: expected 2 matrices, one a joint, found 1"},
    {"sparse_index.gltf", "accessors[0].sparse.indices: expected indices below 3, found 3"},
    {"stride.gltf", "bufferViews[0].byteStride: expected an integer from 4 to 252"},
    {"text_index.gltf", "nodes[0].mesh: expected the index of one of the 1 meshes"},
    {"truncated.glb", "GLB header: expected 400 bytes in all, found 380: is the file truncated?"},
    {"two_parents.gltf", "nodes[2]: expected one parent, found nodes[0] and nodes[1]"},
    {"uneven_attributes.gltf", "meshes[0].primitives[0].attributes.NORMAL: expected 3 elements, one a vertex, found 2"},
    {"unknown.xyz", "expected a glTF (.gltf, .glb) or OBJ (.obj) file"},
    {"version_1.glb", "GLB header: expected version 2, found 1"},
    {"version_1.gltf", "asset.version: expected glTF 2.x, found '1.0'"},
    {"vertex_too_far.gltf",
     "meshes[0].primitives[0].attributes.POSITION: expected finite numbers up to 1e30, found 3e+30 in element 2"},
    {"view_beyond.gltf", "bufferViews[0]: expected bytes 0 to 4096 within the 36 of its buffer"},
    {"word.obj", "line 1: expected a number up to 1e30, found 'zero'"},
    {"zero_area.gltf", "has no triangles but such without area"},
    {"zero_byte.obj", "expected OBJ text, found a zero byte"},
    {"zero_quaternion.gltf", "nodes[0].rotation: expected a unit quaternion"},
};

std::string refusalOf(const std::string& path)
{
    try {
        loadScene(path);
    } catch (const InputError& error) {
        return error.what();
    }
    return "(loaded)";
}

TEST(BadFiles, EachGetsOneClearLineWithinASecond)
{
    const std::string folder = (dataFolder() / "bad").string();
    for (const auto& [file, message] : kMessages) {
        const std::string path = folder + "/" + file;
        std::string expected = path + ": " + message;
        if (const std::size_t at = expected.find('@'); at != expected.npos) expected.replace(at, 1, folder);
        const std::clock_t start = std::clock(); // of the processor: other work on the machine does not count
        EXPECT_EQ(refusalOf(path), expected);
        EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, 1) << file;
        EXPECT_EQ(expected.find('\n'), std::string::npos);
    }
}

TEST(BadFiles, NoneIsForgotten)
{
    for (const auto& entry : std::filesystem::directory_iterator(dataFolder() / "bad"))
        EXPECT_EQ(kMessages.count(entry.path().filename().string()), 1u) << entry.path();
}

TEST(BadFiles, WhatIsNoFileIsNamed)
{
    const std::string folder = dataFolder().string();
    EXPECT_EQ(refusalOf(folder + "/nowhere.glb"), folder + "/nowhere.glb: no such file");
    EXPECT_EQ(refusalOf(folder), folder + ": is a directory; expected a file");
    EXPECT_EQ(refusalOf("/dev/null"), "/dev/null: expected a regular file");
    EXPECT_EQ(refusalOf(""), ": no such file");
}

TEST(BadFiles, FromMemoryNoOtherFileIsTouched)
{
    const std::string text = R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 4, "uri": "a.bin"}]})";
    try {
        loadGltf(std::as_bytes(std::span(text)), "memory", "");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "memory: buffers[0].uri: needs the file 'a.bin', which is not at hand here");
    }
}

// A file that is cut anywhere is refused, not read beyond its end.
TEST(BadFiles, ATruncatedFileIsRefusedWhereverItIsCut)
{
    const std::string path = (dataFolder() / "skin.glb").string();
    const std::size_t size = std::filesystem::file_size(path);
    std::vector<std::byte> bytes(size);
    FILE* file = std::fopen(path.c_str(), "rb");
    ASSERT_EQ(std::fread(bytes.data(), 1, size, file), size);
    std::fclose(file);
    for (std::size_t cut = 0; cut < size; cut += 7)
        EXPECT_THROW(loadGltf(std::span(bytes).first(cut), "cut", ""), InputError) << cut;
}

} // namespace
} // namespace lixel::test
