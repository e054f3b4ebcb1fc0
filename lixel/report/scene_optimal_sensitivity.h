// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/results.h"

#include <cstdint>
#include <string>
#include <vector>

namespace lixel {

// How errors change with each parameter of scene-optimal: what `lixel study scene-optimal-sensitivity` measures.
struct SceneOptimalSensitivity
{
    // A value of one parameter, all others as in the technique that the curve is of.
    struct Point
    {
        std::string value;
        bool isOwn = false;                            // what that technique has
        std::int64_t misclassified = 0, ofFocused = 0; // summed over the same lights
        int lights = 0;                                // that the map was not refused for

        double ratio() const { return ofFocused > 0 ? double(misclassified) / double(ofFocused) : 1; }
    };
    struct Curve
    {
        std::string parameter, technique;
        std::vector<Point> points;
    };

    std::string lixelVersion, command, scene, view, size, lixels, executor;
    std::uint64_t seed = 0;
    int lights = 0;
    std::vector<Curve> curves;
    RunTiming timing;
};

// docs/scene-optimal-sensitivity.schema.json describes it.
std::string toJson(const SceneOptimalSensitivity& study);

} // namespace lixel
