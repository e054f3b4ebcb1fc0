// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/technique.h"
#include "lixel/plan/technique_text.h"

#include <optional>
#include <string>

// Techniques without a map as text: exact, exact-area(64), exact-filtered(focused+pcf(9),rays=256).
namespace lixel {

// Reads such a word: an empty string, what is wrong with it, or nothing where it is another kind of word.
std::optional<std::string> takeExact(const Word& word, std::optional<Technique>& technique);

} // namespace lixel
