// SPDX-License-Identifier: MIT
#include "lixel/gl/executor_state.h"

#include "lixel/base/median.h"

#include <epoxy/gl.h>

#include <chrono>

namespace lixel {

FrameTimes GlExecutor::State::timesOf(int frames, const std::function<void()>& drawOne)
{
    LX_ASSERT(frames > 0);
    for (int i = 0; i < 2; ++i) drawOne();
    FrameTimes times;
    std::vector<double> wholeMs, gpuMs;
    for (int i = 0; i < frames; ++i) {
        glFinish();
        const auto began = std::chrono::steady_clock::now();
        drawOne();
        glFinish();
        wholeMs.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - began).count());
    }
    times.frameMs = median(wholeMs);

    std::vector<std::vector<double>> passMs;
    for (int i = 0; i < frames; ++i) {
        timer.start();
        drawOne();
        const std::vector<gl::PassTimer::Pass> passes = timer.stop();
        passMs.resize(passes.size());
        times.passes.resize(passes.size());
        gpuMs.push_back(0);
        for (std::size_t p = 0; p < passes.size(); ++p) {
            times.passes[p].name = passes[p].name;
            passMs[p].push_back(passes[p].ms);
            gpuMs.back() += passes[p].ms;
        }
    }
    for (std::size_t p = 0; p < passMs.size(); ++p) times.passes[p].ms = median(passMs[p]);
    if (!device.isSoftware()) times.gpuMs = median(gpuMs);
    times.clock = timer.clock();
    device.throwOnMessages("measuring");
    return times;
}

FrameTimes GlExecutor::measure(const Frame& frame, int frames)
{
    const bool isShaded = !frame.lights.empty();
    LX_ASSERT((!isShaded && !frame.observed) || frame.lights.size() == frame.plan.lights.size());
    state_->device.makeCurrent();
    FrameTimes times = state_->timesOf(frames, [&] {
        state_->inAtlas.forget();
        state_->drawFrame(frame, isShaded);
    });
    times.trianglesDrawn = state_->lightDepthPass.trianglesDrawn();
    times.trianglesCulled = state_->lightDepthPass.trianglesCulled();
    return times;
}

Expected<FrameTimes, VolumeFailure> GlExecutor::measureVolumes(const CasterBuffers& casters, const View& view,
                                                               std::span<const Light> lights, bool isShaded, int frames)
{
    if (const auto failure = gl::whyNoVolumes(casters, view)) return Unexpected{*failure};
    state_->device.makeCurrent();
    state_->volumeCasters.update(casters);
    return state_->timesOf(frames, [&] {
        state_->drawView(casters, view);
        state_->countVolumes(view, lights, state_->pixels, state_->visibilityOfPixels);
        if (!isShaded) return;
        gl::PassTimer::Scope scope(state_->timer, gl::ShadePass::kName);
        state_->shadePass.run(state_->seen, state_->targets, state_->pixels, state_->visibilityOfPixels, lights);
    });
}

} // namespace lixel
