// SPDX-License-Identifier: MIT
#include "lixel/gl/passes/mesh_edges.h"

#include "lixel/base/assert.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>

namespace lixel::gl {
namespace {

constexpr std::uint32_t kFree = std::numeric_limits<std::uint32_t>::max();

std::uint64_t hashOf(Vec3f p)
{
    std::uint64_t hash = 0;
    for (const float c : {p.x, p.y, p.z}) {
        hash ^= std::bit_cast<std::uint32_t>(c + 0.0f); // -0 is 0
        hash *= 0x9e3779b97f4a7c15u;
        hash ^= hash >> 29;
    }
    return hash;
}

// For each position the first one at the same place: a hash table that is at most half full.
std::vector<std::uint32_t> firstAtPlace(std::span<const Vec3f> positions)
{
    LX_ASSERT(positions.size() < kFree);
    const std::size_t slots = std::bit_ceil(2 * positions.size() + 1);
    std::vector<std::uint32_t> table(slots, kFree), first(positions.size());
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        std::size_t slot = hashOf(positions[i]) & (slots - 1);
        while (table[slot] != kFree && !(positions[table[slot]] == positions[i])) slot = (slot + 1) & (slots - 1);
        if (table[slot] == kFree) table[slot] = i;
        first[i] = table[slot];
    }
    return first;
}

struct Side
{
    std::uint64_t ends = 0; // the smaller index above the larger
    std::uint32_t use = 0;
};

} // namespace

MeshEdges edgesOf(std::span<const Vec3f> positions, std::span<const std::uint32_t> indices)
{
    const std::vector<std::uint32_t> corner = firstAtPlace(positions);
    std::vector<Side> sides;
    sides.reserve(indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
        const std::uint32_t a = corner[indices[i]], b = corner[indices[next]];
        if (a == b) continue;
        const bool isTurned = a > b;
        sides.push_back(
            {std::uint64_t(std::min(a, b)) << 32 | std::max(a, b), std::uint32_t(2 * (i / 3) + (isTurned ? 1 : 0))});
    }
    std::sort(sides.begin(), sides.end(),
              [](const Side& a, const Side& b) { return a.ends != b.ends ? a.ends < b.ends : a.use < b.use; });

    MeshEdges mesh;
    mesh.uses.reserve(sides.size());
    for (std::size_t i = 0; i < sides.size(); ++i) {
        if (i == 0 || sides[i].ends != sides[i - 1].ends)
            mesh.edges.push_back(
                {std::uint32_t(sides[i].ends >> 32), std::uint32_t(sides[i].ends), std::uint32_t(i), 0});
        ++mesh.edges.back().useCount;
        mesh.uses.push_back(sides[i].use);
    }
    return mesh;
}

} // namespace lixel::gl
