// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/expected.h"
#include "lixel/plan/fit/fit.h"

// A partition is an ordered list of convex cells of space; the first that holds a receiver serves it.
namespace lixel {

struct Cell
{
    // What is asked of a receiver by the tables, after all earlier cells have said no: the last cell of a list asks nothing, so
    // that rounding loses no one between two cells.
    CellPlanes servesLocal;
    // What its fit must hold: all that it serves, and where cells part receivers rather than light rays a little more, for the
    // rounding of those tests.
    CellPlanes holdsLocal;
    std::optional<PlaneOfCell> plane = {}; // of cells made for a plane
    int planeNumber = -1;                  // which of PlanInput::planes, or of those found, in their order
    std::optional<Vec3d> paraboloidAxis =
        {}; // of cells whose map is a paraboloid's (fit/paraboloid.h): unit, away from the light
};

inline constexpr std::size_t kMostCells = 16;
using Cells = FixedVector<Cell, kMostCells>;
using CellsResult = Expected<Cells, FitFailure>;

// One cell: all of space.
Cells wholeSpace();

} // namespace lixel
