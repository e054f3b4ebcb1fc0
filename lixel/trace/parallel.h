// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace lixel {

// Calls body(first, last) for consecutive blocks of [0, count) on all processors, in no particular order, and waits for
// all. Bodies write to places of their own only, so that results do not depend on the threads. The first exception is
// rethrown.
void forEachBlock(std::size_t count, std::size_t blockSize, const std::function<void(std::size_t, std::size_t)>& body);

} // namespace lixel
