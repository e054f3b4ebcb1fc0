// SPDX-License-Identifier: MIT
#include "lixel/report/scene_optimal_sensitivity.h"

#include "lixel/report/json_document.h"

#include <nlohmann/json.hpp>

namespace lixel {
namespace {

using Json = nlohmann::json;

constexpr int kVersion = 1;

} // namespace

std::string toJson(const SceneOptimalSensitivity& study)
{
    Json rows = Json::array();
    for (const SceneOptimalSensitivity::Curve& curve : study.curves)
        for (const SceneOptimalSensitivity::Point& point : curve.points)
            rows.push_back({{"technique", curve.technique},
                            {"parameter", curve.parameter},
                            {"value", point.value},
                            {"is_own", point.isOwn},
                            {"misclassified", point.misclassified},
                            {"misclassified_focused", point.ofFocused},
                            {"ratio_to_focused", point.ratio()},
                            {"lights", point.lights}});
    Json json = studyHead(kVersion, "scene-optimal-sensitivity", study);
    json["rows"] = rows;
    return documentOf(json);
}

} // namespace lixel
