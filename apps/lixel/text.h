// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/vec.h"
#include "lixel/plan/shadow_plan.h"

#include <set>
#include <string>
#include <string_view>
#include <vector>

// The forms that options come in. All throw UsageError, one line that names the option.
namespace lixel::app {

// "1024x768"; each side from 1 to `most`.
LixelSize readSize(std::string_view text, std::string_view option, int most);

// Of each light: one size is the total. Several, split at commas, are those of the regions of techniques that have as many, in
// their order; others have as many lixels in all.
struct LixelBudget
{
    LixelSize total{512, 512};
    std::vector<LixelSize> ofRegions;
};
LixelBudget readBudget(std::string_view text, std::string_view option, int most);
std::string toString(const LixelBudget& budget);

// "0.5%" or "0.5"; above 0, up to 100.
double readPercent(std::string_view text, std::string_view option);

// "1,2.5,-3".
Vec3d readVec3(std::string_view text, std::string_view option);

std::string toString(LixelSize size);

// Letters, digits and dashes only, at most 60, for file names.
std::string slug(std::string_view text);

// Without control characters, for one line on a terminal.
std::string oneLine(std::string_view text);

// A name that may come from a file, for tables and channels: in one line, at most 64 bytes, and none of `taken`, which it joins.
std::string distinctName(std::string_view name, std::set<std::string>& taken);

// The command line again, quoted for a POSIX shell.
std::string quoted(int argc, const char* const* argv);

} // namespace lixel::app
