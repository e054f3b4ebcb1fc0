// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

// Memory of this process and of the machine, as Linux tells it; nothing where it does not.
namespace lixel::app {

// The largest part of the process that was in memory at once, since it was last asked to begin anew.
class PeakMemory
{
public:
    PeakMemory(); // begins anew
    std::optional<std::uint64_t> bytes() const;

private:
    bool isOfThis_ = false; // else the process's whole life would be told
};

// What the process may still take, within the machine's memory and that of its control group.
std::optional<std::uint64_t> memoryLeft();

std::optional<std::uint64_t> residentMemory();

} // namespace lixel::app
