// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/judge/growth.h"
#include "lixel/report/results.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// How cost grows: what `lixel bench` measures.
namespace lixel {

// One technique where one thing is varied.
struct BenchRow
{
    struct Measured
    {
        RowTiming timing;
        double planMs = 0;                              // of deciding, on the CPU, first passes included
        std::optional<std::uint64_t> peakResidentBytes; // of the process meanwhile, the scene included
        std::optional<std::uint64_t> deviceBytes;       // of the executor's buffers and textures
        std::int64_t lixelsUsed = 0;                    // by all lights
    };
    std::string axis, technique;
    double size = 0; // of what the axis varies
    std::uint64_t triangles = 0, pixels = 0, lixels = 0, lights = 0;
    std::optional<Measured> measured;
    std::string skipped; // why, where it was not
};

struct BenchAxis
{
    std::string name, unit, others; // "triangles"; what all else is meanwhile
};

// What a technique's cost does along an axis.
struct BenchGrowth
{
    std::string axis, technique, quantity; // a name of kBenchQuantities
    Growth growth;
};
inline constexpr const char* kBenchQuantities[] = {"frame_ms", "plan_ms", "peak_resident_bytes", "device_bytes"};

struct BenchResults
{
    std::string lixelVersion, command, executor;
    bool isQuick = false;
    int frames = 0; // whose median each time is
    std::vector<BenchAxis> axes;
    std::vector<BenchRow> rows; // by axis, technique and size
    RunTiming timing;
};

std::vector<BenchGrowth> growthsOf(const BenchResults& bench);

// docs/bench.schema.json describes it.
std::string toJson(const BenchResults& bench);

} // namespace lixel
