// SPDX-License-Identifier: MIT
#include "support/random_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace lixel::test {

bool isThorough()
{
    const char* value = std::getenv("LIXEL_THOROUGH");
    return value && std::string(value) == "1";
}

// Sanitizers look at what runs, which is several times slower, and not at how often.
#ifdef __SANITIZE_ADDRESS__
constexpr int kSlower = 2;
#else
constexpr int kSlower = 1;
#endif

int scaled(int cases) { return std::max(1, (isThorough() ? 50 * cases : cases) / kSlower); }

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
