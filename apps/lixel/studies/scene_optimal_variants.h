// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/fit/scene_optimal.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lixel::app {

// scene-optimal with a parameter changed.
struct SceneOptimalVariant
{
    std::string value;
    bool isOwn = false; // nothing is changed
    SceneOptimalFit fit;
    std::optional<std::vector<double>> angles = {}; // of the descent; nothing: the paper's
};

struct SceneOptimalCurve
{
    std::string parameter, technique;
    std::vector<SceneOptimalVariant> variants;
};

// Of lixel's own choices, and of the paper's; single maps both.
std::vector<SceneOptimalCurve> sceneOptimalCurves();

} // namespace lixel::app
