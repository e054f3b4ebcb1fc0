// SPDX-License-Identifier: MIT
#include "experiments/claims.h"

#include "experiments/claims_of_papers.h"

namespace lixel::app {

std::vector<ReproducedClaim> claimsOf(std::string_view experiment, const Reproduction& reproduction)
{
    std::vector<ReproducedClaim> claims;
    addClaimsOfLixel(experiment, reproduction, claims);
    addClaimsOfMultipleDepth(experiment, reproduction, claims);
    addClaimsOfSceneOptimised(experiment, reproduction, claims);
    addClaimsOfNow(experiment, reproduction, claims);
    return claims;
}

} // namespace lixel::app
