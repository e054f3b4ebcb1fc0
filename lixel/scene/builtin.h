// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/scene.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// Scenes without a file: procedural, deterministic, scalable.
namespace lixel {

struct BuiltinParameter
{
    std::string_view name; // as typed: bunnies(count=5)
    double standard, least, most;
    std::string_view meaning;
};

struct BuiltinScene
{
    std::string_view name;
    std::string_view description;
    std::span<const BuiltinParameter> parameters;
    Scene (*build)(std::span<const double> values); // one value a parameter, within its bounds
};

std::span<const BuiltinScene> builtinScenes();

// From "bunnies", "bunnies(count=12)" or "bunnies(12)", or "bunnies:12" that a shell needs no quotes for; throws InputError
// that names what is known. Nothing where the word names no built-in.
std::optional<Scene> buildBuiltin(std::string_view text);

} // namespace lixel
