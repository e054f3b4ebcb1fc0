// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/observation.h"
#include "lixel/base/vec.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lixel {

// Which way shadow boundaries run in an observed picture. Used again and again it allocates nothing after the first frames.
class BoundaryDirections
{
public:
    // Of one light, whose bit this is.
    void observe(const Observation& observation, std::uint32_t bit);

    // The unit normal of the boundary at a sample, in the picture, from dark to lit: how lit and dark lie among the cells around it.
    // Zero where that says nothing, as in a speck.
    Vec2d acrossAt(std::size_t sample) const;

private:
    const Observation* observation_ = nullptr;
    std::uint32_t bit_ = 0;
    std::vector<std::int32_t> sampleOf_; // of every cell; -1 where it sees nothing
};

} // namespace lixel
