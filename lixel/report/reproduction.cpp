// SPDX-License-Identifier: MIT
#include "lixel/report/reproduction.h"

#include "lixel/report/json.h"

#include <nlohmann/json.hpp>

namespace lixel {
namespace {

using Json = nlohmann::json;

Json toJson(const std::vector<ReproducedNumber>& numbers)
{
    Json all = Json::array();
    for (const ReproducedNumber& n : numbers)
        all.push_back({{"key", n.key},
                       {"unit", n.unit},
                       {"ours", n.ours},
                       {"papers", n.papers ? Json(*n.papers) : Json(nullptr)},
                       {"source", n.source}});
    return all;
}

Json toJson(const std::vector<PictureRow>& figures)
{
    Json all = Json::array();
    for (const PictureRow& f : figures)
        all.push_back({{"title", f.title},
                       {"scene", f.scene},
                       {"view", f.view},
                       {"light", f.light},
                       {"techniques", f.techniques},
                       {"enlarged", {{"left", f.left}, {"top", f.top}, {"side", f.side}}}});
    return all;
}

} // namespace

std::string toJson(const Reproduction& reproduction)
{
    Json parameters = Json::object();
    for (const auto& [name, value] : reproduction.parameters) parameters[name] = value;
    Json all = Json::parse(toJson(reproduction.run));
    all["reproduction"] = {{"name", reproduction.name},
                           {"paper", reproduction.paper},
                           {"question", reproduction.question},
                           {"quick", reproduction.isQuick},
                           {"parameters", parameters},
                           {"numbers", toJson(reproduction.numbers)},
                           {"figures", toJson(reproduction.figures)},
                           {"timing", {{"numbers", toJson(reproduction.timingNumbers)}}}};
    return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace lixel
