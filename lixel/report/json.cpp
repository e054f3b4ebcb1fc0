// SPDX-License-Identifier: MIT
#include "lixel/report/json.h"

#include "lixel/report/json_document.h"

#include <nlohmann/json.hpp>

namespace lixel {
namespace {

using Json = nlohmann::json; // objects are sorted by key

template <typename T>
Json orNull(const std::optional<T>& value)
{
    return value ? Json(*value) : Json(nullptr);
}

// Nothing of nothing is no percentage.
Json percent(std::int64_t part, std::int64_t whole)
{
    return whole > 0 ? Json(100.0 * double(part) / double(whole)) : Json(nullptr);
}

void putCount(Json& row, const std::string& name, const SampleCount& count)
{
    row[name + "_samples"] = count.samples;
    row[name + "_misclassified"] = count.misclassified;
    row[name + "_percent"] = percent(count.misclassified, count.samples);
}

Json percentiles(const std::optional<Percentiles>& of)
{
    if (!of) return nullptr;
    return {{"p1", of->p1}, {"p10", of->p10}, {"p50", of->p50}, {"p90", of->p90}, {"p99", of->p99}, {"max", of->max}};
}

void putFlips(Json& json, const std::string& prefix, const FlipCount& count)
{
    json[prefix + "samples"] = count.samples;
    json[prefix + "flips"] = count.flips;
    json[prefix + "flips_percent"] = percent(count.flips, count.samples);
}

Json temporal(const Temporal& of)
{
    Json pairs = Json::array();
    for (const FramePairFlips& pair : of.pairs)
        pairs.push_back({{"seconds", pair.seconds}, {"samples", pair.count.samples}, {"flips", pair.count.flips}});
    Json json = {{"frames", of.frames},
                 {"refused_frames", of.refusedFrames},
                 {"from_seconds", of.fromSeconds},
                 {"to_seconds", of.toSeconds},
                 {"still", of.isStill},
                 {"pairs", pairs}};
    putFlips(json, "", of.all);
    putFlips(json, "edge_band_", of.edgeBand);
    putFlips(json, "terminator_band_", of.terminatorBand);
    putFlips(json, "interior_", of.interior);
    return json;
}

Json shades(const ShadeQuality& of)
{
    return {{"distinct", of.distinct},
            {"transition_pixels", of.transitionPixels},
            {"bleeding_percent", of.bleedingPercent},
            {"dark_interior_samples", of.darkInterior.samples},
            {"dark_interior_lit", of.darkInterior.misclassified},
            {"area_rmse", of.area.rmse},
            {"area_largest", of.area.largest},
            {"filter_lixels", orNull(of.filterLixels)},
            {"filtered_rmse", of.filtered ? Json(of.filtered->rmse) : Json(nullptr)},
            {"filtered_largest", of.filtered ? Json(of.filtered->largest) : Json(nullptr)}};
}

Json pictures(const PictureFiles& files)
{
    Json json = Json::object();
    if (!files.shaded.empty()) json["shaded"] = files.shaded;
    if (!files.error.empty()) json["error"] = files.error;
    if (!files.footprint.empty()) json["footprint"] = files.footprint;
    if (!files.density.empty()) json["density"] = files.density;
    if (!files.boundary.empty()) json["boundary"] = files.boundary;
    return json;
}

Json timing(const RowTiming& of)
{
    Json passes = Json::array();
    for (const PassTime& pass : of.passes) passes.push_back({{"name", pass.name}, {"ms", pass.ms}});
    return {{"frame_ms", orNull(of.frameMs)}, {"gpu_ms", orNull(of.gpuMs)}, {"clock", of.clock}, {"passes", passes}};
}

Json nameOrNull(const std::string& name) { return name.empty() ? Json(nullptr) : Json(name); }

Json planes(const std::vector<PlaneSamples>& of)
{
    Json json = Json::array();
    for (const auto& [plane, count, causes] : of) {
        json.push_back({{"plane", nameOrNull(plane)},
                        {"samples", count.samples},
                        {"misclassified", count.misclassified},
                        {"misclassified_percent", percent(count.misclassified, count.samples)}});
        if (!causes) continue;
        json.back()["misclassified_near_edge"] = causes->nearEdge;
        json.back()["misclassified_near_caster"] = causes->nearCaster;
        json.back()["misclassified_unexplained"] = causes->unexplained;
    }
    return json;
}

Json regions(const std::vector<RegionUse>& of)
{
    Json json = Json::array();
    for (const RegionUse& region : of)
        json.push_back({{"plane", nameOrNull(region.plane)}, {"lixels", {region.width, region.height}}});
    return json;
}

Json leftOut(const std::vector<LeftOut>& of)
{
    Json json = Json::array();
    for (const auto& [plane, reason] : of) json.push_back({{"plane", plane}, {"reason", reason}});
    return json;
}

void putMeasurement(Json& row, const Measurement& of)
{
    row["light_facing"] = of.lightFacing;
    row["misclassified"] = of.misclassified;
    row["misclassified_percent"] = percent(of.misclassified, of.lightFacing);
    row["false_shadow"] = of.falseShadow;
    row["false_lit"] = of.falseLit;
    putCount(row, "edge_band", of.edgeBand);
    putCount(row, "terminator_band", of.terminatorBand);
    putCount(row, "interior", of.interior);
    if (!of.planes.empty()) row["planes"] = planes(of.planes);
    row["unserved"] = of.unserved;
    row["lixels_used"] = of.lixelsUsed;
    row["bytes"] = of.bytes;
    if (!of.regions.empty()) row["regions"] = regions(of.regions);
    if (!of.leftOut.empty()) row["left_out"] = leftOut(of.leftOut);
    row["footprint_pixels_per_lixel"] = percentiles(of.footprintPixelsPerLixel);
    row["density_lixels_per_pixel"] = percentiles(of.densityLixelsPerPixel);
    if (of.agreement) {
        row["agreement_with"] = of.agreement->executor;
        row["agreement_percent"] = of.agreement->agreementPercent;
        row["shared_misclassified_percent"] = orNull(of.agreement->sharedMisclassifiedPercent);
        row["lixels_agreeing_percent"] = orNull(of.agreement->lixelsAgreeingPercent);
    }
    if (of.temporal) row["temporal"] = temporal(*of.temporal);
    if (of.shades) row["shades"] = shades(*of.shades);
    row["pictures"] = pictures(of.pictures);
    row["timing"] = timing(of.timing);
}

Json rowJson(const ResultRow& of, const std::string& lixelVersion)
{
    Json row = {{"scene", of.scene},
                {"view", of.view},
                {"light", of.light},
                {"technique", of.technique},
                {"technique_full", of.techniqueFull},
                {"lixels", of.lixels},
                {"size", of.size},
                {"executor", of.executor},
                {"seed", of.seed},
                {"lixel_version", lixelVersion}};
    if (const Measurement* measured = of.measured()) putMeasurement(row, *measured);
    if (const Refusal* refused = of.refused())
        row["refused"] = {{"reason", refused->reason}, {"message", refused->message}};
    return row;
}

} // namespace

std::string toJson(const ResultRow& row, const std::string& lixelVersion)
{
    return inOneLine(rowJson(row, lixelVersion));
}

std::string toJson(const RunResults& results)
{
    std::vector<ResultRow> sorted = results.rows;
    sortByKey(sorted);
    Json rows = Json::array();
    for (const ResultRow& row : sorted) rows.push_back(rowJson(row, results.lixelVersion));
    const Json run = {{"version", kResultsVersion},
                      {"lixel_version", results.lixelVersion},
                      {"command", results.command},
                      {"seed", results.seed},
                      {"results", rows},
                      {"timing", toJson(results.timing)}};
    return documentOf(run);
}

} // namespace lixel
