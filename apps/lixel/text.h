// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/vec.h"
#include "lixel/plan/shadow_plan.h"

#include <string>
#include <string_view>

// The forms that options come in. All throw UsageError, one line that names the option.
namespace lixel::app {

// "1024x768"; each side from 1 to `most`.
LixelSize readSize(std::string_view text, std::string_view option, int most);

// "1,2.5,-3".
Vec3d readVec3(std::string_view text, std::string_view option);

std::string toString(LixelSize size);

// Letters, digits and dashes only, for file names.
std::string slug(std::string_view text);

// The command line again, quoted for a POSIX shell.
std::string quoted(int argc, const char* const* argv);

} // namespace lixel::app
