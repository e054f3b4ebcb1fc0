// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace lixel {

// What an executor says of one light, a value for every view sample: 1 lit, 0 in shadow, between where taps or depths disagree.
// Samples that face away from the light have a value too, which nobody asks for.
struct Visibility
{
    std::vector<float> value;
    std::vector<std::uint8_t> unserved; // 1 where no region holds the sample; its value is then 1
};

} // namespace lixel
