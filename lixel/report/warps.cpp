// SPDX-License-Identifier: MIT
#include "lixel/report/warps.h"

#include "lixel/report/json_document.h"

#include <nlohmann/json.hpp>

namespace lixel {
namespace {

using Json = nlohmann::json;

constexpr int kVersion = 1;

} // namespace

std::string toJson(const WarpStudy& study)
{
    Json rows = Json::array();
    for (const WarpStudy::Row& row : study.rows)
        rows.push_back({{"curve", row.curve},
                        {"value", row.value},
                        {"technique", row.technique},
                        {"is_own", row.isOwn},
                        {"lights", row.lights},
                        {"misclassified", row.misclassified},
                        {"misclassified_percent", row.percent},
                        {"ratio_to_focused", row.ratioToFocused},
                        {"used_share", row.usedShare},
                        {"count_variation", row.countVariation},
                        {"knot_bytes", row.knotBytes}});
    Json json = studyHead(kVersion, "warps", study);
    json["rows"] = rows;
    return documentOf(json);
}

} // namespace lixel
