// SPDX-License-Identifier: MIT
#include "lixel/plan/partition/partition.h"

namespace lixel {

Cells wholeSpace()
{
    Cells cells;
    cells.push_back({});
    return cells;
}

} // namespace lixel
