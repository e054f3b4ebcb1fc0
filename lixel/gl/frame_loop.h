// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/box.h"
#include "lixel/base/plane.h"
#include "lixel/gl/executor.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace lixel {

// The frames of a renderer that moves, one after the other: each is planned from what earlier ones have observed, and drawn. All
// that a frame leaves to the next is here. Nothing of the picture's size is read back, and a loop whose sizes stay makes no OpenGL
// object once it has been planned from an observation.
//
//   H. Chong, S. Gortler. Scene Optimized Shadow Mapping. 2007, section 2.4
//
// Every `observeEvery`-th frame is observed, if the technique is made from observations: its samples and their lights, as its own
// maps have them, reach the plan of the frame kObservationAge + 1 later and those up to the next arrival. A technique that
// needs them starts as `focused`, until the first is there.
class FrameLoop
{
public:
    struct Options
    {
        MapTechnique technique;
        LixelSize lixels; // the budget of each light
        // Nothing: what the technique asks for, else every third frame and the usual grid.
        std::optional<int> observeEvery = {}; // frames
        std::optional<ObservationGrid> grid = {};
        // So many-th observations are of a frame drawn with a standard map (focused), which finds shadows that the technique's own
        // maps do not hold. Nothing: every fourth of techniques that leave receivers lit outside their maps, never of others,
        // whose else(...) sees all; 0: never.
        std::optional<int> standardEvery = {};
    };

    // Of one frame. A new origin or another number of lights starts the loop again; so should the host where the camera jumps.
    struct Subject
    {
        const CasterBuffers& seen;
        const CasterSource& casters;
        std::span<const Box> casterBoxesWorld;
        const View& view;
        std::span<const Light> lights;
        std::span<const NamedPlane> planes = {};
    };

    // The executor outlives the loop and advances no other one.
    FrameLoop(GlExecutor& executor, Options options);

    // Plans and draws; the picture stays on the device. `passes`: where given, each is timed, which disturbs the frame.
    void draw(const Subject& subject, std::vector<FrameTimes::Pass>* passes = nullptr);

    const FramePlan& plan() const { return plan_; } // of the last frame
    double planMs() const { return planMs_; }       // that it took

    // What the last frame was planned from, its age counted to that frame; null where that was nothing.
    const Observation* observed() const { return hasObservation_ ? &observation_ : nullptr; }

    bool observes() const { return observes_; } // whether the technique is made from observations
    void restart();

private:
    void planFrame(const Subject& subject);
    bool isObserved() const { return observes_ && frame_ % *options_.observeEvery == 0; }
    bool isStandard() const;
    bool isStarting(const Subject& subject) const;

    GlExecutor& executor_;
    Options options_;                             // complete
    MapTechnique start_;                          // until something is observed
    bool observes_ = false, needsLights_ = false; // of an observation: its samples, or also which lights reach them

    std::int64_t frame_ = 0; // since the loop began
    FitScratch scratch_;
    FramePlan plan_;
    double planMs_ = 0;
    Observation observation_, arrived_; // that plans are made from; that the next frame will be planned from
    bool hasObservation_ = false, hasArrived_ = false;
    std::vector<LightMemory> before_;
};

} // namespace lixel
