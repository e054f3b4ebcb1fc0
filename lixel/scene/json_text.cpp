// SPDX-License-Identifier: MIT
#include "lixel/scene/json_text.h"

#include "lixel/scene/input_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <vector>

namespace lixel {
namespace {

using nlohmann::json;

constexpr int kMostLevels = 64;
constexpr int kMostValues = 4'000'000;

// "line 3, column 7" of a byte of the text, both counted from 1, as that is.
std::string linePlace(std::string_view text, std::size_t byte)
{
    const std::string_view before = text.substr(0, std::min(byte > 0 ? byte - 1 : 0, text.size()));
    const std::size_t lineStart = before.rfind('\n') + 1; // npos + 1 is 0
    return fmt::format("line {}, column {}", 1 + std::count(before.begin(), before.end(), '\n'),
                       before.size() - lineStart + 1);
}

} // namespace

json parseJson(std::string_view text, const std::string& file, RepeatedMembers repeated)
{
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3); // a byte order mark
    int values = 0;
    std::vector<std::set<std::string>> open;
    const auto look = [&](int depth, json::parse_event_t event, json& parsed) {
        if (depth > kMostLevels) refuse(file, "", fmt::format("expected JSON of at most {} levels", kMostLevels));
        if (++values > kMostValues) refuse(file, "", fmt::format("expected JSON of at most {} values", kMostValues));
        if (repeated == RepeatedMembers::LastCounts) return true;
        if (event == json::parse_event_t::object_start) open.emplace_back();
        if (event == json::parse_event_t::object_end) open.pop_back();
        if (event == json::parse_event_t::key && !open.back().insert(parsed.get<std::string>()).second)
            refuse(file, "", fmt::format("member \"{}\" is given twice", printable(parsed.get<std::string>())));
        return true;
    };
    try {
        return json::parse(text, look);
    } catch (const json::parse_error& error) {
        refuse(file, linePlace(text, error.byte), "expected JSON");
    } catch (const json::out_of_range&) {
        refuse(file, "", "expected numbers that fit a double");
    }
}

} // namespace lixel
