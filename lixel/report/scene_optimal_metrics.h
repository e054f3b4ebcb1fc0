// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/results.h"

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lixel {

// Which metric predicts the measured error best: what `lixel study scene-optimal-metrics` measures.
struct SceneOptimalMetrics
{
    // One light by one technique's map.
    struct Case
    {
        std::string light, technique;
        std::int64_t misclassified = 0;
        std::int64_t boundarySamples = 0, unserved = 0; // the picture's samples at exact shadow boundaries
        std::map<std::string, double> meanEnergy;       // by metric; of the boundary's samples that are served
    };

    std::string lixelVersion, command, scene, view, size, lixels, executor;
    std::uint64_t seed = 0;
    int lights = 0;
    int leftOut = 0; // lights whose shadows have no edge in view
    std::vector<std::string> metrics, techniques;
    std::vector<Case> cases;
    RunTiming timing;
};

// Spearman's coefficients of what a metric says with what is measured.
struct MetricRanks
{
    std::string metric;

    // Energy against misclassified samples, both for each sample of the boundary, so that long edges are no merit: over the lights of each
    // technique, and over all cases.
    std::map<std::string, std::optional<double>> ofTechnique;
    std::optional<double> pooled;

    // Sums over the boundary against counts, over all cases.
    std::optional<double> pooledSums;

    // Among the techniques of one light: the mean over lights, and how often the one of least energy errs least.
    double withinLights = 0;
    int lightsRanked = 0, bestFound = 0;

    // Samples misclassified in the map of least energy over those in the light's best map, all lights.
    double lossOfChoice = 0;
};
std::vector<MetricRanks> metricRanks(const SceneOptimalMetrics& study);

// docs/scene-optimal-metrics.schema.json describes it.
std::string toJson(const SceneOptimalMetrics& study);

} // namespace lixel
