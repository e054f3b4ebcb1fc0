// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/technique.h"
#include "lixel/plan/technique_text.h"

#include <optional>
#include <string>

// dual-paraboloid(raster=...) as techniques write it.
namespace lixel {

// What a word says, or what is wrong with it; nothing where it is another one.
std::optional<Expected<DualParaboloidPartition, std::string>> readDualParaboloid(const Word& word);

// Of a technique with this partition: what does not go with it, in a sentence, or nothing.
std::string checkDualParaboloid(const MapTechnique& map);

} // namespace lixel
