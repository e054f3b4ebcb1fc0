// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/results.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lixel {

// Every lookup's errors against what it takes: what `lixel study lookups` measures, over the views and lights of the built-in scenes
// that no lookup refuses, equally many samples of each.
struct LookupStudy
{
    // Of frames that draw their maps anew, over those with one depth and one tap; geometric means over pictures.
    struct Times
    {
        double frameRatio = 0;
        double passRatio = 0;               // of preparing and looking up, over looking up
        double prepareMs = 0, lookupMs = 0; // means
    };
    struct Lookup
    {
        std::string lookup, techniqueFull;
        int bytesPerLixel = 0,
            bytesReadPerLixel = 0; // of all its textures, and of those that are read when it is looked up
        int lights = 0;            // a light of a view each
        std::int64_t misclassified = 0;
        double misclassifiedPercent = 0; // mean over lights
        double ratioToNearest = 0;       // geometric mean over those that nearest has errors in
        std::int64_t shades = 0;         // at most in one
        double transitionPixels = 0;     // median: a lamp at the eye has next to no boundary to share transitions among
        double bleedingPercent = 0;      // mean light of dark interior samples, of all lights together
        SampleCount darkInterior;        // these, and those that are lit when rounded
        double areaRmse = 0;             // root of the mean square over lights
        double areaLargest = 0;
        std::optional<double> filterLixels, filteredRmse, filteredLargest;
        std::optional<Times> times;
    };
    // Lookups that none beats, from the cheapest on.
    struct Front
    {
        std::string error, cost; // names of columns
        std::vector<std::string> lookups;
    };

    std::string question;
    bool isQuick = false;
    int leftOut = 0; // views and lights that some lookup is refused for
    std::vector<Lookup> lookups;
    std::vector<Front> fronts, frontsOfTimes; // against bytes, against times
    RunResults run;                           // what they were made from
};

// JSON as toJson(RunResults) writes it, with `study` beside `results`.
std::string toJson(const LookupStudy& study);

} // namespace lixel
