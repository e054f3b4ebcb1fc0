// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/reproduction.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace lixel::app {

struct ExperimentOptions
{
    bool isQuick = false;
    std::uint64_t seed = 2007;
    std::string executor; // "gl" or "trace"
    // In place of the experiment's own; only for those with many lights in one view.
    std::optional<int> lights;
    std::optional<std::string> size, lixels;
    std::filesystem::path pictures; // folder for PNGs; empty: none
    std::filesystem::path scenes;   // folder with files that some experiments want; empty: those go without
};

// One experiment of a paper. Its run gives parameters, numbers, figures and rows; name, paper and question are filled in from here.
struct Experiment
{
    std::string name, paper, question;
    const char* executor;    // where nothing else is asked for
    bool isOfLights = false; // many of them in one view
    Reproduction (*run)(const ExperimentOptions& options);
};

std::span<const Experiment> experiments();

// Their runs, one file each.
Reproduction reproduceNormalAgainstFocused(const ExperimentOptions& options);
Reproduction reproduceLixelFig7(const ExperimentOptions& options);
Reproduction reproduceSceneOptimisedTable1(const ExperimentOptions& options);
Reproduction reproduceSceneOptimisedTable2(const ExperimentOptions& options);
Reproduction reproduceSceneOptimisedTable3(const ExperimentOptions& options);
Reproduction reproduceMultipleDepthTable1(const ExperimentOptions& options);
Reproduction reproduceMultipleDepthFigures(const ExperimentOptions& options);
Reproduction reproduceMultipleDepthCost(const ExperimentOptions& options);
Reproduction reproduceNowTable1(const ExperimentOptions& options);
Reproduction reproduceNowTable2(const ExperimentOptions& options);
Reproduction reproduceNowTable3(const ExperimentOptions& options);
Reproduction reproduceNowFigures(const ExperimentOptions& options);

} // namespace lixel::app
