// SPDX-License-Identifier: MIT
#include "lixel/report/plane_budget.h"

#include "lixel/report/json.h"
#include "lixel/report/json_document.h"

#include <nlohmann/json.hpp>

namespace lixel {

std::string toJson(const PlaneBudget& study)
{
    using Json = nlohmann::json;
    Json curves = Json::array();
    for (const PlaneBudget::Curve& curve : study.curves) {
        Json points = Json::array();
        for (const auto& [budget, lixelsUsed, count] : curve.points)
            points.push_back({{"budget", budget},
                              {"lixels_used", lixelsUsed},
                              {"samples", count.samples},
                              {"misclassified", count.misclassified},
                              {"misclassified_percent",
                               count.samples > 0 ? Json(100.0 * double(count.misclassified) / double(count.samples))
                                                 : Json(nullptr)}});
        curves.push_back({{"scene", curve.scene},
                          {"technique", curve.technique},
                          {"receivers", curve.isOnPlanes ? "planes" : "others"},
                          {"points", points}});
    }
    Json all = Json::parse(toJson(study.run));
    all["study"] = {{"name", "plane-budget"},
                    {"question", study.question},
                    {"quick", study.isQuick},
                    {"left_out", study.leftOut},
                    {"curves", curves}};
    return documentOf(all);
}

} // namespace lixel
