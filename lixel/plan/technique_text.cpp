// SPDX-License-Identifier: MIT
#include "lixel/plan/technique_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace lixel {

std::string_view trimmed(std::string_view s)
{
    while (!s.empty() && s.front() == ' ') s.remove_prefix(1);
    while (!s.empty() && s.back() == ' ') s.remove_suffix(1);
    return s;
}

std::optional<std::vector<std::string_view>> split(std::string_view text, char separator)
{
    std::vector<std::string_view> parts;
    int depth = 0;
    std::size_t start = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '(') ++depth;
        if (text[i] == ')' && --depth < 0) return std::nullopt;
        if (text[i] == separator && depth == 0) {
            parts.push_back(trimmed(text.substr(start, i - start)));
            start = i + 1;
        }
    }
    if (depth != 0) return std::nullopt;
    parts.push_back(trimmed(text.substr(start)));
    return parts;
}

std::optional<Word> readWord(std::string_view text)
{
    Word word;
    const std::size_t open = text.find('('), colon = text.find(':');
    if (open != std::string_view::npos && (colon == std::string_view::npos || open < colon)) {
        if (text.back() != ')') return std::nullopt;
        word.name = trimmed(text.substr(0, open));
        const auto arguments = split(text.substr(open + 1, text.size() - open - 2), ',');
        if (!arguments) return std::nullopt;
        word.arguments = *arguments;
        return word;
    }
    const auto parts = split(text, ':');
    if (!parts) return std::nullopt;
    word.name = parts->front();
    word.arguments.assign(parts->begin() + 1, parts->end());
    return word;
}

std::optional<int> readInteger(std::string_view text)
{
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::optional<double> readNumber(std::string_view text)
{
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::optional<std::string_view> Arguments::take(std::string_view key, bool mayStandAlone)
{
    for (std::size_t i = 0; i < left_.size(); ++i) {
        const std::size_t equals = left_[i].find('=');
        const bool isNamed = equals != std::string_view::npos && trimmed(left_[i].substr(0, equals)) == key;
        const bool isAlone = mayStandAlone && equals == std::string_view::npos && i == 0;
        if (!isNamed && !isAlone) continue;
        const std::string_view value = isNamed ? trimmed(left_[i].substr(equals + 1)) : left_[i];
        left_.erase(left_.begin() + std::ptrdiff_t(i));
        return value;
    }
    return std::nullopt;
}

bool Arguments::takeFlag(std::string_view name)
{
    const auto found = std::find(left_.begin(), left_.end(), name);
    if (found == left_.end()) return false;
    left_.erase(found);
    return true;
}

} // namespace lixel
