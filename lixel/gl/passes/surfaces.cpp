// SPDX-License-Identifier: MIT
#include "lixel/gl/passes/surfaces.h"

#include "lixel/base/assert.h"
#include "lixel/gl/device/draw_state.h"
#include "lixel/shared/alpha.h"
#include "lixel/shared/gl_slots.h"
#include "lixel/shared/view_tables.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>

namespace lixel::gl {
namespace {

// Ranges of triangles start at multiples of this, so that every array of theirs starts at one of 256 bytes.
constexpr std::uint32_t kTriangleStep = 64;

// Triangles that are culled together. Runs four times as long take about as long to draw with culling, sixteen times as long a
// tenth longer (`objects`, `city`).
constexpr std::uint32_t kMostOfRun = 128;

constexpr const char* kInstead = "use --executor trace";

static_assert(shared::kWrapRepeat == int(Wrap::Repeat) && shared::kWrapMirroredRepeat == int(Wrap::MirroredRepeat) &&
              shared::kWrapClampToEdge == int(Wrap::ClampToEdge));

GLint wrapEnumerant(Wrap wrap)
{
    switch (wrap) {
    case Wrap::Repeat: return GL_REPEAT;
    case Wrap::MirroredRepeat: return GL_MIRRORED_REPEAT;
    case Wrap::ClampToEdge: return GL_CLAMP_TO_EDGE;
    }
    LX_ASSERT(false);
    return GL_REPEAT;
}

struct DrawKey
{
    bool isMasked = false;
    int texture = -1;
    friend auto operator<=>(const DrawKey&, const DrawKey&) = default;
};

DrawKey keyOf(std::span<const Material> materials, std::uint32_t material)
{
    if (materials.empty()) return {};
    const Material& m = materials[material];
    return {m.alphaMode == AlphaMode::Mask, m.texture};
}

// Triangles in drawing order: opaque first, one texture after the other, otherwise as they came.
std::vector<std::uint32_t> drawingOrder(const LocalTriangles& triangles, std::span<const Material> materials)
{
    std::vector<std::uint32_t> order(triangles.triangleCount());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return keyOf(materials, triangles.material[a]) < keyOf(materials, triangles.material[b]);
    });
    return order;
}

Box boxOf(const LocalTriangles& triangles, std::uint32_t triangle)
{
    Box box;
    for (std::size_t c = 0; c < 3; ++c)
        box.include(toDouble(triangles.positionLocal[triangles.indices[3 * std::size_t(triangle) + c]]));
    return box;
}

// FNV-1a over whole texels.
std::uint64_t fingerprintOf(const Image<Rgba8>& pixels)
{
    std::uint64_t hash = 14695981039346656037u;
    for (const Rgba8& texel : pixels.data()) hash = (hash ^ std::bit_cast<std::uint32_t>(texel)) * 1099511628211u;
    return hash;
}

