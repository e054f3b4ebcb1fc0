// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/technique.h"
#include "lixel/plan/technique_text.h"

#include <optional>
#include <string>

// Stores, kernels and refinements as text: depths(4,sorted)+pcf(9)+dual-plane.
namespace lixel {

struct LookupParts
{
    std::optional<Store> store;
    std::optional<Kernel> kernel;
    bool isDualPlane = false;

    bool any() const { return store || kernel || isDualPlane; }
};

// Reads a word of a lookup: an empty string, what is wrong with it, or nothing where it is another kind of word.
std::optional<std::string> takeLookup(const Word& word, LookupParts& parts);

// What does not go together, or an empty string.
std::string checkLookup(const MapTechnique& technique);

// The canonical text.
std::string nameOfLookup(const MapTechnique& technique);

} // namespace lixel
