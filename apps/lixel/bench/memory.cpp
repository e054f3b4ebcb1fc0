// SPDX-License-Identifier: MIT
#include "bench/memory.h"

#include <algorithm>
#include <fstream>
#include <string>
#include <string_view>

#include <malloc.h>

namespace lixel::app {
namespace {

// "VmHWM:   123 kB" in a file of such lines.
std::optional<std::uint64_t> lineOf(const char* path, std::string_view name)
{
    std::ifstream file(path);
    for (std::string word; file >> word; file.ignore(4096, '\n'))
        if (std::uint64_t kilobytes = 0; word == name && file >> kilobytes) return kilobytes << 10;
    return std::nullopt;
}

std::optional<std::uint64_t> numberIn(const char* path)
{
    std::ifstream file(path);
    std::uint64_t value = 0;
    return file >> value ? std::optional(value) : std::nullopt; // "max" is no number
}

} // namespace

PeakMemory::PeakMemory()
{
    malloc_trim(0); // what others have freed does not count
    std::ofstream file("/proc/self/clear_refs");
    isOfThis_ = bool(file << "5" << std::flush); // proc(5): resets the peak
}

std::optional<std::uint64_t> PeakMemory::bytes() const
{
    return isOfThis_ ? lineOf("/proc/self/status", "VmHWM:") : std::nullopt;
}

std::optional<std::uint64_t> residentMemory() { return lineOf("/proc/self/status", "VmRSS:"); }

std::optional<std::uint64_t> memoryLeft()
{
    auto left = lineOf("/proc/meminfo", "MemAvailable:");
    const auto most = numberIn("/sys/fs/cgroup/memory.max"), used = numberIn("/sys/fs/cgroup/memory.current");
    if (most && used && left) left = std::min(*left, *most - std::min(*most, *used));
    return left;
}

} // namespace lixel::app
