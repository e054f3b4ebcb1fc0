// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/vec.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

namespace lixel {

// An axis-aligned box; empty by default.
struct Box
{
    Vec3d min{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
              std::numeric_limits<double>::infinity()};
    Vec3d max{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
              -std::numeric_limits<double>::infinity()};

    bool isEmpty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
    Vec3d centre() const { return 0.5 * (min + max); }
    double diagonal() const { return isEmpty() ? 0 : length(max - min); }
    void include(Vec3d p)
    {
        min = {std::min(min.x, p.x), std::min(min.y, p.y), std::min(min.z, p.z)};
        max = {std::max(max.x, p.x), std::max(max.y, p.y), std::max(max.z, p.z)};
    }
    void include(const Box& other)
    {
        if (other.isEmpty()) return;
        include(other.min);
        include(other.max);
    }
    std::array<Vec3d, 8> corners() const
    {
        std::array<Vec3d, 8> c;
        for (int i = 0; i < 8; ++i)
            c[std::size_t(i)] = {i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z};
        return c;
    }
};

inline Box translated(const Box& box, Vec3d by) { return box.isEmpty() ? box : Box{box.min + by, box.max + by}; }

// Where casters (and receivers) are: one box a mesh or instance, in world space. Conservative.
struct CasterBounds
{
    std::vector<Box> boxesWorld;

    Box total() const
    {
        Box all;
        for (const Box& box : boxesWorld) all.include(box);
        return all;
    }
};

} // namespace lixel
