// SPDX-License-Identifier: MIT
#include "lixel/gl/frame_loop.h"

#include "lixel/base/assert.h"

#include <chrono>
#include <utility>

namespace lixel {
namespace {

constexpr int kObserveEvery = 3;  // frames
constexpr int kStandardEvery = 4; // observations

} // namespace

FrameLoop::FrameLoop(GlExecutor& executor, Options options) : executor_(executor), options_(std::move(options))
{
    const auto firstPass = firstPassOf(options_.technique, options_.lixels);
    needsLights_ = firstPass.has_value();
    const SceneOptimalFit* const sceneOptimal = sceneOptimalOf(options_.technique);
    if (!options_.observeEvery) options_.observeEvery = sceneOptimal ? sceneOptimal->update : kObserveEvery;
    if (!options_.grid) options_.grid = firstPass ? firstPass->grid : ObservationGrid{};
    if (!options_.standardEvery)
        options_.standardEvery = sceneOptimal && sceneOptimal->uncoveredIsLit ? kStandardEvery : 0;
    LX_ASSERT(*options_.observeEvery > 0 && *options_.standardEvery >= 0);
    observes_ = needsLights_ || needsViewSamples(options_.technique);
    start_.store = options_.technique.store;
    start_.kernel = options_.technique.kernel;
    start_.isDualPlane = options_.technique.isDualPlane;
    executor_.restart();
}

void FrameLoop::restart()
{
    executor_.restart();
    frame_ = 0;
    hasObservation_ = hasArrived_ = false;
    before_.clear();
}

// What is remembered is of lights by their number, and counted from the origin.
bool FrameLoop::isStarting(const Subject& subject) const
{
    return frame_ == 0 || subject.seen.originWorld != plan_.originWorld || subject.lights.size() != plan_.lights.size();
}

bool FrameLoop::isStandard() const
{
    if (!observes_) return false;
    if (!hasObservation_) return true;
    return *options_.standardEvery > 0 && isObserved() &&
           frame_ / *options_.observeEvery % *options_.standardEvery == 0;
}

void FrameLoop::planFrame(const Subject& subject)
{
    const auto began = std::chrono::steady_clock::now();
    if (std::exchange(hasArrived_, false)) {
        std::swap(observation_, arrived_);
        hasObservation_ = true;
    }
    const bool isStandardFrame = isStandard();
    PlanInput input{subject.view,
                    subject.lights,
                    subject.casterBoxesWorld,
                    subject.seen.originWorld,
                    isStandardFrame ? start_ : options_.technique,
                    options_.lixels};
    input.planes = subject.planes;
    input.before = before_;
    if (hasObservation_) {
        ++observation_.ageFrames; // was counted to the frame before
        // Shares of regions by the shadows of their own maps would never rest, though nothing moves.
        if (needsLights_) input.observed = &observation_;
        input.seen = &observation_.samples;
    }
    plan_ = planShadows(input, scratch_, std::move(plan_));
    if (!isStandardFrame) before_ = rememberedBy(plan_); // standard maps are not what the technique would keep
    planMs_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - began).count();
}

void FrameLoop::draw(const Subject& subject, std::vector<FrameTimes::Pass>* passes)
{
    if (isStarting(subject)) restart();
    planFrame(subject);
    GlExecutor::Frame frame{subject.seen, subject.casters, subject.view, plan_, subject.lights};
    if (isObserved()) frame.observed = options_.grid;
    hasArrived_ = executor_.advance(frame, arrived_, passes);
    ++frame_;
}

} // namespace lixel
