// SPDX-License-Identifier: MIT
#include "lixel/plan/technique.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace lixel {
namespace {

constexpr std::array<TechniqueWord, 7> kWords{{
    {"partition", "whole", "one region: all of space", "", "all", ""},
    {"fit", "uniform", "the whole scene, whatever the view sees (the papers' \"normal\" map)", "Williams 1978",
     "directional, spot, point", "extent-not-in-hemisphere"},
    {"fit", "focused",
     "view frustum, scene bounds and the light's cone clipped against each other, in the rectangle of least area",
     "Brabec, Annen, Seidel 2002; Chong, Gortler 2007 (Focused)", "directional, spot, point",
     "extent-not-in-hemisphere, nothing-in-view"},
    {"store", "depths(n)", "n depths a lixel; n = 1", "Williams 1978", "all", ""},
    {"kernel", "pcf(k)", "k = 1, 4, 9, 16, 25 taps one lixel apart, results averaged", "Reeves, Salesin, Cook 1987",
     "all", ""},
    {"no map", "exact", "a ray for every view sample, decided in double precision", "", "all", ""},
    {"no map", "exact-area(n)", "share of the pixel's area that is lit; n = 1, 4, ..., 1024 rays a pixel", "", "all",
     ""},
}};

// One word with its arguments, as typed.
struct Word
{
    std::string_view name;
    std::vector<std::string_view> arguments;
};

std::string_view trimmed(std::string_view s)
{
    while (!s.empty() && s.front() == ' ') s.remove_prefix(1);
    while (!s.empty() && s.back() == ' ') s.remove_suffix(1);
    return s;
}

// Splits at `separator` outside parentheses; nothing where parentheses do not match.
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

// word(a, b) or word:a:b.
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

// `n = 4` and `4` alike; the only argument of the word, or its default where there is none.
std::optional<int> onlyInteger(const Word& word, std::string_view key, int standard)
{
    if (word.arguments.empty()) return standard;
    if (word.arguments.size() > 1) return std::nullopt;
    std::string_view text = word.arguments.front();
    if (const std::size_t equals = text.find('='); equals != std::string_view::npos) {
        if (trimmed(text.substr(0, equals)) != key) return std::nullopt;
        text = trimmed(text.substr(equals + 1));
    }
    return readInteger(text);
}

std::string knownWords()
{
    std::string names;
    for (const TechniqueWord& word : kWords) names += (names.empty() ? "" : ", ") + std::string(word.form);
    return names;
}

bool isSquare(int n)
{
    const int root = int(std::lround(std::sqrt(double(n))));
    return root * root == n;
}

// What one word sets; at most one of each kind.
struct Parts
{
    std::optional<Partition> partition;
    std::optional<FitChoice> fit;
    std::optional<Store> store;
    std::optional<Kernel> kernel;
    std::optional<Technique> noMap;

    bool anyOfMap() const { return partition || fit || store || kernel; }
};

template <typename Slot, typename Value>
std::string setOnce(Slot& slot, const Value& value, std::string_view kind)
{
    if (slot) return fmt::format("more than one {}", kind);
    slot = value;
    return "";
}

// An empty string, or what is wrong with the word.
std::string take(const Word& word, Parts& parts)
{
    const auto plain = [&](auto& slot, auto value, std::string_view kind) -> std::string {
        if (!word.arguments.empty()) return fmt::format("\"{}\" takes no arguments", word.name);
        return setOnce(slot, value, kind);
    };
    if (word.name == "whole") return plain(parts.partition, WholePartition{}, "partition");
    if (word.name == "uniform") return plain(parts.fit, UniformFit{}, "fit");
    if (word.name == "focused") return plain(parts.fit, FocusedFit{}, "fit");
    if (word.name == "exact") return plain(parts.noMap, Technique(ExactTechnique{}), "technique without a map");
    if (word.name == "depths") {
        const auto n = onlyInteger(word, "n", 1);
        if (!n || *n != 1) return "depths(n) takes n = 1";
        return setOnce(parts.store, DepthStore{*n}, "store");
    }
    if (word.name == "pcf") {
        const auto k = onlyInteger(word, "k", 9);
        if (!k || !isSquare(*k) || *k < 1 || *k > 25) return "pcf(k) takes k = 1, 4, 9, 16 or 25";
        return setOnce(parts.kernel, PcfKernel{*k}, "kernel");
    }
    if (word.name == "exact-area") {
        const auto n = onlyInteger(word, "n", 64);
        if (!n || *n < 1 || *n > 1024 || !isSquare(*n)) return "exact-area(n) takes a square number n from 1 to 1024";
        return setOnce(parts.noMap, Technique(ExactAreaTechnique{*n}), "technique without a map");
    }
    return fmt::format("\"{}\" is not known; known are {}", word.name, knownWords());
}

std::string name(const WholePartition&) { return "whole"; }
std::string name(const UniformFit&) { return "uniform"; }
std::string name(const FocusedFit&) { return "focused"; }
std::string name(const DepthStore& store) { return fmt::format("depths({})", store.depths); }
std::string name(const PcfKernel& kernel) { return fmt::format("pcf({})", kernel.taps); }
std::string name(const ExactTechnique&) { return "exact"; }
std::string name(const ExactAreaTechnique& area) { return fmt::format("exact-area({})", area.samples); }
std::string name(const MapTechnique& map)
{
    const auto nameOf = [](const auto& choice) { return std::visit([](const auto& c) { return name(c); }, choice); };
    return nameOf(map.partition) + "+" + nameOf(map.fit) + "+" + nameOf(map.store) + "+" + nameOf(map.kernel);
}

} // namespace

Expected<Technique, std::string> parseTechnique(std::string_view text)
{
    const auto fail = [&](const std::string& what) {
        return Unexpected{fmt::format("technique \"{}\": {}", text, what)};
    };
    const auto pieces = split(text, '+');
    if (!pieces) return fail("parentheses do not match");
    Parts parts;
    for (const std::string_view piece : *pieces) {
        if (piece.empty()) return fail("an empty word");
        const auto word = readWord(piece);
        if (!word) return fail(fmt::format("\"{}\" is not of the form word(value, ...)", piece));
        if (const std::string wrong = take(*word, parts); !wrong.empty()) return fail(wrong);
    }
    if (parts.noMap && parts.anyOfMap()) return fail("a technique without a map stands alone");
    if (parts.noMap) return *parts.noMap;
    MapTechnique technique;
    if (parts.partition) technique.partition = *parts.partition;
    if (parts.fit) technique.fit = *parts.fit;
    if (parts.store) technique.store = *parts.store;
    if (parts.kernel) technique.kernel = *parts.kernel;
    return Technique(technique);
}

std::string toString(const Technique& technique)
{
    return std::visit([](const auto& t) { return name(t); }, technique);
}

Expected<std::vector<std::string>, std::string> splitTechniques(std::string_view list)
{
    const auto parts = split(list, ',');
    if (!parts) return Unexpected{fmt::format("techniques \"{}\": parentheses do not match", list)};
    std::vector<std::string> out;
    for (const std::string_view part : *parts) {
        if (part.empty()) return Unexpected{fmt::format("techniques \"{}\": an empty entry", list)};
        out.emplace_back(part);
    }
    return out;
}

std::span<const TechniqueWord> techniqueWords() { return kWords; }

} // namespace lixel
