// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/assert.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace lixel {

// Of an even number of values the mean of the two in the middle. At least one.
inline double median(std::vector<double> values)
{
    LX_ASSERT(!values.empty());
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return values.size() % 2 ? *middle : 0.5 * (*std::max_element(values.begin(), middle) + *middle);
}

} // namespace lixel
