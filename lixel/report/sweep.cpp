// SPDX-License-Identifier: MIT
#include "lixel/report/sweep.h"

#include "lixel/base/assert.h"
#include "lixel/report/json.h"
#include "lixel/report/json_document.h"

#include <nlohmann/json.hpp>

#include <array>

namespace lixel {
namespace {

using Json = nlohmann::json; // objects are sorted by key

// `timing` comes last, wherever its name would stand in the order: what follows can then be cut off.
std::string lineOf(const Json& row, const Json& timing)
{
    std::string line = inOneLine(row);
    line.pop_back();
    return line + ",\"timing\":" + inOneLine(timing) + "}";
}

// Columns of the table, by the place of their value in the row. Those of `timing` are the last.
struct Column
{
    const char* title;
    const char* pointer;
};
constexpr std::array kColumns = std::to_array<Column>({
    {"row", "/row"},
    {"scene", "/scene"},
    {"view", "/view"},
    {"time_seconds", "/time_seconds"},
    {"lights", "/lights"},
    {"light_count", "/light_count"},
    {"light", "/light"},
    {"technique", "/technique"},
    {"technique_full", "/technique_full"},
    {"lixels", "/lixels"},
    {"size", "/size"},
    {"executor", "/executor"},
    {"seed", "/seed"},
    {"lixel_version", "/lixel_version"},
    {"triangles", "/triangles"},
    {"refused_reason", "/refused/reason"},
    {"light_facing", "/light_facing"},
    {"misclassified", "/misclassified"},
    {"misclassified_percent", "/misclassified_percent"},
    {"false_shadow", "/false_shadow"},
    {"false_lit", "/false_lit"},
    {"edge_band_samples", "/edge_band_samples"},
    {"edge_band_misclassified", "/edge_band_misclassified"},
    {"edge_band_percent", "/edge_band_percent"},
    {"terminator_band_samples", "/terminator_band_samples"},
    {"terminator_band_misclassified", "/terminator_band_misclassified"},
    {"terminator_band_percent", "/terminator_band_percent"},
    {"interior_samples", "/interior_samples"},
    {"interior_misclassified", "/interior_misclassified"},
    {"interior_percent", "/interior_percent"},
    {"unserved", "/unserved"},
    {"lixels_used", "/lixels_used"},
    {"bytes", "/bytes"},
    {"footprint_p50_pixels_per_lixel", "/footprint_pixels_per_lixel/p50"},
    {"footprint_p90_pixels_per_lixel", "/footprint_pixels_per_lixel/p90"},
    {"footprint_p99_pixels_per_lixel", "/footprint_pixels_per_lixel/p99"},
    {"footprint_max_pixels_per_lixel", "/footprint_pixels_per_lixel/max"},
    {"density_p1_lixels_per_pixel", "/density_lixels_per_pixel/p1"},
    {"density_p10_lixels_per_pixel", "/density_lixels_per_pixel/p10"},
    {"density_p50_lixels_per_pixel", "/density_lixels_per_pixel/p50"},
    {"timing_frame_ms", "/timing/frame_ms"},
    {"timing_gpu_ms", "/timing/gpu_ms"},
    {"timing_clock", "/timing/clock"},
    {"timing_host", "/timing/host"},
});
constexpr std::size_t kTimingColumns = 4;

// Nothing where the row has no such member, or null.
std::string cellText(const Json& row, const char* pointer)
{
    const Json::json_pointer place(pointer);
    if (!row.contains(place) || row[place].is_null()) return "";
    const Json& value = row[place];
    if (!value.is_string()) return inOneLine(value);
    const std::string& text = value.get_ref<const std::string&>();
    if (text.find_first_of(",\"\r\n") == text.npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

} // namespace

std::string sweepRowLine(const ResultRow& row, const SweepRowPlace& place, const std::string& lixelVersion)
{
    Json json = Json::parse(toJson(row, lixelVersion));
    json["row"] = place.number;
    json["key"] = place.key;
    json["time_seconds"] = place.timeSeconds;
    json["lights"] = place.lights;
    json["light_count"] = place.lightCount;
    json["triangles"] = place.triangles;
    json.erase("pictures"); // there are none
    Json timing = json.contains("timing") ? json["timing"] : Json::object();
    timing["host"] = place.host;
    json.erase("timing");
    return lineOf(json, timing);
}

std::optional<SweepRowName> nameOfSweepRow(std::string_view line)
{
    const Json row = Json::parse(line, nullptr, false);
    if (!row.is_object() || !row.contains("row") || !row.contains("key")) return std::nullopt;
    if (!row["row"].is_number_unsigned() || !row["key"].is_string()) return std::nullopt;
    return SweepRowName{row["row"].get<std::size_t>(), row["key"].get<std::string>(), row.contains("refused")};
}

std::string toJsonLines(const std::vector<std::string>& lines, bool withTiming)
{
    std::string text;
    for (const std::string& line : lines) {
        const std::size_t timing = line.rfind(",\"timing\":");
        LX_ASSERT(timing != line.npos);
        text += (withTiming ? line : line.substr(0, timing) + "}") + "\n";
    }
    return text;
}

std::string toCsv(const std::vector<std::string>& lines, bool withTiming)
{
    const std::size_t columns = kColumns.size() - (withTiming ? 0 : kTimingColumns);
    std::string text;
    for (std::size_t i = 0; i < columns; ++i) text.append(i > 0 ? "," : "").append(kColumns[i].title);
    text += '\n';
    for (const std::string& line : lines) {
        const Json row = Json::parse(line);
        for (std::size_t i = 0; i < columns; ++i)
            text.append(i > 0 ? "," : "").append(cellText(row, kColumns[i].pointer));
        text += '\n';
    }
    return text;
}

std::string toJson(const SweepResults& sweep)
{
    Json rows = Json::array();
    for (const std::string& line : sweep.lines) rows.push_back(Json::parse(line));
    const Json all = {{"version", kResultsVersion},
                      {"lixel_version", sweep.lixelVersion},
                      {"command", sweep.command},
                      {"seed", sweep.seed},
                      {"sweep", {{"name", sweep.name}, {"question", sweep.question}}},
                      {"results", rows},
                      {"timing", toJson(sweep.timing)}};
    return inOneLine(all) + "\n";
}

} // namespace lixel
