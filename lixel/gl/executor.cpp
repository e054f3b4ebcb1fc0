// SPDX-License-Identifier: MIT
#include "lixel/gl/executor.h"

#include "lixel/gl/executor_state.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace lixel {
namespace {

std::size_t pixelOf(const ViewSamples& samples, std::size_t i)
{
    const int x = std::clamp(int(samples.pixel[i].x), 0, samples.width - 1);
    const int y = std::clamp(int(samples.pixel[i].y), 0, samples.height - 1);
    return std::size_t(y) * std::size_t(samples.width) + std::size_t(x);
}

// One value a pixel: the weighted mean of the samples in it, 1 where there is none and where `value` is empty.
std::vector<float> visibilityOfPixels(const ViewSamples& samples, std::span<const float> value)
{
    const std::size_t pixels = std::size_t(samples.width) * std::size_t(samples.height);
    std::vector<float> sum(pixels, 0), weight(pixels, 0);
    for (std::size_t i = 0; i < value.size(); ++i) {
        const std::size_t pixel = pixelOf(samples, i);
        sum[pixel] += samples.weightOf(i) * value[i];
        weight[pixel] += samples.weightOf(i);
    }
    for (std::size_t i = 0; i < pixels; ++i) sum[i] = weight[i] > 0 ? sum[i] / weight[i] : 1;
    return sum;
}

} // namespace

GlExecutor::GlExecutor(Context context)
    : state_(std::make_unique<State>(context == Context::Headless ? gl::Device::Context::Headless
                                                                  : gl::Device::Context::Current))
{
    state_->device.throwOnMessages("start");
}

GlExecutor::~GlExecutor() = default;
GlExecutor::GlExecutor(GlExecutor&&) noexcept = default;
GlExecutor& GlExecutor::operator=(GlExecutor&&) noexcept = default;

const std::string& GlExecutor::renderer() const { return state_->device.renderer(); }
bool GlExecutor::isSoftware() const { return state_->device.isSoftware(); }
std::uint64_t GlExecutor::mapsDrawn() const { return state_->mapsDrawn; }
std::uint64_t GlExecutor::plansPrepared() const { return state_->plansPrepared; }
void GlExecutor::forgetMaps() { state_->inAtlas.forget(); }

std::uint64_t GlExecutor::deviceBytes() const { return gl::bytesHeld(); }
std::size_t GlExecutor::warpBytes() const { return state_->lightDepthPass.warpBytes() + state_->warpFillPass.bytes(); }

void GlExecutor::finish()
{
    state_->device.makeCurrent();
    glFinish();
    state_->device.throwOnMessages("what was asked for");
}

ViewSamples GlExecutor::viewSamples(const CasterBuffers& casters, const View& view)
{
    state_->device.makeCurrent();
    state_->needView(casters, view);
    ViewSamples samples = state_->pixels.download();
    state_->device.throwOnMessages("the view");
    return samples;
}

std::vector<Visibility> GlExecutor::run(const FramePlan& plan, const CasterSource& casters, const ViewSamples& samples)
{
    state_->device.makeCurrent();
    state_->drawMaps(plan, casters);
    state_->samples.upload(samples);
    state_->lookUp(plan, state_->samples, state_->visibilityOfSamples);
    std::vector<Visibility> visibility = state_->visibilityOfSamples.download();
    state_->device.throwOnMessages("the shadow maps and their lookup");
    return visibility;
}

std::vector<Image<float>> GlExecutor::drawMaps(const FramePlan& plan, const CasterSource& casters)
{
    state_->device.makeCurrent();
    state_->drawMaps(plan, casters);
    std::vector<Image<float>> maps = state_->atlas.download(plan.layers);
    state_->device.throwOnMessages("the shadow maps");
    return maps;
}

std::vector<Image<Vec4f>> GlExecutor::drawPositions(const FramePlan& plan, const CasterBuffers& casters)
{
    state_->device.makeCurrent();
    if (!state_->positions) state_->positions.emplace(state_->device);
    state_->tables.upload(plan);
    state_->casting.update(casters);
    state_->positions->run(state_->device, plan, state_->tables, state_->casting);
    std::vector<Image<Vec4f>> positions = state_->positions->download(plan.layers);
    state_->device.throwOnMessages("positions in shadow maps");
    return positions;
}

