// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

namespace lixel {

// The words of paper:NAME, a technique as its paper has it; nothing where no paper is known by the name.
std::optional<std::string_view> presetNamed(std::string_view name);

} // namespace lixel
