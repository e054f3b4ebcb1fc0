// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/expected.h"

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

// What a technique is (partition x fit x lookup, or one without a map), and its text form:
//
//   word(value, key=value, ...) joined by +, order free; word:a:b means word(a,b)
//
// Parts left out take their default: whole + focused + depths(1) + pcf(1).
namespace lixel {

// Partitions.
struct WholePartition
{
    friend bool operator==(const WholePartition&, const WholePartition&) = default;
};
using Partition = std::variant<WholePartition>;

// Fits.
struct UniformFit
{
    friend bool operator==(const UniformFit&, const UniformFit&) = default;
};
struct FocusedFit
{
    friend bool operator==(const FocusedFit&, const FocusedFit&) = default;
};
using FitChoice = std::variant<UniformFit, FocusedFit>;

// Stores and kernels.
struct DepthStore
{
    int depths = 1;
    friend bool operator==(const DepthStore&, const DepthStore&) = default;
};
struct PcfKernel
{
    int taps = 1; // k of the papers: 1, 4, 9, 16 or 25, a square grid one lixel apart
    friend bool operator==(const PcfKernel&, const PcfKernel&) = default;
};
using Store = std::variant<DepthStore>;
using Kernel = std::variant<PcfKernel>;

// A technique with a map.
struct MapTechnique
{
    Partition partition = WholePartition{};
    FitChoice fit = FocusedFit{};
    Store store = DepthStore{};
    Kernel kernel = PcfKernel{};
    friend bool operator==(const MapTechnique&, const MapTechnique&) = default;
};

// Techniques without one: a ray a view sample, or `samples` rays over the pixel's area.
struct ExactTechnique
{
    friend bool operator==(const ExactTechnique&, const ExactTechnique&) = default;
};
struct ExactAreaTechnique
{
    int samples = 64; // a square number
    friend bool operator==(const ExactAreaTechnique&, const ExactAreaTechnique&) = default;
};

using Technique = std::variant<MapTechnique, ExactTechnique, ExactAreaTechnique>;

// Says what is wrong in one line that quotes the text and names what is known.
Expected<Technique, std::string> parseTechnique(std::string_view text);

// The canonical form with every default; parses back to the same value.
std::string toString(const Technique& technique);

// A list as the command line takes it: split at commas outside parentheses only.
Expected<std::vector<std::string>, std::string> splitTechniques(std::string_view list);

// One row of what `lixel techniques` prints.
struct TechniqueWord
{
    std::string_view kind; // partition, fit, store, kernel, no map
    std::string_view form; // pcf(k)
    std::string_view meaning;
    std::string_view paper;
    std::string_view lights;   // those it serves
    std::string_view refusals; // when it says no
};
std::span<const TechniqueWord> techniqueWords();

} // namespace lixel
