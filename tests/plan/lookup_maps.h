// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/shared/lookup/blur.h"
#include "lixel/shared/lookup/select_depths.h"
#include "lixel/shared/lookup/visibility.h"

#include <cmath>

// Maps for lookups without an executor.
namespace lixel::test {

// A map whose depth is a function of (x, y, layer); all that lookups prepare is worked out where it is asked for.
template <typename Depth>
struct FunctionMap
{
    shared::LxLookup how;
    shared::vec4 rectangle;
    float bend;
    const Depth& depth;
    static constexpr shared::LxNoKnots knots{};

    shared::LxWords words(int x, int y, int layer) const
    {
        return shared::lxPackedDepths(how, rectangle, bend, x, y, layer, *this);
    }
    shared::uint gradient(int x, int y, int layer) const
    {
        return shared::lxPackedGradient(shared::lxGradient(rectangle, x, y, layer, *this));
    }
    shared::vec4 moments(int x, int y, int layer) const
    {
        struct Across
        {
            const FunctionMap& map;
            shared::vec4 moments(int i, int j, int l) const
            {
                return shared::lxMomentsAcross(map.how, map.rectangle, map.bend, i, j, l, map);
            }
        };
        return shared::lxMomentsAlong(how, rectangle, x, y, layer, Across{*this});
    }
    float hardwareLit(shared::vec2 lixel, int layer, float reference) const
    {
        const float x = std::floor(lixel.x - 0.5f), y = std::floor(lixel.y - 0.5f);
        float lit = 0;
        for (int i = 0; i < 4; ++i) {
            const int column = int(x) + i % 2, row = int(y) + i / 2;
            const float area =
                (1 - std::abs(lixel.x - 0.5f - float(column))) * (1 - std::abs(lixel.y - 0.5f - float(row)));
            if (area > 0 && depth(column, row, layer) <= reference) lit += area;
        }
        return lit;
    }
};

template <typename Depth>
float litBy(const shared::LxLookup& how, const shared::ShadowRegion& region, const shared::LxReceiver& receiver,
            const Depth& depth, shared::uint seed = 0)
{
    return shared::lxVisibility(how, region, receiver, seed,
                                FunctionMap<Depth>{how, region.rectangle, region.projection.z, depth});
}

// What `side` by `side` taps of one depth say.
template <typename Depth>
float litByPcf(const shared::ShadowRegion& region, const shared::LxReceiver& receiver, int side, const Depth& depth)
{
    return litBy(shared::lxOneDepth(side), region, receiver, depth);
}

// A map of 16 x 16 lixels whose first is (8, 8), straight under its light, so that lixel and depth of a point are its own x, y and z.
inline shared::ShadowRegion plainRegion()
{
    shared::ShadowRegion region;
    for (int i = 0; i < 4; ++i)
        region.lightClipFromLocal[i] = {i == 0 ? 1.0f : 0, i == 1 ? 1.0f : 0, i == 2 ? 1.0f : 0, i == 3 ? 1.0f : 0};
    region.lixelFromNdc = {8, 8, 16, 16};
    region.rectangle = region.serves = {8, 8, 24, 24};
    return region;
}

} // namespace lixel::test
