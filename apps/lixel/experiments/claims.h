// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/reproduction.h"

#include <string_view>
#include <vector>

namespace lixel::app {

// What the papers claim in words and an experiment can settle: the sentence in short, what the experiment measured, and whether that
// bears it out. Claims whose numbers a run does not have (scenes that are not there, sizes of full runs) are left out. What other
// experiments, tests and studies settle, and what nothing can, stands in docs/claims.md, a row for every claim.
std::vector<ReproducedClaim> claimsOf(std::string_view experiment, const Reproduction& reproduction);

} // namespace lixel::app
