// SPDX-License-Identifier: MIT
#include "lixel/gl/executor.h"

#include "lixel/base/assert.h"
#include "lixel/gl/device/device.h"
#include "lixel/gl/device/pass_timer.h"
#include "lixel/gl/passes/drawn_maps.h"
#include "lixel/gl/passes/drawn_positions.h"
#include "lixel/gl/passes/gather_pass.h"
#include "lixel/gl/passes/light_depth_pass.h"
#include "lixel/gl/passes/lookup_pass.h"
#include "lixel/gl/passes/observation_readback.h"
#include "lixel/gl/passes/prepare_pass.h"
#include "lixel/gl/passes/sdsm_pass.h"
#include "lixel/gl/passes/shade_pass.h"
#include "lixel/gl/passes/view_pass.h"
#include "lixel/gl/passes/warp_fill_pass.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>

namespace lixel {
namespace {

double median(std::vector<double> values)
{
    LX_ASSERT(!values.empty());
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

bool isSameView(const View& a, const View& b)
{
    return a.clipFromAnchored == b.clipFromAnchored && a.anchorWorld == b.anchorWorld &&
           a.eyeAnchored == b.eyeAnchored && a.width == b.width && a.height == b.height;
}

// One value a pixel: the weighted mean of the samples in it, 1 where there is none and where `value` is empty.
std::vector<float> visibilityOfPixels(const ViewSamples& samples, std::span<const float> value)
{
    const std::size_t pixels = std::size_t(samples.width) * std::size_t(samples.height);
    std::vector<float> sum(pixels, 0), weight(pixels, 0);
    for (std::size_t i = 0; i < value.size(); ++i) {
        const int x = std::clamp(int(samples.pixel[i].x), 0, samples.width - 1);
        const int y = std::clamp(int(samples.pixel[i].y), 0, samples.height - 1);
        const std::size_t pixel = std::size_t(y) * std::size_t(samples.width) + std::size_t(x);
        sum[pixel] += samples.weightOf(i) * value[i];
        weight[pixel] += samples.weightOf(i);
    }
    for (std::size_t i = 0; i < pixels; ++i) sum[i] = weight[i] > 0 ? sum[i] / weight[i] : 1;
    return sum;
}

} // namespace

struct GlExecutor::State
{
    gl::Device device;
    gl::PassTimer timer{device};
    gl::Surfaces seen{device};    // what the view sees, and what casts when it comes in buffers of the same version
    gl::Surfaces casting{device}; // casters of another version
    gl::PlanTables tables;
    gl::ShadowAtlas atlas;
    gl::DrawnMaps inAtlas;
    gl::PreparedMaps prepared;
    std::uint64_t mapsDrawn = 0, plansPrepared = 0;
    std::optional<gl::DrawnPositions> positions; // once asked for
    gl::ViewTargets targets;
    gl::PointList pixels{device};  // one entry a pixel, of the view drawn last
    gl::PointList samples{device}; // a caller's
    gl::VisibilityList visibilityOfPixels, visibilityOfSamples;
    gl::ViewPass viewPass;
    gl::GatherPass gatherPass;
    gl::LightDepthPass lightDepthPass{device};
    gl::PreparePass preparePass;
    gl::LookupPass lookupPass;
    gl::ShadePass shadePass;
    gl::SamplePass samplePass{device};
    gl::SdsmPass sdsmPass;
    gl::WarpFillPass warpFillPass;
    gl::ObservationReadback ownFrame{0}, earlierFrame{kObservationAge};
    std::optional<View> drawn; // what `targets` and `pixels` hold, of the casters' version ...
    std::uint64_t drawnVersion = 0;

    explicit State(gl::Device::Context context) : device(context) {}
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    // Objects go with their own context current, whatever another executor has made of the thread since.
    ~State() { device.makeCurrent(); }

    void drawView(const CasterBuffers& casters, const View& view)
    {
        drawn.reset();
        seen.update(casters);
        targets.resize(device, view.width, view.height);
        {
            gl::PassTimer::Scope scope(timer, gl::ViewPass::kName);
            viewPass.run(seen, view, targets);
        }
        gl::PassTimer::Scope scope(timer, gl::GatherPass::kName);
        gatherPass.run(seen, view, targets, pixels);
        drawn = view;
        drawnVersion = casters.version;
    }

    // The view, unless it is there already.
    void needView(const CasterBuffers& casters, const View& view)
    {
        const bool isThere =
            drawn && isSameView(*drawn, view) && casters.version != 0 && casters.version == drawnVersion;
        if (!isThere) drawView(casters, view);
    }

    // Tables that are made on the device, from `pixels`.
    void fillTables(const Frame& frame)
    {
        for (const SdsmFill& fill : frame.fills) {
            gl::PassTimer::Scope scope(timer, gl::SdsmPass::kName);
            sdsmPass.run(fill, pixels, tables);
        }
        for (const WarpFill& fill : frame.warps) {
            gl::PassTimer::Scope scope(timer, gl::WarpFillPass::kName);
            LX_ASSERT(fill.light < frame.lights.size());
            warpFillPass.run(frame.plan, fill, frame.view, frame.lights[fill.light], pixels, tables);
        }
    }

    void drawMaps(const Frame& frame)
    {
        tables.upload(frame.plan);
        fillTables(frame);
        drawUploaded(frame.plan, frame.casters, !frame.fills.empty(), !frame.warps.empty());
    }

