// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/mat4.h"
#include "lixel/base/plane.h"
#include "lixel/base/surfaces.h"

#include <cstdint>
#include <functional>
#include <span>
#include <variant>
#include <vector>

// How casters reach the executors: as buffers, which serve everything, or as a callback that draws with the host's own
// shaders and vertex formats, which serves what only needs drawing.
namespace lixel {

// One mesh in memory of its owner, who keeps it alive while the source is used. Any array but `positions` may be empty.

struct CasterMesh
{
    std::span<const Vec3f> positions;        // model space; Local where there are no transforms
    std::span<const std::uint32_t> indices;  // triples; empty: positions are triples themselves
    std::span<const Mat4d> localFromModel;   // one entry an instance; empty: one instance, already Local
    std::span<const Vec2f> uv;               // one a position
    std::span<const Vec4f> colour;           // one a position, linear
    std::span<const Vec3f> normals;          // one a position, unit, for shading only
    std::span<const std::uint32_t> material; // one a triangle; empty: all 0
};

// Everything that casts, receives and is seen. Equal versions mean equal content.
struct CasterBuffers
{
    Vec3d originWorld; // Local = World - originWorld
    std::vector<CasterMesh> meshes;
    std::span<const Material> materials; // empty: one opaque default
    std::span<const Texture> textures;
    std::uint64_t version = 0;
};

// One view that casters are drawn into: a conservative volume to cull by, and its place in the tables of the plan.
struct CasterView
{
    std::uint32_t index = 0;        // into the plan's regions; the host hands it on as `lixelFirstView`
    std::vector<Plane> volumeLocal; // half-spaces, inside where signedDistance >= 0; casters outside do not matter
};

// The host draws every caster once for each of `views`. Its vertex shader includes lixel_caster.glsl and ends in
// lixelCaster(positionLocal, uv); lixel's state (framebuffer, viewports, depth) is bound and is not to be changed.
struct CasterCallback
{
    Vec3d originWorld;
    std::function<void(std::span<const CasterView> views)> draw;
    std::uint64_t version = 0;
};

using CasterSource = std::variant<CasterBuffers, CasterCallback>;

// Casters flattened: instances applied, all indices into one array. Both executors draw exactly these floats.
struct LocalTriangles
{
    Vec3d originWorld;
    std::vector<Vec3f> positionLocal;
    std::vector<std::uint32_t> indices;  // triples
    std::vector<Vec2f> uv;               // empty or one a position
    std::vector<Vec4f> colour;           // empty or one a position
    std::vector<Vec3f> normal;           // empty or one a position
    std::vector<std::uint32_t> material; // one a triangle

    std::size_t triangleCount() const { return indices.size() / 3; }
};

LocalTriangles flatten(const CasterBuffers& casters);

} // namespace lixel
