// SPDX-License-Identifier: MIT
#pragma once

#include "comparison.h"
#include "experiment.h"
#include "loop_race.h"
#include "progress.h"

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// What the timed experiments of Chong and Gortler 2007 (section 3) share: frame loops in their scene, a few dozen objects on a
// floor with the viewer slightly above it, a picture of 1150x1150, and one to four lights. The paper names neither its lights
// nor its camera: here suns from all around, and a camera that walks along the scene's path for two seconds.
namespace lixel::app {

inline constexpr const char* kOptimal = "scene-optimal(metric=l2,search=paper,uncovered=lit)"; // the paper's
inline constexpr const char* kOurs = "scene-optimal";
inline constexpr const char* kFocused = "focused";
inline constexpr const char* kLispsm = "lispsm";

struct TimedLoop
{
    TechniqueChoice choice;
    LixelSize lixels; // of each light
};

// Suns at heights of about 20 to 60 degrees, from all around.
std::vector<Light> sunsAround(int count);

// The mean, and of the frames with the same number the largest.
struct TimeRatio
{
    double mean = 0, worst = 0;
};
TimeRatio timeRatio(const LoopTimes& of, const LoopTimes& over);
double mean(std::span<const double> values);

// Misclassified percent of some frames, all lights together.
using Judged = std::vector<double>; // [loop]

class LoopExperiment
{
public:
    // Throws UsageError: there is nothing to time on another executor than gl.
    LoopExperiment(const ExperimentOptions& options, std::size_t mostLoops);

    bool isQuick() const { return isQuick_; }
    // A map's side in the paper, or smaller with the picture where it is quick.
    LixelSize map(int side) const;
    static TimedLoop loop(const char* technique, LixelSize lixels);

    // To be told before the first step.
    int stepsOf(std::size_t loops, int passFrames) const { return race_.steps(loops, passFrames); }
    std::vector<LoopTimes> time(std::span<const TimedLoop> loops, std::span<const Light> lights, int passFrames,
                                Progress& progress);

    // Against exact visibility, as the loops drew them: `count` frames of the path, the last one among them. They become rows.
    Judged judge(std::span<const TimedLoop> loops, std::span<const LoopTimes> times, const std::vector<Light>& lights,
                 int count);

    ReadbackCost readbackOf(std::span<const Light> lights) const;

    // What the hull of the samples and the rectangle around it take for all lights, in milliseconds: a plan that looks for nothing
    // else, from as many samples as loops observe. Median.
    double hullMs(std::span<const Light> lights, LixelSize lixels) const;

    // Rows, parameters and the host; numbers are the caller's.
    Reproduction finished();

private:
    ResultRow rowOf(const ShotContext& context, const TimedLoop& loop, const LoopTimes& times, const FramePlan& plan,
                    std::size_t light, const Visibility& visibility) const;

    bool isQuick_;
    std::uint64_t seed_;
    PathShooting path_;
    Stage stage_;
    LoopRace race_;
    std::unique_ptr<Executor> executor_;
    std::vector<ResultRow> rows_;
};

} // namespace lixel::app
