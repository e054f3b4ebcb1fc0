// SPDX-License-Identifier: MIT
#include "text.h"

#include "exit_code.h"

#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace lixel::app {
namespace {

template <typename T>
std::optional<T> readNumber(std::string_view text)
{
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

} // namespace

LixelSize readSize(std::string_view text, std::string_view option, int most)
{
    const std::size_t x = text.find('x');
    const auto width = x == std::string_view::npos ? std::nullopt : readNumber<int>(text.substr(0, x));
    const auto height = x == std::string_view::npos ? std::nullopt : readNumber<int>(text.substr(x + 1));
    if (!width || !height || *width < 1 || *height < 1 || *width > most || *height > most)
        throw UsageError(fmt::format("{} \"{}\": expected WIDTHxHEIGHT, each from 1 to {}", option, text, most));
    return {*width, *height};
}

LixelBudget readBudget(std::string_view text, std::string_view option, int most)
{
    LixelBudget budget;
    for (std::string_view rest = text;;) {
        const std::size_t comma = rest.find(',');
        budget.ofRegions.push_back(readSize(rest.substr(0, comma), option, most));
        if (comma == std::string_view::npos) break;
        rest.remove_prefix(comma + 1);
    }
    budget.total = budget.ofRegions.front();
    if (budget.ofRegions.size() == 1) {
        budget.ofRegions.clear();
        return budget;
    }
    std::int64_t sum = 0;
    for (const LixelSize& size : budget.ofRegions) sum += std::int64_t(size.width) * size.height;
    budget.total.width = int(std::sqrt(double(sum)));
    budget.total.height = int(sum / budget.total.width);
    return budget;
}

std::string toString(const LixelBudget& budget)
{
    if (budget.ofRegions.empty()) return toString(budget.total);
    std::string text;
    for (const LixelSize& size : budget.ofRegions) text += (text.empty() ? "" : ",") + toString(size);
    return text;
}

double readPercent(std::string_view text, std::string_view option)
{
    const bool hasSign = !text.empty() && text.back() == '%';
    const auto percent = readNumber<double>(hasSign ? text.substr(0, text.size() - 1) : text);
    if (!percent || !(*percent > 0 && *percent <= 100))
        throw UsageError(fmt::format("{} \"{}\": expected a percentage above 0 and up to 100, as 0.5%", option, text));
    return *percent;
}

Vec3d readVec3(std::string_view text, std::string_view option)
{
    double values[3] = {};
    std::string_view rest = text;
    for (int i = 0; i < 3; ++i) {
        const std::size_t comma = rest.find(',');
        const auto value = readNumber<double>(rest.substr(0, comma));
        const bool isLast = comma == std::string_view::npos;
        if (!value || !std::isfinite(*value) || isLast != (i == 2))
            throw UsageError(fmt::format("{} \"{}\": expected three finite numbers, X,Y,Z", option, text));
        values[i] = *value;
        rest = isLast ? std::string_view{} : rest.substr(comma + 1);
    }
    return {values[0], values[1], values[2]};
}

std::string toString(LixelSize size) { return fmt::format("{}x{}", size.width, size.height); }

std::string slug(std::string_view text)
{
    constexpr std::size_t kMost = 60;
    std::string out;
    for (const char c : text.substr(0, kMost)) {
        const bool isPlain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (isPlain) out += c;
        else if (!out.empty() && out.back() != '-') out += '-';
    }
    while (!out.empty() && out.back() == '-') out.pop_back();
    return out.empty() ? "unnamed" : out;
}

std::string oneLine(std::string_view text)
{
    std::string out(text);
    for (char& c : out)
        if (const auto byte = static_cast<unsigned char>(c); byte < 0x20 || byte == 0x7f) c = ' ';
    return out;
}

std::string distinctName(std::string_view name, std::set<std::string>& taken)
{
    constexpr std::size_t kMost = 64;
    std::string stem = oneLine(name);
    if (stem.size() > kMost) {
        std::size_t end = kMost;
        while (end > 0 && (static_cast<unsigned char>(stem[end]) & 0xc0) == 0x80) --end; // within a character of UTF-8
        stem.resize(end);
    }
    if (stem.empty()) stem = "unnamed";
    std::string out = stem;
    for (int i = 2; !taken.insert(out).second; ++i) out = fmt::format("{}-{}", stem, i);
    return out;
}

std::string quoted(int argc, const char* const* argv)
{
    constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=:,+";
    std::string out;
    for (int i = 0; i < argc; ++i) {
        const std::string_view word = i == 0 ? "lixel" : argv[i];
        out += i == 0 ? "" : " ";
        if (!word.empty() && word.find_first_not_of(kPlain) == std::string_view::npos) {
            out += word;
            continue;
        }
        out += '\'';
        for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
        out += '\'';
    }
    return out;
}

} // namespace lixel::app
