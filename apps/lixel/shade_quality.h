// SPDX-License-Identifier: MIT
#pragma once

#include "comparison.h"
#include "lixel/judge/shades.h"

#include <vector>

// How good partial shadows are, against the two truths that they may stand for.
namespace lixel::app {

inline constexpr int kAreaRays = 64; // a pixel

// One a light, of every `step`-th sample of the edge band.
std::vector<PartialTruth> findPartialTruth(const Stage& stage, const View& view, const ViewSamples& samples,
                                           std::span<const Light> lights, const Truth& truth, std::size_t step = 1);

std::vector<float> valuesOf(std::span<const float> values, std::span<const std::size_t> which);

// Of one row; `plan` is planFor() of its technique, or null.
ShadeQuality shadeQuality(const ShotContext& context, const Visibility& visibility, const FramePlan* plan,
                          std::size_t light);

} // namespace lixel::app
