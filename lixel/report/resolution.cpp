// SPDX-License-Identifier: MIT
#include "lixel/report/resolution.h"

#include "lixel/report/json_document.h"

#include <nlohmann/json.hpp>

namespace lixel {
namespace {

using Json = nlohmann::json;

constexpr int kVersion = 1;

Json toJson(const ResolutionStudy::Row& row)
{
    Json out = {{"view", row.view}, {"light", row.light}, {"technique", row.technique}};
    out["refused"] = row.refused.empty() ? Json() : Json(row.refused);
    if (!row.refused.empty()) return out;
    out["side_by_metric"] = row.sideByMetric;
    out["side_predicted"] = row.sidePredicted;
    out["side"] = row.side ? Json(*row.side) : Json();
    out["misclassified_percent"] = row.misclassifiedPercent;
    out["lixels"] = row.side ? Json(row.lixels) : Json();
    out["sides_measured"] = row.sidesMeasured;
    return out;
}

} // namespace

std::string toJson(const ResolutionStudy& study)
{
    Json rows = Json::array();
    for (const ResolutionStudy::Row& row : study.rows) rows.push_back(toJson(row));
    Json json = studyHead(kVersion, "resolution", study);
    json["tolerance_percent"] = study.tolerancePercent;
    json["largest_side"] = study.largestSide;
    json["rows"] = rows;
    return documentOf(json);
}

} // namespace lixel
