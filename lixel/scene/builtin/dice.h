// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace lixel::builtin {

// The same numbers on every machine, from a seed (splitmix64: Steele, Lea, Flood, OOPSLA 2014).
class Dice
{
public:
    explicit Dice(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u) {}

    double uniform(double low, double high) { return low + (high - low) * double(next() >> 11) * 0x1p-53; }
    int integer(int low, int high) { return low + int(next() % std::uint64_t(high - low + 1)); } // both included
    bool chance(double probability) { return uniform(0, 1) < probability; }

private:
    std::uint64_t next()
    {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }

    std::uint64_t state_;
};

} // namespace lixel::builtin
