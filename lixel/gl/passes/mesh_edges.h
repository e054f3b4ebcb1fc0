// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lixel::gl {

// One edge of some triangles: its ends, as indices of positions, and where its uses stand.
struct MeshEdge
{
    std::uint32_t from = 0, to = 0;
    std::uint32_t firstUse = 0, useCount = 0;
};

// All edges of triangles, however many triangles meet in each: closed, open and non-manifold surfaces alike. A use is
// 2 * triangle, and 1 more where the corners of the triangle go round from `to` to `from`.
struct MeshEdges
{
    std::vector<MeshEdge> edges;
    std::vector<std::uint32_t> uses;
};

// Corners at equal places are one corner, whatever their indices: seams of texture coordinates are no edges of the surface. Sides
// between such corners are left out.
MeshEdges edgesOf(std::span<const Vec3f> positions, std::span<const std::uint32_t> indices);

} // namespace lixel::gl
