// SPDX-License-Identifier: MIT
#include "lixel/report/scene_optimal_search.h"

#include "lixel/report/json_document.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace lixel {
namespace {

using Json = nlohmann::json;

constexpr int kVersion = 1;

Json toJson(const std::vector<SearchQuality>& all)
{
    Json out = Json::array();
    for (const SearchQuality& q : all)
        out.push_back({{"metric", q.metric},
                       {"cases", q.cases},
                       {"cases_within", q.withinShare},
                       {"within_percent", 100.0 * q.withinShare / q.cases},
                       {"worst_ratio", q.worstRatio},
                       {"mean_ratio", q.meanRatio}});
    return out;
}

} // namespace

std::vector<SearchQuality> searchQuality(const SceneOptimalSearch& study, double SceneOptimalSearch::Case::*search)
{
    std::vector<SearchQuality> out;
    for (const SceneOptimalSearch::Case& c : study.cases) {
        auto at = std::find_if(out.begin(), out.end(), [&](const SearchQuality& q) { return q.metric == c.metric; });
        if (at == out.end()) at = out.insert(out.end(), SearchQuality{c.metric, 0, 0, 0, 0});
        const double ratio = c.*search / c.exhaustive;
        ++at->cases;
        at->withinShare += ratio <= 1 + study.share;
        at->worstRatio = std::max(at->worstRatio, ratio);
        at->meanRatio += ratio;
    }
    for (SearchQuality& q : out) q.meanRatio /= q.cases;
    return out;
}

std::string toJson(const SceneOptimalSearch& study)
{
    Json cases = Json::array();
    for (const SceneOptimalSearch::Case& c : study.cases)
        cases.push_back({{"light", c.light},
                         {"metric", c.metric},
                         {"samples", c.samples},
                         {"energy_exhaustive", c.exhaustive},
                         {"energy_wide", c.wide},
                         {"energy_descent", c.descent}});
    Json json = studyHead(kVersion, "scene-optimal-search", study);
    json["lights_left_out"] = study.leftOut;
    json["axes"] = study.axes;
    json["axes_refined"] = study.refined;
    json["within_share"] = study.share;
    json["wide"] = toJson(searchQuality(study, &SceneOptimalSearch::Case::wide));
    json["descent"] = toJson(searchQuality(study, &SceneOptimalSearch::Case::descent));
    json["cases"] = cases;
    return documentOf(json);
}

} // namespace lixel
