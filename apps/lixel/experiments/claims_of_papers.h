// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/reproduction.h"

#include <string_view>
#include <vector>

// What claimsOf() asks, a function and a file for each paper; of experiments of other papers they say nothing.
namespace lixel::app {

void addClaimsOfLixel(std::string_view experiment, const Reproduction& of, std::vector<ReproducedClaim>& to);
void addClaimsOfMultipleDepth(std::string_view experiment, const Reproduction& of, std::vector<ReproducedClaim>& to);
void addClaimsOfSceneOptimised(std::string_view experiment, const Reproduction& of, std::vector<ReproducedClaim>& to);
void addClaimsOfNow(std::string_view experiment, const Reproduction& of, std::vector<ReproducedClaim>& to);

} // namespace lixel::app
