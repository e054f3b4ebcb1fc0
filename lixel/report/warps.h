// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/results.h"

#include <cstdint>
#include <string>
#include <vector>

namespace lixel {

// How errors change with each parameter of texture warps, and how evenly they spread samples: what `lixel study warps` measures.
struct WarpStudy
{
    // A technique, over all pictures and lights of the scene; sums and means are over those where it and `focused` have maps.
    struct Row
    {
        std::string curve, value; // the parameter that changes along a curve, and what it is here
        std::string technique;    // as it would be typed
        bool isOwn = false;       // what the curve's technique has without further words
        int lights = 0;           // it was not refused for; a light of a view each
        std::int64_t misclassified = 0;
        double percent = 0;         // mean of the misclassified percent of each
        double ratioToFocused = 0;  // geometric mean over those that focused has errors in
        double usedShare = 0;       // mean share of its lixels that serve a sample
        double countVariation = 0;  // mean coefficient of variation of the samples that lixels serve
        std::int64_t knotBytes = 0; // of the warps of a light, at most
    };

    std::string lixelVersion, command, scene, size, lixels, executor;
    std::vector<Row> rows;
    RunTiming timing;
};

// docs/warps.schema.json describes it.
std::string toJson(const WarpStudy& study);

} // namespace lixel
