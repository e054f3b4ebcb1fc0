// SPDX-License-Identifier: MIT
// Made-up results of studies and benches: what grows in them is known.
#include "sample_results.h"

#include <cmath>

namespace lixel::test {
namespace {

constexpr const char* kTechniques[] = {"focused", "psm", "focused+pcf(9)"};

ResultRow sweepRow(int scene, int view, int lights, int technique, int lixels, int size)
{
    ResultRow row;
    row.scene = scene == 0 ? "bunnies(count=1)" : "bunnies(count=8)";
    row.view = view == 0 ? "close-up" : "low, \"wall\"";
    row.technique = kTechniques[technique];
    row.techniqueFull = "whole+" + row.technique;
    row.lixels = std::to_string(lixels) + "x" + std::to_string(lixels);
    row.size = std::to_string(size) + "x" + std::to_string(size);
    row.executor = "trace";
    row.light = lights == 1 ? "sun" : "sun-000";
    if (view == 1 && technique == 1) {
        row.outcome = Refusal{"extent-not-in-hemisphere", "a made-up reason"};
        return row;
    }
    Measurement m;
    m.lightFacing = std::int64_t(size) * size;
    m.misclassified =
        technique == 2 && lixels == 512 ? 0 : std::int64_t(double(m.lightFacing) * (3 + technique) / lixels);
    m.interior = {m.lightFacing, m.misclassified};
    m.lixelsUsed = std::int64_t(lixels) * lixels;
    m.bytes = 4 * m.lixelsUsed;
    m.timing.frameMs = 2 + 1e-5 * double(m.lixelsUsed) + (scene + 1) * (technique + 1) + lights;
    m.timing.clock = "made up";
    row.outcome = m;
    return row;
}

} // namespace

SweepResults sampleSweep(const std::filesystem::path&, int)
{
    SweepResults sweep;
    sweep.name = "made-up";
    sweep.question = "Does <b>everything</b> grow?";
    sweep.lixelVersion = "0.0.1";
    sweep.command = "lixel study made-up.json -o out";
    sweep.timing = {"2026-01-01T00:00:00Z", "nowhere", 1};
    std::size_t number = 0;
    for (const int scene : {0, 1})
        for (const int view : {0, 1})
            for (const int lights : {1, 4})
                for (const int size : {128, 256})
                    for (const int technique : {0, 1, 2})
                        for (const int lixels : {128, 256, 512}) {
                            const SweepRowPlace place{number,
                                                      "row " + std::to_string(number),
                                                      0,
                                                      lights == 1 ? "own" : "suns-4",
                                                      std::size_t(lights),
                                                      scene == 0 ? 9000u : 72000u,
                                                      "nowhere"};
                            sweep.lines.push_back(sweepRowLine(sweepRow(scene, view, lights, technique, lixels, size),
                                                               place, sweep.lixelVersion));
                            ++number;
                        }
    return sweep;
}

BenchResults sampleBench(const std::filesystem::path&, int)
{
    BenchResults bench{"0.0.1", "lixel bench --quick -o out",          "gl", true, 3, {},
                       {},      {"2026-01-01T00:00:00Z", "nowhere", 1}};
    bench.axes = {{"triangles", "triangles of the scene", "256x256 pixels"},
                  {"lixels", "lixels of a light", "30000 triangles"}};
    for (const BenchAxis& axis : bench.axes)
        for (int technique = 0; technique < 3; ++technique)
            for (double size = 1024; size < 2e6; size *= 4) {
                BenchRow row{axis.name, kTechniques[technique], size, std::uint64_t(size), 65536, 262144, 1, {}, ""};
                const double ms = 1e-3 * std::pow(size, 0.5 * (technique + 1));
                if (technique == 2 && size > 1e6) row.skipped = "would take about 3 years";
                else
                    row.measured = BenchRow::Measured{{ms, {{"light depth", 0.5 * ms}}, {}, "made up"},
                                                      0.1 * ms,
                                                      std::uint64_t(1e7 + 100 * size),
                                                      std::uint64_t(4 * size),
                                                      262144};
                bench.rows.push_back(row);
            }
    return bench;
}

} // namespace lixel::test
