// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/results.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lixel {

// The smallest maps of a scene's lights for errors under a tolerance: what `lixel study resolution` measures.
struct ResolutionStudy
{
    struct Row
    {
        std::string view, light, technique;
        std::string refused;                     // why there is no map of any size; empty where there is
        int sideByMetric = 0, sidePredicted = 0; // without a measured map, from two of them
        std::optional<int> side;                 // nothing: not even the largest map
        double misclassifiedPercent = 0;         // there, or in the largest map
        std::int64_t lixels = 0;                 // there; 0 without a side
        int sidesMeasured = 0;
    };

    std::string lixelVersion, command, scene, size, executor;
    double tolerancePercent = 0;
    int largestSide = 0;
    std::vector<Row> rows; // the technique's and focused's of a light follow each other
    RunTiming timing;
};

// docs/resolution.schema.json describes it.
std::string toJson(const ResolutionStudy& study);

} // namespace lixel
