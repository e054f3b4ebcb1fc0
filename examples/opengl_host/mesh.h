// SPDX-License-Identifier: MIT
#pragma once

#include <lixel/base/box.h>

#include <cstdint>
#include <string>
#include <vector>

// As this renderer keeps vertices: 12 bytes, interleaved. Positions are fractions of the mesh's box.
struct HostVertex
{
    std::uint16_t position[3]; // 0..65535 across the box
    std::uint16_t colour;      // 5 bits red, 6 green, 5 blue
    std::int16_t normal[2];    // of the face: octahedral
};

struct HostMesh
{
    std::string name;
    lixel::Box boxWorld;
    std::vector<HostVertex> vertices; // three a triangle
};

// Reads `o`, `v x y z r g b` and `f a b c ...` with positive indices; an object becomes a mesh. Throws std::runtime_error.
std::vector<HostMesh> loadObj(const std::string& path);
