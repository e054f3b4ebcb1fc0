// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/gltf_json.h"
#include "lixel/scene/input_file.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lixel::gltf {

struct BufferView
{
    std::size_t size = 0;
    std::size_t stride = 0; // 0: elements lie side by side
};

// A glTF 2.0 file taken apart: its JSON, and its buffers with their views, all within bounds; bytes are read when they are
// asked for. Each later stage (accessors, materials, meshes, nodes, animations) reads from this.
//
//   Khronos Group. glTF 2.0 Specification, version 2.0.1. Sections 3.6 (binary data) and 4 (GLB).
//
//   Differs  tinygltf is not used: it narrows integers without a word, reads image views unchecked, refuses some
//            legal files and does not say where a file is wrong. It is the second opinion of the tests.
class File
{
public:
    // `bytes` must outlive this. Throws InputError.
    File(InputBytes& bytes, std::string name, std::string baseDirectory);
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    const std::string& name() const { return name_; }
    JsonAt root() const { return {json_, "", name_}; }

    // The top-level arrays: "nodes", "meshes" ... An absent one has no elements.
    std::size_t count(const char* array) const;
    JsonAt element(const char* array, int i) const;

    BufferView view(int i) const;
    // Of view i; within it. Valid until the next call for the same view.
    std::span<const std::byte> bytes(int i, std::size_t offset, std::size_t count);

    // The bytes of an image behind a URI: inside it (base64), or of a file beside this one.
    std::vector<std::byte> readImage(const JsonAt& uri) const;

    // Counts what is unpacked, so that a small file cannot ask for endless memory: shared accessors, many references.
    void spend(std::size_t bytes, const JsonAt& where);
    // Likewise for elements that have no bytes in the file at all (accessors without a view).
    void spendOnNothing(std::size_t bytes, const JsonAt& where);

    std::vector<std::string> warnings;

private:
    struct Range
    {
        std::size_t offset = 0, size = 0;
    };

    // Where the bytes of a buffer are: in the GLB, in a URI, or in a file beside this one.
    struct Buffer
    {
        std::size_t length = 0;
        std::size_t inGlb = 0; // offset
        std::vector<std::byte> inUri;
        std::optional<InputBytes> beside;
    };

    struct View
    {
        std::size_t buffer = 0;
        Range range;
        std::size_t stride = 0;
        std::vector<std::byte> bytes; // those of isRead
        Range isRead;                 // within the view
    };

    Range splitGlb();
    void readJson(Range range);
    void checkVersionAndExtensions() const;
    void loadBuffers();
    Buffer openBuffer(const JsonAt& uri) const;
    void loadViews();
    std::string pathOf(const JsonAt& uri) const;

    InputBytes& bytes_;
    std::string name_, baseDirectory_;
    nlohmann::json json_;
    Range bin_;
    std::vector<Buffer> buffers_;
    std::vector<View> views_;
    std::size_t read_ = 0, spent_ = 0, spentOnNothing_ = 0;
};

} // namespace lixel::gltf
