// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/gltf_json.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <vector>

namespace lixel::gltf {

struct BufferView
{
    std::span<const std::byte> bytes;
    std::size_t stride = 0; // 0: elements lie side by side
};

// A glTF 2.0 file taken apart: its JSON, and its buffers with their views, all within bounds. Each later stage
// (accessors, materials, meshes, nodes, animations) reads from this.
//
//   Khronos Group. glTF 2.0 Specification, version 2.0.1. Sections 3.6 (binary data) and 4 (GLB).
//
//   Differs  tinygltf is not used: it narrows integers without a word, reads image views unchecked, refuses some
//            legal files and does not say where a file is wrong. It is the second opinion of the tests.
class File
{
public:
    // `bytes` must outlive this. Throws InputError.
    File(std::span<const std::byte> bytes, std::string name, std::string baseDirectory);
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    const std::string& name() const { return name_; }
    JsonAt root() const { return {json_, "", name_}; }

    // The top-level arrays: "nodes", "meshes" ... An absent one has no elements.
    std::size_t count(const char* array) const;
    JsonAt element(const char* array, int i) const;

    BufferView view(int i) const { return views_[std::size_t(i)]; }

    // The bytes behind a URI: inside it (base64), or of a file beside this one.
    std::vector<std::byte> readUri(const JsonAt& uri) const;

    // Counts what is unpacked, so that a small file cannot ask for endless memory: shared accessors, many references.
    void spend(std::size_t bytes, const JsonAt& where);
    // Likewise for elements that have no bytes in the file at all (accessors without a view).
    void spendOnNothing(std::size_t bytes, const JsonAt& where);

    std::vector<std::string> warnings;

private:
    std::span<const std::byte> splitGlb(std::span<const std::byte> bytes);
    void parseJson(std::span<const std::byte> bytes);
    void checkVersionAndExtensions() const;
    void loadBuffers();
    void loadViews();

    std::string name_, baseDirectory_;
    nlohmann::json json_;
    std::span<const std::byte> bin_;
    std::deque<std::vector<std::byte>> ownBuffers_;
    std::vector<std::span<const std::byte>> buffers_;
    std::vector<BufferView> views_;
    std::size_t spent_ = 0, spentOnNothing_ = 0;
};

} // namespace lixel::gltf
