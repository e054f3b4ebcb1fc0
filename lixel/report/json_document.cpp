// SPDX-License-Identifier: MIT
#include "lixel/report/json_document.h"

namespace lixel {

using Json = nlohmann::json;

std::string documentOf(const Json& json) { return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n"; }

std::string inOneLine(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json toJson(const RunTiming& timing)
{
    return {{"date", timing.date}, {"host", timing.host}, {"total_seconds", timing.totalSeconds}};
}

} // namespace lixel
