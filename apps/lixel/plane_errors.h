// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/judge/on_planes.h"
#include "lixel/plan/shadow_plan.h"
#include "lixel/trace/trace_scene.h"

#include <optional>
#include <span>
#include <vector>

namespace lixel::app {

// One light of one shot by one technique. Spans have an entry a sample.
struct JudgedSamples
{
    const TraceScene& scene;
    const FramePlan& plan;
    std::size_t lightNumber;
    const Light& light;
    const ViewSamples& samples;
    std::span<const int> plane; // planeOfSamples()
    std::span<const Verdict> verdict;
    std::span<const float> exact;
};

// Why samples on planes are misclassified, plane by plane; nothing for planes without a map of a lixel a pixel.
std::vector<std::optional<PlaneErrorCauses>> causesOfPlaneErrors(const JudgedSamples& judged, std::size_t planes);

} // namespace lixel::app
