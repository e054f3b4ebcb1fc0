// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

// JSON text, of whatever it may be, as values.
namespace lixel {

enum class RepeatedMembers { LastCounts, Refused };

// At most 64 levels and four million values, which take seconds and gigabytes. Throws InputError: with line and column where `text` is
// no JSON or not UTF-8; where a number does not fit a double; where a member is given twice, if that is refused.
nlohmann::json parseJson(std::string_view text, const std::string& file,
                         RepeatedMembers repeated = RepeatedMembers::Refused);

} // namespace lixel
