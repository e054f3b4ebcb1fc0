// SPDX-License-Identifier: MIT
// Any bytes through the loaders and then through evaluation: a scene or an InputError, whose floats are finite.
#include "load_bytes.h"

#include "lixel/base/assert.h"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    try {
        LX_ASSERT(lixel::test::wrongWhenLoaded({reinterpret_cast<const char*>(data), size}).empty());
    } catch (const lixel::InputError&) {
    }
    return 0;
}
