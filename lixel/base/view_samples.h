// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/vec.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lixel {

inline constexpr std::uint32_t kNoTriangle = 0xffffffffu;

// The surface points a picture is made of: any number a pixel (none, one, many), any subset of the pixels, in any order.
// Technique and truth are asked about the same list. All arrays have size() entries, but `weight` and `atDepthJump` may be
// empty: then every weight is 1 and no sample is marked.
struct ViewSamples
{
    int width = 0, height = 0; // of the picture, pixels
    Vec3d originWorld;         // positionLocal = positionWorld - originWorld
    std::vector<Vec2f> pixel;  // continuous, (i + 1/2, j + 1/2) at a pixel's centre, row 0 at the bottom
    std::vector<Vec3f> positionLocal;
    std::vector<Vec3f> normal;           // geometric, unit, turned to the eye
    std::vector<std::uint32_t> triangle; // of the casters' LocalTriangles, or kNoTriangle
    std::vector<float> weight;
    std::vector<std::uint8_t> atDepthJump; // 1 where the normal was taken across a depth discontinuity

    std::size_t size() const { return positionLocal.size(); }
    float weightOf(std::size_t i) const { return weight.empty() ? 1.0f : weight[i]; }
};

} // namespace lixel
