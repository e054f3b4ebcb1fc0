// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/gltf_file.h"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

// Accessors: typed arrays over buffer views (glTF 2.0, section 3.6.2), dense, interleaved, sparse or of zeros.
namespace lixel::gltf {

// What the glTF file calls an accessor's component, by OpenGL's numbers.
enum class Component { Byte = 5120, UnsignedByte, Short, UnsignedShort, UnsignedInt = 5125, Float };

// One accessor, every byte of it proved to be there; they are read when they are asked for. Valid while the file is.
class Accessor
{
public:
    Accessor(File& file, const JsonAt& reference);

    std::size_t count() const { return count_; }
    std::size_t components() const { return components_; } // 1 SCALAR ... 4 VEC4, 16 MAT4
    Component component() const { return component_; }

    // Refuses, naming the reference, any other number of components.
    const Accessor& expect(std::size_t components) const;

    // Elements as floats: normalized integers are mapped to [0, 1] or [-1, 1]. Refuses values that are not finite or
    // beyond 1e30. `elements` chooses some, in that order; each must be below count(). Empty: all.
    std::vector<float> floats() const;
    std::vector<float> floats(std::span<const std::uint32_t> elements) const;

    // Elements of an unsigned integer type.
    std::vector<std::uint32_t> integers() const;
    std::vector<std::uint32_t> integers(std::span<const std::uint32_t> elements) const;

private:
    void readShape(const JsonAt& accessor);
    void placeInView(const JsonAt& accessor);
    void overlaySparse(const JsonAt& sparse);
    std::span<const std::byte> bytesOf(const JsonAt& part, std::size_t elementBytes, std::size_t count) const;
    std::span<const std::byte> bytes() const; // from the first element on, stride_ apart

    File& file_;
    JsonAt reference_;
    std::size_t count_ = 0, components_ = 0, elementBytes_ = 0, stride_ = 0;
    Component component_ = Component::Float;
    bool isNormalized_ = false;
    int view_ = -1; // where it has one: from offset_ on, size_ bytes
    std::size_t offset_ = 0, size_ = 0;
    std::vector<std::byte> own_; // where the elements had to be put together
};

} // namespace lixel::gltf
