// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/results.h"

#include <cstdint>
#include <string>
#include <vector>

namespace lixel {

// How near the light images that scene-optimal finds are to the best there are: what `lixel study scene-optimal-search` measures.
struct SceneOptimalSearch
{
    // Of one light and metric, energies by all samples.
    struct Case
    {
        std::string light, metric;
        double exhaustive = 0; // the best of very many axes
        double wide = 0, descent = 0;
        int samples = 0;
    };

    std::string lixelVersion, command, scene, view;
    std::uint64_t seed = 0;
    int lights = 0, leftOut = 0; // lights that nothing faces, or that throw no shadow in view
    int axes = 0, refined = 0;   // of the exhaustive search
    double share = 0.02;         // worse by this part at most counts as the best
    std::vector<Case> cases;
    RunTiming timing;
};

// Of the cases of a metric.
struct SearchQuality
{
    std::string metric;
    int cases = 0, withinShare = 0;
    double worstRatio = 0, meanRatio = 0; // energy against the exhaustive search's
};
std::vector<SearchQuality> searchQuality(const SceneOptimalSearch& study, double SceneOptimalSearch::Case::*search);

// docs/scene-optimal-search.schema.json describes it.
std::string toJson(const SceneOptimalSearch& study);

} // namespace lixel
