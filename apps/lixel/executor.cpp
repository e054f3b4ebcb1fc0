// SPDX-License-Identifier: MIT
#include "executor.h"

#include "exit_code.h"
#include "lixel/base/median.h"
#include "lixel/gl/graphics_error.h"
#include "lixel/trace/shade.h"
#include "lixel/trace/trace_executor.h"
#include "lixel/trace/trace_view_samples.h"
#include "run_results.h"

#if LIXEL_HAS_GL
#include "lixel/gl/device/device.h"
#include "lixel/gl/executor.h"
#endif

#include <thread>

#include <fmt/format.h>

namespace lixel::app {
namespace {

std::string processors() { return fmt::format("{} processors", std::thread::hardware_concurrency()); }

class TraceAdapter final : public Executor
{
public:
    std::string_view name() const override { return "trace"; }
    ViewSamples viewSamples(const Stage& stage, const View& view) override
    {
        return traceViewSamples(*stage.traced, view);
    }
    std::vector<Visibility> run(const Stage& stage, const FramePlan& plan, const ViewSamples& samples) override
    {
        return runTraced(*stage.traced, plan, samples);
    }
    std::vector<Image<float>> maps(const Stage& stage, const FramePlan& plan) override
    {
        return traceAtlas(*stage.traced, plan);
    }
    RowTiming time(const Stage& stage, const FramePlan& plan, const View& view, int frames, const TimedExtras&) override
    {
        const ViewSamples samples = viewSamples(stage, view);
        std::vector<double> maps, preparing, lookups, all;
        for (int i = -2; i < frames; ++i) {
            const Stopwatch whole;
            const TracedAtlas atlas = traceAtlas(*stage.traced, plan);
            const double mapSeconds = whole.seconds();
            const PreparedMaps prepared = prepareMaps(plan, atlas);
            const double preparedSeconds = whole.seconds();
            for (std::size_t light = 0; light < plan.lights.size(); ++light)
                lookUp(plan, atlas, prepared, samples, light);
            if (i < 0) continue;
            maps.push_back(1e3 * mapSeconds);
            preparing.push_back(1e3 * (preparedSeconds - mapSeconds));
            all.push_back(1e3 * whole.seconds());
            lookups.push_back(all.back() - 1e3 * preparedSeconds);
        }
        RowTiming timing;
        timing.frameMs = median(all);
        timing.passes = {{"light depth", median(maps)}};
        if (plan.lookup.isPrepared()) timing.passes.push_back({"prepare", median(preparing)});
        timing.passes.push_back({"lookup", median(lookups)});
        timing.clock = "steady_clock, without view samples and shading";
        return timing;
    }
    Expected<std::vector<Visibility>, Refusal> shadowVolumes(const Stage&, const View&, std::span<const Light>,
                                                             const ViewSamples&) override
    {
        return Unexpected{Refusal{"needs-gl", "shadow volumes are counted by a rasterizer: --executor gl"}};
    }
    RowTiming timeVolumes(const Stage&, const View&, std::span<const Light>, int, bool) override { return {}; }
    Image<Rgba8> shade(const Stage& stage, const View&, std::span<const Light> lights, const ViewSamples& samples,
                       std::span<const Visibility> visibility) override
    {
        return shadeTraced(*stage.traced, lights, samples, visibility);
    }
    std::string host() const override { return "Embree, " + processors(); }
};

#if LIXEL_HAS_GL
RowTiming rowTiming(const FrameTimes& times)
{
    RowTiming timing;
    timing.frameMs = times.frameMs;
    timing.gpuMs = times.gpuMs;
    timing.clock = times.clock;
    for (const FrameTimes::Pass& pass : times.passes) timing.passes.push_back({pass.name, pass.ms});
    return timing;
}

class GlAdapter final : public Executor
{
public:
    std::string_view name() const override { return "gl"; }
    ViewSamples viewSamples(const Stage& stage, const View& view) override
    {
        return executor_.viewSamples(stage.buffers.casters(), view);
    }
    std::vector<Visibility> run(const Stage& stage, const FramePlan& plan, const ViewSamples& samples) override
    {
        return executor_.run(plan, stage.buffers.casters(), samples);
    }
    std::vector<Image<float>> maps(const Stage& stage, const FramePlan& plan) override
    {
        return executor_.drawMaps(plan, stage.buffers.casters());
    }
    RowTiming time(const Stage& stage, const FramePlan& plan, const View& view, int frames,
                   const TimedExtras& extras) override
    {
        const CasterBuffers seen = stage.buffers.casters();
        const CasterSource casters = seen;
        const FrameTimes times =
            executor_.measure({seen, casters, view, plan, extras.lights, std::nullopt, {}, extras.warps}, frames);
        return rowTiming(times);
    }
    Expected<std::vector<Visibility>, Refusal> shadowVolumes(const Stage& stage, const View& view,
                                                             std::span<const Light> lights,
                                                             const ViewSamples& samples) override
    {
        auto visibility = executor_.shadowVolumes(stage.buffers.casters(), view, lights, samples);
        if (visibility) return std::move(visibility).value();
        const VolumeFailure why = visibility.error();
        return Unexpected{Refusal{std::string(nameOf(why)), std::string(sentenceFor(why))}};
    }
    RowTiming timeVolumes(const Stage& stage, const View& view, std::span<const Light> lights, int frames,
                          bool isShaded) override
    {
        const auto times = executor_.measureVolumes(stage.buffers.casters(), view, lights, isShaded, frames);
        return times ? rowTiming(*times) : RowTiming{};
    }
    Image<Rgba8> shade(const Stage& stage, const View& view, std::span<const Light> lights, const ViewSamples& samples,
                       std::span<const Visibility> visibility) override
    {
        return executor_.shade(stage.buffers.casters(), view, lights, samples, visibility);
    }
    std::optional<std::uint64_t> deviceBytes() const override { return executor_.deviceBytes(); }
    std::string host() const override { return executor_.renderer() + ", " + processors(); }

private:
    GlExecutor executor_;
};

std::unique_ptr<Executor> makeGl() { return std::make_unique<GlAdapter>(); }
#else
std::unique_ptr<Executor> makeGl()
{
    throw gl::GraphicsError("this lixel was built without OpenGL; use --executor trace");
}
#endif

} // namespace

Stage makeStage(const std::shared_ptr<const Scene>& scene, const EvaluateOptions& options, Vec3d originWorld)
{
    Stage stage{evaluate(scene, options, originWorld), nullptr};
    stage.traced = std::make_shared<const TraceScene>(stage.buffers.casters());
    return stage;
}

std::unique_ptr<Executor> makeExecutor(std::string_view name)
{
    if (name == "gl") return makeGl();
    if (name == "trace") return std::make_unique<TraceAdapter>();
    throw UsageError(fmt::format("--executor {}: expected gl or trace", name));
}

} // namespace lixel::app
