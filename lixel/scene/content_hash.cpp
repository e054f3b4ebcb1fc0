// SPDX-License-Identifier: MIT
#include "lixel/scene/content_hash.h"

#include <cstring>
#include <type_traits>
#include <vector>

namespace lixel {
namespace {

// Eight bytes a step, multiplied and folded; the multipliers are odd numbers without pattern (digits of the golden
// ratio).
class Hasher
{
public:
    void add(const void* data, std::size_t size)
    {
        const auto* bytes = static_cast<const std::byte*>(data);
        add(std::uint64_t(size));
        for (; size >= 8; bytes += 8, size -= 8) {
            std::uint64_t word;
            std::memcpy(&word, bytes, 8);
            add(word);
        }
        std::uint64_t rest = 0;
        if (size > 0) std::memcpy(&rest, bytes, size);
        add(rest);
    }
    void add(std::uint64_t word)
    {
        state_ = (state_ ^ word) * 0x9e3779b97f4a7c15u;
        state_ ^= state_ >> 32;
    }
    template <typename T>
    void add(const std::vector<T>& values)
    {
        static_assert(std::is_trivially_copyable_v<T> && (sizeof(T) % 4 == 0)); // floats or bytes without padding
        add(values.data(), values.size() * sizeof(T));
    }
    std::uint64_t value() const { return state_ ^ state_ >> 29; }

private:
    std::uint64_t state_ = 0x9e3779b97f4a7c15u;
};

} // namespace

std::uint64_t contentHash(const LocalTriangles& triangles, const Scene& scene)
{
    Hasher hasher;
    hasher.add(&triangles.originWorld, sizeof(Vec3d));
    hasher.add(triangles.positionLocal);
    hasher.add(triangles.indices);
    hasher.add(triangles.uv);
    hasher.add(triangles.colour);
    hasher.add(triangles.normal);
    hasher.add(triangles.material);
    for (const Material& material : scene.materials) {
        hasher.add(&material.baseColour, sizeof(Vec4f));
        hasher.add(std::uint64_t(material.texture + 1) << 8 | std::uint64_t(material.alphaMode) << 1 |
                   std::uint64_t(material.doubleSided));
        hasher.add(&material.alphaCutoff, sizeof(float));
        hasher.add(&material.emission, sizeof(Vec3f));
    }
    for (const Texture& texture : scene.textures) {
        hasher.add(std::uint64_t(texture.pixels.width()) << 32 | std::uint64_t(texture.pixels.height()) << 8 |
                   std::uint64_t(texture.wrapU) << 4 | std::uint64_t(texture.wrapV));
        hasher.add(texture.pixels.data());
    }
    return hasher.value();
}

} // namespace lixel
