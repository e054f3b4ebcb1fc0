// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/box.h"
#include "lixel/base/caster_source.h"
#include "lixel/trace/embree_scene.h"
#include "lixel/trace/ray_triangle.h"

#include <array>
#include <span>
#include <vector>

namespace lixel {

// Triangles made ready for rays. All surfaces have two sides; masked ones are kept where their alpha says so.
class TraceScene
{
public:
    // Materials and textures stay with their owner, who keeps them alive while the scene is used.
    TraceScene(LocalTriangles triangles, std::span<const Material> materials, std::span<const Texture> textures);
    explicit TraceScene(const CasterBuffers& casters);

    const LocalTriangles& triangles() const { return triangles_; }
    Vec3d originWorld() const { return triangles_.originWorld; }
    const Box& boxLocal() const { return boxLocal_; }             // of all triangles' corners
    const Box& searchBoxLocal() const { return searchBoxLocal_; } // widened: outside of it rays meet nothing
    const EmbreeScene& embree() const { return embree_; }

    const Material& materialOf(std::uint32_t triangle) const;
    const Texture* textureOf(const Material& material) const; // nullptr: none
    bool isMasked(std::uint32_t triangle) const;
    Corners corners(std::uint32_t triangle) const;
    std::array<std::uint32_t, 3> cornerIndices(std::uint32_t triangle) const;

    // Whether the surface is there at the point with weights u, v of the second and third corner.
    bool keeps(std::uint32_t triangle, float u, float v) const;

private:
    LocalTriangles triangles_;
    std::vector<Material> materials_;
    std::span<const Texture> textures_;
    Box boxLocal_, searchBoxLocal_;
    EmbreeScene embree_;
    bool anyMasked_ = false;
};

} // namespace lixel
