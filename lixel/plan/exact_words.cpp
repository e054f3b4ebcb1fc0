// SPDX-License-Identifier: MIT
#include "lixel/plan/exact_words.h"

#include "lixel/plan/lookup/lookup.h"

#include <cmath>

#include <fmt/format.h>

namespace lixel {
namespace {

constexpr int kMostRays = 1024;

// A square number of rays.
std::optional<int> readRays(std::string_view text)
{
    const auto n = readInteger(text);
    if (!n || *n < 1 || *n > kMostRays) return std::nullopt;
    const int root = int(std::lround(std::sqrt(double(*n))));
    return root * root == *n ? n : std::nullopt;
}

std::string takeArea(const Word& word, Technique& technique)
{
    Arguments arguments(word);
    const auto text = arguments.take("n", true);
    const auto n = text ? readRays(*text) : std::optional(ExactAreaTechnique{}.samples);
    if (!n || (!text && !word.arguments.empty()) || !arguments.areAllTaken())
        return "exact-area(n) takes a square number n from 1 to 1024";
    technique = ExactAreaTechnique{*n};
    return "";
}

bool isExactFiltered(std::string_view text)
{
    const auto pieces = split(text, '+');
    for (const std::string_view piece : pieces.value_or(std::vector<std::string_view>{})) {
        const auto word = piece.empty() ? std::nullopt : readWord(piece);
        if (word && word->name == "exact-filtered") return true;
    }
    return false;
}

std::string takeFiltered(const Word& word, Technique& technique)
{
    Arguments arguments(word);
    ExactFilteredTechnique exact;
    if (const auto text = arguments.take("rays")) {
        const auto rays = readRays(*text);
        if (!rays) return "exact-filtered takes rays = a square number from 1 to 1024";
        exact.rays = *rays;
    }
    if (arguments.rest().size() > 1) return "exact-filtered takes one technique with a map, and rays=";
    if (!arguments.rest().empty()) {
        const std::string_view text = arguments.rest().front();
        if (isExactFiltered(text)) return "exact-filtered takes a technique with a map, not another exact one";
        const auto inside = parseTechnique(text);
        if (!inside) return inside.error();
        const auto* map = std::get_if<MapTechnique>(&*inside);
        if (!map) return fmt::format("exact-filtered takes a technique with a map: \"{}\" has no filter", text);
        exact.filtered = *map;
    }
    if (const std::string_view why = whyNoShare(lookupLayout(exact.filtered)); !why.empty())
        return fmt::format("exact-filtered: {}", why);
    technique = exact;
    return "";
}

} // namespace

std::optional<std::string> takeExact(const Word& word, std::optional<Technique>& technique)
{
    if (word.name != "exact" && word.name != "exact-area" && word.name != "exact-filtered") return std::nullopt;
    if (technique) return "more than one technique without a map";
    Technique found = ExactTechnique{};
    std::string wrong;
    if (word.name == "exact" && !word.arguments.empty()) wrong = "\"exact\" takes no arguments";
    if (word.name == "exact-area") wrong = takeArea(word, found);
    if (word.name == "exact-filtered") wrong = takeFiltered(word, found);
    if (wrong.empty()) technique = found;
    return wrong;
}

} // namespace lixel
