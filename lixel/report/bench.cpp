// SPDX-License-Identifier: MIT
#include "lixel/report/bench.h"

#include "lixel/report/json_document.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string_view>

namespace lixel {
namespace {

using Json = nlohmann::json;

constexpr int kVersion = 1;

template <typename T>
Json orNull(const std::optional<T>& value)
{
    return value ? Json(*value) : Json(nullptr);
}

std::optional<double> quantityOf(const BenchRow::Measured& row, std::string_view quantity)
{
    const auto number = [](const auto& value) { return value ? std::optional(double(*value)) : std::nullopt; };
    if (quantity == "frame_ms") return row.timing.frameMs;
    if (quantity == "plan_ms") return row.planMs;
    if (quantity == "peak_resident_bytes") return number(row.peakResidentBytes);
    return number(row.deviceBytes);
}

Json measured(const BenchRow::Measured& of)
{
    Json passes = Json::array();
    for (const PassTime& pass : of.timing.passes) passes.push_back({{"name", pass.name}, {"ms", pass.ms}});
    return {{"frame_ms", orNull(of.timing.frameMs)},
            {"gpu_ms", orNull(of.timing.gpuMs)},
            {"clock", of.timing.clock},
            {"passes", passes},
            {"plan_ms", of.planMs},
            {"peak_resident_bytes", orNull(of.peakResidentBytes)},
            {"device_bytes", orNull(of.deviceBytes)}};
}

} // namespace

std::vector<BenchGrowth> growthsOf(const BenchResults& bench)
{
    std::vector<BenchGrowth> out;
    for (std::size_t begin = 0, end = 0; begin < bench.rows.size(); begin = end) {
        const BenchRow& first = bench.rows[begin];
        for (end = begin; end < bench.rows.size() && bench.rows[end].axis == first.axis &&
                          bench.rows[end].technique == first.technique;)
            ++end;
        for (const char* quantity : kBenchQuantities) {
            std::vector<GrowthPoint> points;
            for (std::size_t i = begin; i < end; ++i)
                if (const BenchRow& row = bench.rows[i]; row.measured)
                    if (const auto cost = quantityOf(*row.measured, quantity); cost && *cost > 0)
                        points.push_back({row.size, *cost});
            if (const auto growth = growthOf(points)) out.push_back({first.axis, first.technique, quantity, *growth});
        }
    }
    return out;
}

std::string toJson(const BenchResults& bench)
{
    Json axes = Json::array(), rows = Json::array(), growths = Json::array();
    for (const BenchAxis& axis : bench.axes)
        axes.push_back({{"axis", axis.name}, {"unit", axis.unit}, {"others", axis.others}});
    for (const BenchRow& row : bench.rows) {
        rows.push_back({{"axis", row.axis},
                        {"technique", row.technique},
                        {"size", row.size},
                        {"triangles", row.triangles},
                        {"pixels", row.pixels},
                        {"lixels", row.lixels},
                        {"lights", row.lights}});
        if (!row.measured) rows.back()["skipped"] = row.skipped;
        else {
            rows.back()["lixels_used"] = row.measured->lixelsUsed;
            rows.back()["timing"] = measured(*row.measured);
        }
    }
    for (const BenchGrowth& g : growthsOf(bench))
        growths.push_back({{"axis", g.axis},
                           {"technique", g.technique},
                           {"quantity", g.quantity},
                           {"exponent", g.growth.exponent},
                           {"factor", g.growth.factor},
                           {"log_deviation", g.growth.deviation},
                           {"from_size", g.growth.from},
                           {"points", g.growth.points}});
    Json timing = toJson(bench.timing);
    timing["growth"] = growths;
    const Json all = {{"version", kVersion},
                      {"lixel_version", bench.lixelVersion},
                      {"command", bench.command},
                      {"executor", bench.executor},
                      {"quick", bench.isQuick},
                      {"timing_frames", bench.frames},
                      {"axes", axes},
                      {"rows", rows},
                      {"timing", timing}};
    return documentOf(all);
}

} // namespace lixel
