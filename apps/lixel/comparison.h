// SPDX-License-Identifier: MIT
#pragma once

#include "executor.h"
#include "lixel/judge/score.h"
#include "lixel/plan/technique.h"
#include "picture_options.h"
#include "progress.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

// Techniques against exact visibility of the same view samples.
namespace lixel::app {

struct TechniqueChoice
{
    std::string typed;
    Technique technique;
};

// Throws UsageError.
std::vector<TechniqueChoice> readTechniques(const std::string& list);

struct ComparisonOptions
{
    std::vector<TechniqueChoice> techniques;
    LixelSize lixels{512, 512};
    int timingFrames = 5;           // 0: no times
    std::filesystem::path pictures; // folder for PNGs; empty: none
};

// Exact visibility of one shot and what follows from it.
struct Truth
{
    std::vector<std::vector<float>> exact; // [light][sample]
    std::vector<std::vector<Zone>> zones;  // [light][sample]
};
Truth findTruth(const Stage& stage, const ViewSamples& samples, std::span<const Light> lights);

// All rows of one shot: techniques x lights x executors. The first executor provides the view samples; with two, rows carry
// their agreement.
std::vector<ResultRow> compareShot(const Shooting& shooting, const Shot& shot, const Stage& stage, const View& view,
                                   std::span<const std::unique_ptr<Executor>> executors,
                                   const ComparisonOptions& options,
                                   const std::function<void(std::string_view)>& onStep);

// Steps that compareShot() reports.
int stepsPerShot(std::size_t executors, const ComparisonOptions& options);

} // namespace lixel::app
