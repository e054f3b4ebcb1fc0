// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/expected.h"
#include "lixel/plan/technique_text.h"
#include "lixel/plan/warp/warp_choice.h"

#include <optional>
#include <string>
#include <string_view>

// rtw(...) and now(...) as techniques write them.
namespace lixel {

// What a word says, or what is wrong with it; nothing where it is no warp's.
std::optional<Expected<WarpChoice, std::string>> readWarp(const Word& word);

// raster= of warps and of paraboloids.
std::optional<WarpRaster> rasterNamed(std::string_view name);
std::string_view nameOf(WarpRaster raster);

// With every default; empty without a warp.
std::string nameOf(const WarpChoice& choice);

} // namespace lixel
