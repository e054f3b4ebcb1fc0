// SPDX-License-Identifier: MIT
#include "lixel/plan/warp/warp_text.h"

#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace lixel {
namespace {

constexpr std::string_view kTakes =
    "takes importance=, analysis=backward, forward or hybrid, power = 0 to 1, smooth = 0 to 1, floor = 0 to 1, grid = "
    "8 to "
    "1024, lines=nearest or interpolated (now) and raster=vertices, tessellate or exact";
constexpr std::string_view kImportances =
    "importance= takes count, distance, normal, edges, boundaries, shadow-edges, max(...) of these, and products by *";

template <typename Value, std::size_t N>
using Names = std::array<std::pair<std::string_view, Value>, N>;

constexpr Names<SampleWeight, 5> kWeights{{{"distance", kDistanceWeight},
                                           {"normal", kNormalWeight},
                                           {"edges", kEdgesWeight},
                                           {"boundaries", kBoundariesWeight},
                                           {"shadow-edges", kShadowEdgesWeight}}};
constexpr Names<Analysis, 3> kAnalyses{
    {{"backward", Analysis::Backward}, {"forward", Analysis::Forward}, {"hybrid", Analysis::Hybrid}}};
constexpr Names<WarpLines, 2> kLines{{{"nearest", WarpLines::Nearest}, {"interpolated", WarpLines::Interpolated}}};
constexpr Names<WarpRaster, 3> kRasters{
    {{"vertices", WarpRaster::Vertices}, {"tessellate", WarpRaster::Tessellate}, {"exact", WarpRaster::Exact}}};

template <typename Value, std::size_t N>
std::optional<Value> named(const Names<Value, N>& names, std::string_view name)
{
    for (const auto& [known, value] : names)
        if (known == name) return value;
    return std::nullopt;
}

template <typename Value, std::size_t N>
std::string_view nameIn(const Names<Value, N>& names, Value value)
{
    for (const auto& [name, known] : names)
        if (known == value) return name;
    return "";
}

// max(distance, normal): a set of weights.
std::optional<std::uint8_t> readGreatest(const Word& word)
{
    std::uint8_t set = 0;
    for (const std::string_view name : word.arguments) {
        const auto weight = named(kWeights, name);
        if (!weight || (set & *weight)) return std::nullopt;
        set |= *weight;
    }
    return set == 0 ? std::nullopt : std::optional(set);
}

std::optional<Importance> readImportance(std::string_view text)
{
    Importance importance{false, 0, 0};
    const auto factors = split(text, '*');
    if (!factors) return std::nullopt;
    for (const std::string_view factor : *factors) {
        if (factor.empty()) return std::nullopt;
        const auto word = readWord(factor);
        if (!word) return std::nullopt;
        if (word->name == "max") {
            const auto set = readGreatest(*word);
            if (!set || importance.greatestOf) return std::nullopt;
            importance.greatestOf = *set;
            continue;
        }
        const auto weight = named(kWeights, factor);
        const bool isTwice = weight ? (importance.factors & *weight) != 0 : importance.isCounted;
        if (isTwice || (!weight && factor != "count")) return std::nullopt;
        if (weight) importance.factors |= *weight;
        else importance.isCounted = true;
    }
    return importance;
}

std::string nameOf(const Importance& importance)
{
    std::string text = importance.isCounted ? "count" : "", greatest;
    for (const auto& [name, weight] : kWeights) {
        if (importance.factors & weight) text += (text.empty() ? "" : "*") + std::string(name);
        if (importance.greatestOf & weight) greatest += (greatest.empty() ? "" : ",") + std::string(name);
    }
    if (!greatest.empty()) text += (text.empty() ? "max(" : "*max(") + greatest + ")";
    return text;
}

// 0.5, and 2/3 which no decimal is.
std::optional<double> readShare(std::string_view text)
{
    const std::size_t slash = text.find('/');
    const auto above = readNumber(text.substr(0, slash));
    const auto below = slash == std::string_view::npos ? std::optional(1.0) : readNumber(text.substr(slash + 1));
    if (!above || !below || !(*below > 0)) return std::nullopt;
    const double share = *above / *below;
    return share >= 0 && share <= 1 ? std::optional(share) : std::nullopt;
}

std::string nameOfShare(double share) { return share == 2.0 / 3 ? "2/3" : fmt::format("{}", share); }

// False where an argument is not understood.
bool takeShare(Arguments& arguments, std::string_view key, double& share)
{
    const auto text = arguments.take(key);
    if (!text) return true;
    const auto value = readShare(*text);
    if (value) share = *value;
    return value.has_value();
}

template <typename Value, std::size_t N>
bool takeNamed(Arguments& arguments, std::string_view key, const Names<Value, N>& names, Value& out)
{
    const auto text = arguments.take(key);
    if (!text) return true;
    const auto value = named(names, *text);
    if (value) out = *value;
    return value.has_value();
}

bool takeGrid(Arguments& arguments, int& grid)
{
    const auto text = arguments.take("grid");
    if (!text) return true;
    const auto value = readInteger(*text);
    if (!value || *value < 8 || *value > 1024) return false;
    grid = *value;
    return true;
}

std::string nameOf(const WarpOptions& o)
{
    return fmt::format("importance={},analysis={},power={},smooth={},floor={},grid={},raster={}", nameOf(o.importance),
                       nameIn(kAnalyses, o.analysis), nameOfShare(o.power), nameOfShare(o.smooth), nameOfShare(o.floor),
                       o.grid, nameIn(kRasters, o.raster));
}

} // namespace

std::optional<Expected<WarpChoice, std::string>> readWarp(const Word& word)
{
    const bool isNow = word.name == "now";
    if (!isNow && word.name != "rtw") return std::nullopt;
    Arguments arguments(word);
    RtwWarp rtw;
    NowWarp now;
    WarpOptions& options = isNow ? now.options : rtw.options;
    if (const auto text = arguments.take("importance")) {
        const auto importance = readImportance(*text);
        if (!importance) return Unexpected{std::string(kImportances)};
        options.importance = *importance;
    }
    const bool isUnderstood =
        takeNamed(arguments, "analysis", kAnalyses, options.analysis) && takeShare(arguments, "power", options.power) &&
        takeShare(arguments, "smooth", options.smooth) && takeShare(arguments, "floor", options.floor) &&
        takeGrid(arguments, options.grid) && takeNamed(arguments, "raster", kRasters, options.raster) &&
        (!isNow || takeNamed(arguments, "lines", kLines, now.lines)) && arguments.areAllTaken();
    if (!isUnderstood) return Unexpected{fmt::format("{} {}", word.name, kTakes)};
    if (options.importance.has(kShadowEdgesWeight) && options.analysis == Analysis::Backward)
        return Unexpected{std::string("importance=shadow-edges needs analysis=forward or hybrid")};
    return isNow ? WarpChoice(now) : WarpChoice(rtw);
}

std::optional<WarpRaster> rasterNamed(std::string_view name) { return named(kRasters, name); }
std::string_view nameOf(WarpRaster raster) { return nameIn(kRasters, raster); }

std::string nameOf(const WarpChoice& choice)
{
    if (const auto* rtw = std::get_if<RtwWarp>(&choice)) return fmt::format("rtw({})", nameOf(rtw->options));
    if (const auto* now = std::get_if<NowWarp>(&choice))
        return fmt::format("now({},lines={})", nameOf(now->options), nameIn(kLines, now->lines));
    return "";
}

} // namespace lixel
