// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/surfaces.h"

#include <cstdint>

// Small textures made by rule; all repeat without a seam. Colours are sRGB, 0xRRGGBB.
namespace lixel::builtin {

Texture checker(std::uint32_t first, std::uint32_t second, int squares);    // squares a side, even
Texture tiles(std::uint32_t tile, std::uint32_t joint, int tilesPerSide);   // each tile a little different
Texture planks(std::uint32_t wood, std::uint32_t joint, int planksPerSide); // run along u
Texture bricks(std::uint32_t brick, std::uint32_t mortar, int courses);
Texture stripes(std::uint32_t first, std::uint32_t second, int pairs); // change along u
Texture facade(std::uint32_t wall, std::uint32_t window, int windowsPerSide);
Texture plaster(std::uint32_t colour, double unevenness); // a faint blotchy surface

// Alpha textures: what is kept has alpha 255, the rest 0.
Texture chainLink(std::uint32_t wire, int meshesPerSide, double wireWidth); // diamonds; width as a share of one mesh
Texture leaf(std::uint32_t blade, std::uint32_t vein);                      // one leaf, stem at v = 0

} // namespace lixel::builtin
