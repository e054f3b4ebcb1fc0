// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/light.h"
#include "lixel/plan/shadow_plan.h"
#include "lixel/report/results.h"
#include "picture_options.h"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

// Frame loops of several techniques along one path. They take turns frame by frame, so that whatever drifts on the machine meets all
// of them alike, and ratios of their times mean something.
namespace lixel::app {

struct RacedLoop
{
    MapTechnique technique;
    LixelSize lixels; // of each light
};

// What one of them did.
struct LoopTimes
{
    std::vector<double> frameMs;  // of undisturbed frames: planned and drawn, from an idle device to an idle device
    std::vector<double> planMs;   // of these: planning alone
    std::vector<FramePlan> plans; // of these
    std::vector<PassTime>
        passes; // of frames apart, in which each pass is waited for: means over all, whether they had it or not
    std::string passClock;
};

class LoopRace
{
public:
    // `mostLoops` contexts are made, one for each loop that will run. Path and buffers outlive it. Throws gl::GraphicsError.
    LoopRace(const PathShooting& path, const SceneBuffers& buffers, std::size_t mostLoops);
    ~LoopRace();

    // The whole path, after frames that begin the loops; then backwards over `passFrames` of its last ones, pass by pass. All maps
    // are drawn in every frame, as where casters move.
    std::vector<LoopTimes> run(std::span<const RacedLoop> loops, std::span<const Light> lights, int passFrames,
                               const std::function<void()>& onFrame);

    // Steps that run() reports.
    int steps(std::size_t loops, int passFrames) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

// What it costs to observe a frame of these lights and to read that back: medians over `frames` frames.
struct ReadbackCost
{
    double sampleMs = 0, readbackMs = 0;
};
ReadbackCost readbackCost(const SceneBuffers& buffers, const View& view, std::span<const Light> lights, int frames);

} // namespace lixel::app
