// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/results.h"

#include <string>
#include <vector>

namespace lixel {

// How error falls with the lixels of a light: what `lixel study plane-budget` measures.
struct PlaneBudget
{
    struct Point
    {
        std::string budget;    // as it was asked for: "512x512"
        double lixelsUsed = 0; // mean over the views
        SampleCount count;     // sums over the views
    };
    // Of one technique in one scene, from the smallest budget; of samples on the scene's planes of interest, or of all others.
    struct Curve
    {
        std::string scene, technique;
        bool isOnPlanes = false;
        std::vector<Point> points;
    };

    std::string question;
    bool isQuick = false;
    std::vector<Curve> curves;
    int leftOut = 0; // views and lights that some technique refused: their rows are in no curve
    RunResults run;  // what the curves were made from
};

// JSON as toJson(RunResults) writes it, with `study` beside `results`.
std::string toJson(const PlaneBudget& study);

} // namespace lixel
