// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/results.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lixel {

// How far the lixels of plane-optimal maps are from the pixels that see the same points of their plane: what `lixel study
// one-to-one` measures.
struct OneToOne
{
    // One way of measuring: in double, or what the device has drawn.
    struct Deviations
    {
        std::vector<double> worstPixels; // of each configuration that was measured
        std::int64_t points = 0;
    };
    // What the configuration was made with that is farthest off, and how far it is.
    struct Worst
    {
        std::map<std::string, double> parameters; // with their units in their names
        std::string light;                        // directional, spot, point
        double deviationPixels = 0;
    };

    std::string lixelVersion, command;
    std::uint64_t seed = 0;
    int configurations = 0;
    std::map<std::string, int> refused; // by the refusal's name
    Deviations inDouble;
    std::optional<Deviations> onDevice; // nothing: not measured, for the reason
    std::string whyNotOnDevice;
    std::optional<Worst> worstInDouble, worstOnDevice;
    RunTiming timing;
};

// docs/one-to-one.schema.json describes it.
std::string toJson(const OneToOne& study);

} // namespace lixel
