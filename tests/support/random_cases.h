// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/vec.h"

#include <cstdint>
#include <functional>
#include <random>

// Random properties: many cases from printed seeds. LIXEL_SEED=n repeats one seed, LIXEL_THOROUGH=1 runs fifty times as many.
namespace lixel::test {

class Rng
{
public:
    explicit Rng(std::uint64_t seed) : engine_(seed) {}

    double uniform(double low, double high) { return low + (high - low) * unit(); }
    double logUniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
    int integer(int low, int high)
    {
        return low + int(std::uint64_t(engine_()) % std::uint64_t(high - low + 1));
    } // both included
    bool chance(double probability) { return unit() < probability; }
    Vec3d inBox(double half) { return {uniform(-half, half), uniform(-half, half), uniform(-half, half)}; }
    Vec3d onSphere()
    {
        const double z = uniform(-1, 1), a = uniform(0, 6.283185307179586), r = std::sqrt(1 - z * z);
        return {r * std::cos(a), r * std::sin(a), z};
    }
    std::uint64_t bits() { return engine_(); }

private:
    double unit() { return double(engine_() >> 11) * 0x1p-53; } // the same numbers on every standard library
    std::mt19937_64 engine_;
};

inline constexpr int kCases = 2000;

bool isThorough();

// How many times a count of cases is run: itself, or fifty times it when thorough; half of that under sanitizers.
int scaled(int cases);

// Runs `property` on scaled(cases) generators, each with its own seed; a failure prints the seed that repeats it alone.
void forEachCase(int cases, const std::function<void(Rng&)>& property);

} // namespace lixel::test
