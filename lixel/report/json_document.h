// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/results.h"

#include <string>

#include <nlohmann/json.hpp>

// What all JSON that is written has in common: bytes that are not UTF-8 become the replacement character.
namespace lixel {

std::string documentOf(const nlohmann::json& json); // a value a line, closed by a line break
std::string inOneLine(const nlohmann::json& json);

nlohmann::json toJson(const RunTiming& timing);

} // namespace lixel
