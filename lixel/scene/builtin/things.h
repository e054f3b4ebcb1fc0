// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/builtin/shapes.h"

// Household things for the built-in scenes, in metres, standing on the origin. `segments` is how many sides round parts
// have; triangles grow with its square.
namespace lixel::builtin {

Mesh teapot(int segments);      // 0.16 high
Mesh mug(int segments);         // 0.10
Mesh bowl(int segments);        // 0.09, 0.24 wide
Mesh plate(int segments);       // 0.02, 0.26 wide
Mesh vase(int segments);        // 0.30
Mesh candlestick(int segments); // 0.32 with its candle
Mesh goblet(int segments);      // 0.20
Mesh apple(int segments);       // 0.08
Mesh pear(int segments);        // 0.11
Mesh basket(int ribs);          // 0.12: an open lattice of rods
Mesh spring(int turns, double radius, double height, double wire, int segmentsPerTurn, int sides);
Mesh gear(int teeth, double radius, double thickness);      // lies flat
Mesh bookStack(int books, std::uint64_t seed);              // 0.035 a book
Mesh chair();                                               // 0.9
Mesh tableFrame(double width, double depth, double height); // top and legs; the top's upper side is at `height`

} // namespace lixel::builtin