gl::Texture makeMipmapped(int width, int height)
{
    gl::Texture made(GL_SRGB8_ALPHA8, width, height, 0, std::bit_width(unsigned(std::max(width, height))));
    glTextureParameteri(made.name(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTextureParameteri(made.name(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return made;
}

void fillMipmapped(const gl::Texture& texture, const Image<Rgba8>& pixels)
{
    applyPixelTransfer();
    glTextureSubImage2D(texture.name(), 0, 0, 0, pixels.width(), pixels.height(), GL_RGBA, GL_UNSIGNED_BYTE,
                        pixels.data().data());
    glGenerateTextureMipmap(texture.name());
}

template <typename T>
void attribute(GLuint vertexArray, int slot, int components, const Buffer& buffer, bool isThere)
{
    const auto index = GLuint(slot);
    glEnableVertexArrayAttrib(vertexArray, index);
    glVertexArrayAttribFormat(vertexArray, index, components, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(vertexArray, index, index);
    // A stride of 0 gives every vertex the one value of `missing_`.
    glVertexArrayVertexBuffer(vertexArray, index, buffer.name(), 0, isThere ? GLsizei(sizeof(T)) : 0);
}

} // namespace

Surfaces::Surfaces(const Device& device) : device_(&device), vertexArray_(makeVertexArray())
{
    LX_ASSERT(device.limits().storageAlignment <= 4 * kTriangleStep);
    const std::array<Vec4f, 2> missing{Vec4f{1, 1, 1, 1}, Vec4f{}};
    missing_.assign(std::span<const Vec4f>(missing));
    const GLuint array = vertexArray_.get(), instance = shared::kAttributeInstance;
    glEnableVertexArrayAttrib(array, instance);
    glVertexArrayAttribIFormat(array, instance, 2, GL_UNSIGNED_INT, 0);
    glVertexArrayAttribBinding(array, instance, instance);
    glVertexArrayBindingDivisor(array, instance, 1);
    white_ = gl::Texture(GL_RGBA8, 1, 1);
    const std::uint32_t texel = 0xffffffffu;
    applyPixelTransfer();
    glTextureSubImage2D(white_.name(), 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &texel);
}

void Surfaces::update(const CasterBuffers& casters)
{
    if (casters.version != 0 && casters.version == version_) return;
    version_ = 0; // until all of it is here
    const LocalTriangles triangles = flatten(casters);
    originWorld_ = triangles.originWorld;
    uploadTriangles(casters, triangles);
    uploadAttributes(triangles);
    uploadMaterials(casters.materials);
    uploadTextures(casters.textures);
    version_ = casters.version;
}

void Surfaces::uploadTriangles(const CasterBuffers& casters, const LocalTriangles& triangles)
{
    const std::int64_t most = device_->limits().storageBlockBytes / std::int64_t(sizeof(std::uint32_t));
    if (std::int64_t(triangles.triangleCount()) > most)
        throw GraphicsError(fmt::format("the scene has {} triangles, the graphics device takes {} in one buffer; {}",
                                        triangles.triangleCount(), most, kInstead));
    const std::vector<std::uint32_t> order = drawingOrder(triangles, casters.materials);
    triangleCount_ = std::uint32_t(order.size());
    ranges_.clear();
    runs_.clear();

    std::vector<std::uint32_t> indices, material;
    indices.reserve(3 * order.size());
    material.reserve(order.size());
    for (std::uint32_t i = 0; i < triangleCount_; ++i) {
        const std::uint32_t source = order[i];
        for (std::uint32_t c = 0; c < 3; ++c) indices.push_back(triangles.indices[3 * source + c]);
        material.push_back(casters.materials.empty() ? 0 : triangles.material[source]);
        const DrawKey key = keyOf(casters.materials, triangles.material[source]);
        if (ranges_.empty() || key != DrawKey{ranges_.back().isMasked, ranges_.back().texture})
            ranges_.push_back({i, 0, key.texture, key.isMasked});
        ++ranges_.back().triangleCount;
        addToRuns(i, boxOf(triangles, source));
    }
    indices_.assign(std::span<const std::uint32_t>(indices));
    triangleSource_.assign(std::span<const std::uint32_t>(order));
    triangleMaterial_.assign(std::span<const std::uint32_t>(material));
    glVertexArrayElementBuffer(vertexArray_.get(), indices_.name());
}

void Surfaces::addToRuns(std::uint32_t triangle, const Box& boxLocal)
{
    const int maskedRange = ranges_.back().isMasked ? int(ranges_.size()) - 1 : -1;
    if (runs_.empty() || runs_.back().maskedRange != maskedRange || runs_.back().triangleCount == kMostOfRun)
        runs_.push_back({triangle, 0, maskedRange, {}});
    ++runs_.back().triangleCount;
    runs_.back().boxLocal.include(boxLocal);
}

void Surfaces::uploadAttributes(const LocalTriangles& triangles)
{
    positionBytes_ = triangles.positionLocal.size() * sizeof(Vec3f);
    if (std::int64_t(positionBytes_) > device_->limits().storageBlockBytes)
        throw GraphicsError(fmt::format("the scene has {} vertices, the graphics device takes {} in one buffer; {}",
                                        triangles.positionLocal.size(),
                                        device_->limits().storageBlockBytes / std::int64_t(sizeof(Vec3f)), kInstead));
    positions_.assign(std::span<const Vec3f>(triangles.positionLocal));
    uv_.assign(std::span<const Vec2f>(triangles.uv));
    colour_.assign(std::span<const Vec4f>(triangles.colour));
    normal_.assign(std::span<const Vec3f>(triangles.normal));

    const GLuint array = vertexArray_.get();
    const bool hasNormal = !triangles.normal.empty();
    hasUv_ = !triangles.uv.empty(), hasColour_ = !triangles.colour.empty();
    attribute<Vec3f>(array, shared::kAttributePosition, 3, positions_, true);
    attribute<Vec2f>(array, shared::kAttributeUv, 2, hasUv_ ? uv_ : missing_, hasUv_);
    attribute<Vec4f>(array, shared::kAttributeColour, 4, hasColour_ ? colour_ : missing_, hasColour_);
    attribute<Vec3f>(array, shared::kAttributeNormal, 3, hasNormal ? normal_ : missing_, hasNormal);
    if (!hasNormal) // the zero vector: the triangle's own normal is meant
        glVertexArrayVertexBuffer(array, shared::kAttributeNormal, missing_.name(), sizeof(Vec4f), 0);
}

void Surfaces::uploadMaterials(std::span<const Material> materials)
{
    const Material standard;
    if (materials.empty()) materials = {&standard, 1};
    std::vector<shared::SurfaceMaterial> table;
    for (const Material& m : materials) {
        shared::SurfaceMaterial row;
        row.baseColour = {m.baseColour.x, m.baseColour.y, m.baseColour.z, m.baseColour.w};
        row.emission = {m.emission.x, m.emission.y, m.emission.z};
        row.alphaCutoff = m.alphaMode == AlphaMode::Mask ? m.alphaCutoff : 0;
        table.push_back(row);
    }
    materialBytes_ = table.size() * sizeof(shared::SurfaceMaterial);
    materials_.assign(std::span<const shared::SurfaceMaterial>(table));
}

void Surfaces::uploadTextures(std::span<const lixel::Texture> textures)
{
    textures_.resize(textures.size());
    for (std::size_t i = 0; i < textures.size(); ++i) {
        const Image<Rgba8>& pixels = textures[i].pixels;
        const int most = device_->limits().textureSize;
        if (pixels.width() > most || pixels.height() > most)
            throw GraphicsError(fmt::format("texture {} has {} x {} texels, the graphics device takes {} a side; {}", i,
                                            pixels.width(), pixels.height(), most, kInstead));
        SurfaceTexture& kept = textures_[i];
        const std::uint64_t fingerprint = fingerprintOf(pixels);
        if (kept.texture.width() != pixels.width() || kept.texture.height() != pixels.height()) {
            kept.texture = pixels.data().empty() ? gl::Texture() : makeMipmapped(pixels.width(), pixels.height());
            kept.fingerprint = ~fingerprint;
        }
        if (pixels.data().empty()) continue;
        if (kept.fingerprint != fingerprint) fillMipmapped(kept.texture, pixels);
        kept.fingerprint = fingerprint;
        kept.wraps = {int(textures[i].wrapU), int(textures[i].wrapV)};
        glTextureParameteri(kept.texture.name(), GL_TEXTURE_WRAP_S, wrapEnumerant(textures[i].wrapU));
        glTextureParameteri(kept.texture.name(), GL_TEXTURE_WRAP_T, wrapEnumerant(textures[i].wrapV));
    }
}

void Surfaces::bindVertices() const { glBindVertexArray(vertexArray_.get()); }

void Surfaces::bindVertices(const Buffer& instances) const
{
    bindVertices();
    glVertexArrayVertexBuffer(vertexArray_.get(), shared::kAttributeInstance, instances.name(), 0,
                              GLsizei(sizeof(CasterInstance)));
}

void Surfaces::draw(std::uint32_t firstTriangle, std::uint32_t count) const
{
    // In calls whose counts fit OpenGL's signed integers.
    constexpr std::uint32_t kMost = 1u << 29;
    for (std::uint32_t at = 0; at < count; at += std::min(kMost, count - at))
        glDrawElements(GL_TRIANGLES, GLsizei(3 * std::min(kMost, count - at)), GL_UNSIGNED_INT,
                       reinterpret_cast<const void*>(12 * (std::uintptr_t(firstTriangle) + at)));
}

void Surfaces::bindMaterials() const
{
    materials_.bindStorage(shared::kStorageMaterials, 0, materialBytes_);
    triangleMaterial_.bindStorage(shared::kStorageTriangleMaterial);
}

void Surfaces::bindTriangles(std::uint32_t first, std::uint32_t count) const
{
    LX_ASSERT(first % kTriangleStep == 0 && count <= trianglesPerBinding());
    // OpenGL binds no empty range; a scene without triangles shows one word that nobody reads.
    const auto bytes = [](std::size_t size) { return std::max<std::size_t>(size, 4); };
    indices_.bindStorage(shared::kStorageIndices, 12 * std::size_t(first), bytes(12 * std::size_t(count)));
    triangleSource_.bindStorage(shared::kStorageTriangleSource, 4 * std::size_t(first), bytes(4 * std::size_t(count)));
    positions_.bindStorage(shared::kStoragePositions, 0, bytes(positionBytes_));
}

Surfaces::Strides Surfaces::bindVertexData() const
{
    (hasUv_ ? uv_ : missing_).bindStorage(shared::kStorageUv);
    (hasColour_ ? colour_ : missing_).bindStorage(shared::kStorageColours);
    return {hasUv_ ? 2 : 0, hasColour_ ? 4 : 0};
}

std::uint32_t Surfaces::trianglesPerBinding() const
{
    const std::int64_t most = std::min<std::int64_t>(device_->limits().storageBlockBytes / 12, 1 << 30);
    return std::uint32_t(most) / kTriangleStep * kTriangleStep;
}

Surfaces::Wraps Surfaces::bindTexture(const DrawRange& range) const
{
    const bool isThere = range.texture >= 0 && textures_[std::size_t(range.texture)].texture.name() != 0;
    const gl::Texture& texture = isThere ? textures_[std::size_t(range.texture)].texture : white_;
    texture.bind(shared::kUnitSurface);
    return isThere ? textures_[std::size_t(range.texture)].wraps : Wraps{};
}

} // namespace lixel::gl
