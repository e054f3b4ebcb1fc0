// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/results.h"

#include <string>

#include <nlohmann/json.hpp>

// What all JSON that is written has in common: bytes that are not UTF-8 become the replacement character.
namespace lixel {

std::string documentOf(const nlohmann::json& json); // a value a line, closed by a line break
std::string inOneLine(const nlohmann::json& json);

nlohmann::json toJson(const RunTiming& timing);

// What studies' documents have in common, as far as this one has it; each adds what it has found.
template <typename Study>
nlohmann::json studyHead(int version, const char* name, const Study& study)
{
    nlohmann::json head = {{"version", version},
                           {"study", name},
                           {"lixel_version", study.lixelVersion},
                           {"command", study.command},
                           {"timing", toJson(study.timing)}};
    if constexpr (requires { study.seed; }) head["seed"] = study.seed;
    if constexpr (requires { study.scene; }) head["scene"] = study.scene;
    if constexpr (requires { study.view; }) head["view"] = study.view;
    if constexpr (requires { study.size; }) head["size"] = study.size;
    if constexpr (requires { study.lixels; }) head["lixels"] = study.lixels;
    if constexpr (requires { study.executor; }) head["executor"] = study.executor;
    if constexpr (requires { study.lights; }) head["lights"] = study.lights;
    return head;
}

} // namespace lixel