    void drawMaps(const FramePlan& plan, const CasterSource& casters)
    {
        tables.upload(plan);
        drawUploaded(plan, casters, false, false);
    }

    // Maps whose tables the device has made are drawn each time, and with all casters where it has made matrices: it alone knows what
    // they hold.
    void drawUploaded(const FramePlan& plan, const CasterSource& casters, bool hasOwnMatrices, bool hasOwnWarps)
    {
        const bool isKnown = !hasOwnMatrices && !hasOwnWarps;
        if (!isKnown || !inAtlas.areThoseOf(plan, casters)) drawAnew(plan, casters, hasOwnMatrices, isKnown);
        if (!plan.lookup.isPrepared() || prepared.areFor(plan)) return;
        gl::PassTimer::Scope scope(timer, gl::PreparePass::kName);
        preparePass.run(plan, tables, atlas, prepared);
        ++plansPrepared;
    }

    void drawAnew(const FramePlan& plan, const CasterSource& casters, bool hasOwnMatrices, bool isKnown)
    {
        const auto culling = hasOwnMatrices ? gl::LightDepthPass::Culling::Off : gl::LightDepthPass::Culling::ByRegion;
        inAtlas.forget();
        prepared.forget();
        atlas.resize(device, plan);
        const CasterBuffers* buffers = std::get_if<CasterBuffers>(&casters);
        // What is seen mostly casts as well, and is then here once.
        const bool isSeen = buffers && buffers->version != 0 && buffers->version == seen.version();
        gl::Surfaces& surfaces = isSeen ? seen : casting;
        if (buffers && !isSeen) surfaces.update(*buffers);
        gl::PassTimer::Scope scope(timer, gl::LightDepthPass::kName);
        if (buffers) lightDepthPass.run(plan, tables, surfaces, atlas, culling);
        else lightDepthPass.run(plan, tables, std::get<CasterCallback>(casters), atlas, culling);
        if (isKnown) inAtlas.set(plan, casters);
        mapsDrawn += plan.regionTable.size();
    }

    void lookUp(const FramePlan& plan, const gl::PointList& points, gl::VisibilityList& visibility)
    {
        gl::PassTimer::Scope scope(timer, gl::LookupPass::kName);
        lookupPass.run(plan, tables, {atlas, prepared}, points, visibility);
    }

    // Of `pixels` and their visibility.
    void sample(std::span<const Light> lights, ObservationGrid grid)
    {
        gl::PassTimer::Scope scope(timer, gl::SamplePass::kName);
        samplePass.run(pixels, visibilityOfPixels, lights, gridWithin(grid, *drawn));
    }

    Observation observedNow(ObservationGrid grid)
    {
        Observation observation;
        ownFrame.push(samplePass, observedFrame(grid));
        ownFrame.take(observation);
        device.throwOnMessages("an observation");
        return observation;
    }

    ObservedFrame observedFrame(ObservationGrid grid) const
    {
        return {*drawn, pixels.originWorld(), gridWithin(grid, *drawn), visibilityOfPixels.lights() > 0};
    }

    // Queues what the frame drawn last observed, if anything, and takes what has come.
    bool readBack(const std::optional<ObservationGrid>& grid, Observation& observation)
    {
        gl::PassTimer::Scope scope(timer, gl::ObservationReadback::kName);
        if (grid) earlierFrame.push(samplePass, observedFrame(*grid));
        else earlierFrame.pushNothing();
        return earlierFrame.take(observation);
    }

    void drawFrame(const Frame& frame, bool isShaded)
    {
        drawView(frame.seen, frame.view);
        drawMaps(frame);
        lookUp(frame.plan, pixels, visibilityOfPixels);
        if (frame.observed) sample(frame.lights, *frame.observed);
        if (!isShaded) return;
        gl::PassTimer::Scope scope(timer, gl::ShadePass::kName);
        shadePass.run(seen, targets, pixels, visibilityOfPixels, frame.lights);
    }
};

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

FrameTimes GlExecutor::measure(const Frame& frame, int frames)
{
    const bool isShaded = !frame.lights.empty();
    LX_ASSERT(frames > 0 && ((!isShaded && !frame.observed) || frame.lights.size() == frame.plan.lights.size()));
    state_->device.makeCurrent();
    const auto drawAnew = [&] {
        state_->inAtlas.forget();
        state_->drawFrame(frame, isShaded);
    };
    for (int i = 0; i < 2; ++i) drawAnew();
    FrameTimes times;
    std::vector<double> wholeMs, gpuMs;
    for (int i = 0; i < frames; ++i) {
        glFinish();
        const auto began = std::chrono::steady_clock::now();
        drawAnew();
        glFinish();
        wholeMs.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - began).count());
    }
    times.frameMs = median(wholeMs);

    std::vector<std::vector<double>> passMs;
    for (int i = 0; i < frames; ++i) {
        state_->timer.start();
        drawAnew();
        const std::vector<gl::PassTimer::Pass> passes = state_->timer.stop();
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
    if (!isSoftware()) times.gpuMs = median(gpuMs);
    times.clock = state_->timer.clock();
    times.trianglesDrawn = state_->lightDepthPass.trianglesDrawn();
    times.trianglesCulled = state_->lightDepthPass.trianglesCulled();
    state_->device.throwOnMessages("measuring");
    return times;
}

} // namespace lixel
