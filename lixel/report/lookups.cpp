// SPDX-License-Identifier: MIT
#include "lixel/report/lookups.h"

#include "lixel/report/json.h"
#include "lixel/report/json_document.h"

#include <nlohmann/json.hpp>

namespace lixel {
namespace {

using Json = nlohmann::json;

Json orNull(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json timesJson(const std::optional<LookupStudy::Times>& of)
{
    if (!of) return nullptr;
    return {{"frame_ratio", of->frameRatio},
            {"pass_ratio", of->passRatio},
            {"prepare_ms", of->prepareMs},
            {"lookup_ms", of->lookupMs}};
}

Json lookupJson(const LookupStudy::Lookup& of)
{
    return {{"lookup", of.lookup},
            {"technique_full", of.techniqueFull},
            {"bytes_per_lixel", of.bytesPerLixel},
            {"bytes_read_per_lixel", of.bytesReadPerLixel},
            {"lights", of.lights},
            {"misclassified", of.misclassified},
            {"misclassified_percent", of.misclassifiedPercent},
            {"ratio_to_nearest", of.ratioToNearest},
            {"shades", of.shades},
            {"transition_pixels", of.transitionPixels},
            {"bleeding_percent", of.bleedingPercent},
            {"dark_interior_samples", of.darkInterior.samples},
            {"dark_interior_lit", of.darkInterior.misclassified},
            {"area_rmse", of.areaRmse},
            {"area_largest", of.areaLargest},
            {"filter_lixels", orNull(of.filterLixels)},
            {"filtered_rmse", orNull(of.filteredRmse)},
            {"filtered_largest", orNull(of.filteredLargest)},
            {"timing", timesJson(of.times)}};
}

Json frontsJson(const std::vector<LookupStudy::Front>& of)
{
    Json json = Json::array();
    for (const auto& [error, cost, lookups] : of)
        json.push_back({{"error", error}, {"cost", cost}, {"lookups", lookups}});
    return json;
}

} // namespace

std::string toJson(const LookupStudy& study)
{
    Json lookups = Json::array();
    for (const LookupStudy::Lookup& lookup : study.lookups) lookups.push_back(lookupJson(lookup));
    Json all = Json::parse(toJson(study.run));
    all["study"] = {{"name", "lookups"},
                    {"question", study.question},
                    {"quick", study.isQuick},
                    {"left_out", study.leftOut},
                    {"lookups", lookups},
                    {"fronts", frontsJson(study.fronts)},
                    {"timing", {{"fronts", frontsJson(study.frontsOfTimes)}}}};
    return documentOf(all);
}

} // namespace lixel
