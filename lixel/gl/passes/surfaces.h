// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/caster_source.h"
#include "lixel/gl/device/device.h"
#include "lixel/gl/device/objects.h"
#include "lixel/gl/passes/caster_draws.h"

#include <cstdint>
#include <vector>

namespace lixel::gl {

// Consecutive triangles that are drawn alike.
struct DrawRange
{
    std::uint32_t firstTriangle = 0, triangleCount = 0; // in drawing order
    int texture = -1;                                   // into Surfaces::textures, -1: none
    bool isMasked = false;
};

// The casters on the device: LocalTriangles reordered for drawing (opaque ones first, then by texture, else as they came),
// their materials and textures. Colour is filtered with mips; alpha must be read by texelFetch as lixel/shared/alpha.h says.
class Surfaces
{
public:
    explicit Surfaces(const Device& device);

    // Uploads unless the version is the one that is here; version 0 says nothing and is always uploaded. Throws
    // GraphicsError, by name, at arrays or textures larger than the device takes.
    void update(const CasterBuffers& casters);

    // The vertex array with attributes kAttribute... and the indices; textures and wrap modes are for the drawing pass.
    void bindVertices() const;
    // The same, with an entry of `instances` (CasterInstance) for each instance drawn, kAttributeInstance.
    void bindVertices(const Buffer& instances) const;
    // Draws triangles in drawing order; the program and the rest of the state are the caller's.
    void draw(std::uint32_t firstTriangle, std::uint32_t count) const;
    // Materials, and which of them each triangle in drawing order has.
    void bindMaterials() const;
    // Indices and positions, for shaders that look triangles up: triangles [first, first + count), in drawing order.
    void bindTriangles(std::uint32_t first, std::uint32_t count) const;
    // Their uv and colours, for such shaders; tells how many floats a vertex has of each, 0 where one value stands for all.
    struct Strides
    {
        int uv = 0, colour = 0;
    };
    Strides bindVertexData() const;
    // How many triangles one bindTriangles() takes at most.
    std::uint32_t trianglesPerBinding() const;

    const std::vector<DrawRange>& ranges() const { return ranges_; }
    const std::vector<CasterRun>& runs() const { return runs_; } // all triangles, in drawing order
    std::uint32_t triangleCount() const { return triangleCount_; }
    Vec3d originWorld() const { return originWorld_; }
    std::uint64_t version() const { return version_; }

    // Binds the texture of a range to kUnitSurface and tells its wrap modes (0 without a texture: one white texel).
    struct Wraps
    {
        int u = 0, v = 0;
    };
    Wraps bindTexture(const DrawRange& range) const;

private:
    void uploadTriangles(const CasterBuffers& casters, const LocalTriangles& triangles);
    void addToRuns(std::uint32_t triangle, const Box& boxLocal);
    void uploadAttributes(const LocalTriangles& triangles);
    void uploadMaterials(std::span<const Material> materials);
    void uploadTextures(std::span<const lixel::Texture> textures);

    const Device* device_;
    std::uint64_t version_ = 0;
    Vec3d originWorld_;
    std::uint32_t triangleCount_ = 0;
    std::vector<DrawRange> ranges_;
    std::vector<CasterRun> runs_;

    VertexArray vertexArray_;
    Buffer positions_, uv_, colour_, normal_, missing_;
    Buffer indices_, triangleSource_, triangleMaterial_, materials_;
    std::size_t positionBytes_ = 0, materialBytes_ = 0;
    bool hasUv_ = false, hasColour_ = false;
    struct SurfaceTexture
    {
        gl::Texture texture;
        Wraps wraps;
        std::uint64_t fingerprint = 0; // of its texels: an animated scene has new triangles but the same textures
    };
    std::vector<SurfaceTexture> textures_;
    gl::Texture white_;
};

} // namespace lixel::gl
