// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/light.h"
#include "lixel/base/view_samples.h"
#include "lixel/plan/shadow_plan.h"

namespace lixel::app {

// How a light's lixels serve the samples that face it (T. Milet et al. 2015, section 2.1: best would be as many for each).
struct Evenness
{
    double usedShare = 0;      // of all lixels: those that serve a sample
    double countVariation = 0; // standard deviation of the number of samples a lixel serves, over its mean
};

Evenness evennessOf(const ShadowPlan& plan, const ViewSamples& samples, const Light& light);

} // namespace lixel::app
