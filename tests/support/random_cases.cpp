// SPDX-License-Identifier: MIT
#include "support/random_cases.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace lixel::test {

bool isThorough()
{
    const char* value = std::getenv("LIXEL_THOROUGH");
    return value && std::string(value) == "1";
}

int scaled(int cases) { return isThorough() ? 50 * cases : cases; }

void forEachCase(int cases, const std::function<void(Rng&)>& property)
{
    if (const char* given = std::getenv("LIXEL_SEED")) {
        Rng rng(std::strtoull(given, nullptr, 10));
        SCOPED_TRACE("LIXEL_SEED=" + std::string(given));
        property(rng);
        return;
    }
    const std::uint64_t firstSeed = 20040621;
    const int count = scaled(cases);
    std::printf("seeds %llu to %llu\n", static_cast<unsigned long long>(firstSeed),
                static_cast<unsigned long long>(firstSeed + std::uint64_t(count) - 1));
    for (int i = 0; i < count; ++i) {
        const std::uint64_t seed = firstSeed + std::uint64_t(i);
        SCOPED_TRACE("repeat alone with LIXEL_SEED=" + std::to_string(seed));
        Rng rng(seed);
        property(rng);
        if (::testing::Test::HasFailure()) return;
    }
}

} // namespace lixel::test
