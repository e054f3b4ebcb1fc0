// SPDX-License-Identifier: MIT
#include "loop_race.h"

#include "lixel/base/median.h"
#include "lixel/gl/graphics_error.h"
#include "run_results.h"

#if LIXEL_HAS_GL
#include "lixel/gl/frame_loop.h"
#endif

#include <optional>
#include <string_view>
#include <utility>

namespace lixel::app {

#if LIXEL_HAS_GL
namespace {

// Frames before the first that counts: until the loops are planned from what they observed, and have drawn that once.
constexpr int kFramesToBegin = GlExecutor::kObservationAge + 2;

// Sums of passes by name. A frame that is not observed has fewer of them; the order is that of the frame with most.
class PassSums
{
public:
    void add(const std::vector<FrameTimes::Pass>& passes)
    {
        ++frames_;
        if (passes.size() > sums_.size()) {
            std::vector<PassTime> longer;
            for (const FrameTimes::Pass& pass : passes) longer.push_back({pass.name, sumOf(pass.name)});
            sums_ = std::move(longer);
        }
        for (const FrameTimes::Pass& pass : passes)
            for (PassTime& sum : sums_)
                if (sum.name == pass.name) sum.ms += pass.ms;
    }
    std::vector<PassTime> means() const
    {
        std::vector<PassTime> out = sums_;
        for (PassTime& pass : out) pass.ms /= frames_;
        return out;
    }

private:
    double sumOf(std::string_view name) const
    {
        for (const PassTime& sum : sums_)
            if (sum.name == name) return sum.ms;
        return 0;
    }
    std::vector<PassTime> sums_;
    int frames_ = 0;
};

} // namespace

struct LoopRace::State
{
    struct Runner
    {
        GlExecutor executor;
        std::optional<FrameLoop> loop;
        PassSums passes;
        LoopTimes times;
    };

    const PathShooting& path;
    const SceneBuffers& buffers;
    const CasterBuffers casters = buffers.casters();
    const CasterSource source = casters;
    std::vector<std::unique_ptr<Runner>> runners;

    State(const PathShooting& along, const SceneBuffers& of, std::size_t mostLoops) : path(along), buffers(of)
    {
        for (std::size_t i = 0; i < mostLoops; ++i) runners.push_back(std::make_unique<Runner>());
    }

    // In milliseconds.
    double draw(Runner& runner, std::size_t frame, std::span<const Light> lights,
                std::vector<FrameTimes::Pass>* passes = nullptr) const
    {
        runner.executor.forgetMaps();
        runner.executor.finish();
        const Stopwatch watch;
        runner.loop->draw(
            {casters, source, buffers.bounds.boxesWorld, path.frames[frame].view, lights, path.shooting.planes},
            passes);
        runner.executor.finish();
        return 1e3 * watch.seconds();
    }
};

LoopRace::LoopRace(const PathShooting& path, const SceneBuffers& buffers, std::size_t mostLoops)
    : state_(std::make_unique<State>(path, buffers, mostLoops))
{
}

LoopRace::~LoopRace() = default;

int LoopRace::steps(std::size_t loops, int passFrames) const
{
    return int(loops) * (kFramesToBegin + int(state_->path.frames.size()) + passFrames);
}

std::vector<LoopTimes> LoopRace::run(std::span<const RacedLoop> loops, std::span<const Light> lights, int passFrames,
                                     const std::function<void()>& onFrame)
{
    LX_ASSERT(loops.size() <= state_->runners.size());
    LX_ASSERT(passFrames < int(state_->path.frames.size()));
    for (std::size_t i = 0; i < loops.size(); ++i) {
        State::Runner& runner = *state_->runners[i];
        runner.loop.emplace(runner.executor, FrameLoop::Options{loops[i].technique, loops[i].lixels});
        runner.passes = {};
        runner.times = {};
    }
    // Each frame another one is first.
    const auto inTurns = [&](int turn, const auto& drawOne) {
        for (std::size_t i = 0; i < loops.size(); ++i) {
            onFrame();
            drawOne(*state_->runners[(std::size_t(turn) + i) % loops.size()]);
        }
    };
    const int frames = int(state_->path.frames.size());
    for (int i = 0; i < kFramesToBegin; ++i)
        inTurns(i, [&](State::Runner& runner) { state_->draw(runner, 0, lights); });
    for (int frame = 0; frame < frames; ++frame)
        inTurns(frame, [&](State::Runner& runner) {
            runner.times.frameMs.push_back(state_->draw(runner, std::size_t(frame), lights));
            runner.times.planMs.push_back(runner.loop->planMs());
            runner.times.plans.push_back(runner.loop->plan());
        });
    for (int i = 0; i < passFrames; ++i)
        inTurns(i, [&](State::Runner& runner) {
            std::vector<FrameTimes::Pass> passes;
            state_->draw(runner, std::size_t(frames - 2 - i), lights, &passes);
            runner.passes.add(passes);
        });
    std::vector<LoopTimes> out;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        State::Runner& runner = *state_->runners[i];
        if (passFrames > 0) runner.times.passes = runner.passes.means();
        runner.times.passClock = runner.executor.passClock();
        out.push_back(std::move(runner.times));
    }
    return out;
}

ReadbackCost readbackCost(const SceneBuffers& buffers, const View& view, std::span<const Light> lights, int frames)
{
    GlExecutor executor;
    const CasterBuffers casters = buffers.casters();
    const CasterSource source = casters;
    const PlanInput input{view, lights, buffers.bounds.boxesWorld, casters.originWorld, {}, {64, 64}};
    const FramePlan plan = planShadows(input);
    Observation observation;
    std::vector<double> sample, readback;
    for (int frame = -kFramesToBegin; frame < frames; ++frame) {
        std::vector<FrameTimes::Pass> passes;
        executor.advance({casters, source, view, plan, lights, ObservationGrid{}, {}}, observation, &passes);
        for (const FrameTimes::Pass& pass : passes) {
            if (frame >= 0 && pass.name == "sample") sample.push_back(pass.ms);
            if (frame >= 0 && pass.name == "readback") readback.push_back(pass.ms);
        }
    }
    return {median(sample), median(readback)};
}

#else

struct LoopRace::State
{
};
LoopRace::~LoopRace() = default;
int LoopRace::steps(std::size_t, int) const { return 0; }
LoopRace::LoopRace(const PathShooting&, const SceneBuffers&, std::size_t)
{
    throw gl::GraphicsError("this lixel was built without OpenGL, which frame loops are drawn with");
}
std::vector<LoopTimes> LoopRace::run(std::span<const RacedLoop>, std::span<const Light>, int,
                                     const std::function<void()>&)
{
    return {};
}
ReadbackCost readbackCost(const SceneBuffers&, const View&, std::span<const Light>, int) { return {}; }

#endif

} // namespace lixel::app