std::uint32_t GlExecutor::drawAtlas(const FramePlan& plan, const CasterSource& casters)
{
    state_->device.makeCurrent();
    state_->drawMaps(plan, casters);
    state_->device.throwOnMessages("the shadow maps");
    return state_->atlas.depth.name();
}

Image<Rgba8> GlExecutor::shade(const CasterBuffers& casters, const View& view, std::span<const Light> lights,
                               const ViewSamples& samples, std::span<const Visibility> visibility)
{
    LX_ASSERT(visibility.size() == lights.size() && samples.width == view.width && samples.height == view.height);
    state_->device.makeCurrent();
    state_->needView(casters, view);
    std::vector<std::vector<float>> values;
    for (const Visibility& light : visibility) values.push_back(visibilityOfPixels(samples, light.value));
    state_->visibilityOfPixels.resize(state_->pixels, lights.size());
    state_->visibilityOfPixels.upload(values);
    state_->shadePass.run(state_->seen, state_->targets, state_->pixels, state_->visibilityOfPixels, lights);
    Image<Rgba8> picture = state_->shadePass.download();
    state_->device.throwOnMessages("shading");
    return picture;
}

Image<Rgba8> GlExecutor::render(const Frame& frame)
{
    LX_ASSERT(frame.lights.size() == frame.plan.lights.size());
    state_->device.makeCurrent();
    state_->drawFrame(frame, true);
    Image<Rgba8> picture = state_->shadePass.download();
    state_->device.throwOnMessages("a frame");
    return picture;
}

Observation GlExecutor::observe(const CasterBuffers& casters, const View& view, ObservationGrid grid)
{
    state_->device.makeCurrent();
    state_->needView(casters, view);
    state_->visibilityOfPixels.resize(state_->pixels, 0);
    state_->sample({}, grid);
    return state_->observedNow(grid);
}

Observation GlExecutor::observe(const Frame& frame)
{
    LX_ASSERT(frame.lights.size() == frame.plan.lights.size());
    const ObservationGrid grid = frame.observed.value_or(ObservationGrid{});
    state_->device.makeCurrent();
    state_->needView(frame.seen, frame.view);
    state_->drawMaps(frame);
    state_->lookUp(frame.plan, state_->pixels, state_->visibilityOfPixels);
    state_->sample(frame.lights, grid);
    return state_->observedNow(grid);
}

bool GlExecutor::advance(const Frame& frame, Observation& observation, std::vector<FrameTimes::Pass>* passes)
{
    LX_ASSERT(frame.lights.size() == frame.plan.lights.size());
    state_->device.makeCurrent();
    if (passes) state_->timer.start();
    state_->drawFrame(frame, true);
    const bool isThere = state_->readBack(frame.observed, observation);
    if (passes) {
        passes->clear();
        for (const gl::PassTimer::Pass& pass : state_->timer.stop()) passes->push_back({pass.name, pass.ms});
    }
    state_->device.throwOnMessages("a frame");
    return isThere;
}

void GlExecutor::restart()
{
    state_->device.makeCurrent();
    state_->earlierFrame.clear();
}

const char* GlExecutor::passClock() const { return state_->timer.clock(); }

std::uint64_t GlExecutor::readbackWaits() const { return state_->earlierFrame.waits(); }

Expected<std::vector<Visibility>, VolumeFailure> GlExecutor::shadowVolumes(const CasterBuffers& casters,
                                                                           const View& view,
                                                                           std::span<const Light> lights,
                                                                           const ViewSamples& samples)
{
    LX_ASSERT(samples.width == view.width && samples.height == view.height);
    if (const auto failure = gl::whyNoVolumes(casters, view)) return Unexpected{*failure};
    state_->device.makeCurrent();
    state_->volumeCasters.update(casters);
    state_->samples.uploadToPixels(samples);
    state_->countVolumes(view, lights, state_->samples, state_->visibilityOfSamples);
    std::vector<Visibility> visibility = state_->visibilityOfSamples.download();
    for (Visibility& light : visibility) {
        Visibility ofSamples{std::vector<float>(samples.size()), std::vector<std::uint8_t>(samples.size(), 0)};
        for (std::size_t i = 0; i < samples.size(); ++i) ofSamples.value[i] = light.value[pixelOf(samples, i)];
        light = std::move(ofSamples);
    }
    state_->device.throwOnMessages("shadow volumes");
    return visibility;
}

} // namespace lixel
