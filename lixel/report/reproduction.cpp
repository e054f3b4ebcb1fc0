// SPDX-License-Identifier: MIT
#include "lixel/report/reproduction.h"

#include "lixel/report/json.h"

#include <nlohmann/json.hpp>

namespace lixel {

std::string toJson(const Reproduction& reproduction)
{
    using Json = nlohmann::json;
    Json numbers = Json::array();
    for (const ReproducedNumber& n : reproduction.numbers)
        numbers.push_back({{"key", n.key},
                           {"unit", n.unit},
                           {"ours", n.ours},
                           {"papers", n.papers ? Json(*n.papers) : Json(nullptr)},
                           {"source", n.source}});
    Json parameters = Json::object();
    for (const auto& [name, value] : reproduction.parameters) parameters[name] = value;
    Json all = Json::parse(toJson(reproduction.run));
    all["reproduction"] = {{"name", reproduction.name},         {"paper", reproduction.paper},
                           {"question", reproduction.question}, {"quick", reproduction.isQuick},
                           {"parameters", parameters},          {"numbers", numbers}};
    return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace lixel
