// SPDX-License-Identifier: MIT
#pragma once

#include "executor.h"
#include "lixel/judge/score.h"
#include "lixel/plan/fit/need_sample.h"
#include "shadows.h"

#include <cstdint>
#include <optional>
#include <vector>

// One light of a picture alone: its truth, what the frame before tells of it, and how wrong maps of it are.
namespace lixel::app {

// What all lights of the picture share. Outlives them, as do shooting and executor it.
struct StudiedPicture
{
    StudiedPicture(const Shooting& of, const Shot& shot, Executor& by);

    const Shooting& shooting;
    Executor& executor;
    Stage stage;
    View view;
    ViewSamples samples;
};

class OneLight
{
public:
    OneLight(const StudiedPicture& picture, const Light& light);

    const Light& light() const { return lights_.front(); }
    std::int64_t lightFacing() const; // samples

    // The frame before: this one, drawn with `focused` of that size, which is in no budget.
    void drawLastFrame(LixelSize lixels);

    // What is known of it, observed by that grid. Needs drawLastFrame().
    PlanMemory lastFrame(ObservationGrid grid = {}) const;

    // Of every pixel near a shadow boundary, by exact visibility; none where no shadow ends in view.
    std::vector<NeedSample> boundary() const;

    // Refused or not. The technique has a map.
    FramePlan plan(const TechniqueChoice& choice, LixelSize lixels, const PlanMemory& known) const;

    // Against exact visibility. The plan is not refused.
    Score score(const FramePlan& plan) const;

    // Both; nothing where the plan is refused.
    std::optional<Score> score(const TechniqueChoice& choice, LixelSize lixels, const PlanMemory& known) const;

private:
    const StudiedPicture& picture_;
    std::vector<Light> lights_; // the one
    std::vector<float> exact_;
    std::vector<Zone> zones_;
    std::vector<Visibility> before_;
};

} // namespace lixel::app
