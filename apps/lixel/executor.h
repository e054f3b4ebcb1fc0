// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/expected.h"
#include "lixel/base/image.h"
#include "lixel/base/surfaces.h"
#include "lixel/base/view_samples.h"
#include "lixel/base/visibility.h"
#include "lixel/plan/shadow_plan.h"
#include "lixel/plan/warp/warp_fill.h"
#include "lixel/report/results.h"
#include "lixel/scene/evaluate.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lixel {
class TraceScene;
}

// The two executors as the command line uses them. They do not know each other; this is only what both can be asked.
namespace lixel::app {

// A scene at its moment, ready for both: triangles and, for the CPU executor and exact visibility, their search structure.
struct Stage
{
    SceneBuffers buffers;
    std::shared_ptr<const TraceScene> traced;
};
Stage makeStage(const std::shared_ptr<const Scene>& scene, const EvaluateOptions& options, Vec3d originWorld);

// Warps that the device makes itself while it is timed; frames with lights are shaded too.
struct TimedExtras
{
    std::span<const WarpFill> warps = {};
    std::span<const Light> lights = {};
};

class Executor
{
public:
    virtual ~Executor() = default;
    virtual std::string_view name() const = 0;

    virtual ViewSamples viewSamples(const Stage& stage, const View& view) = 0;

    // One visibility a light of the plan, for any list of samples; a refused light's is empty.
    virtual std::vector<Visibility> run(const Stage& stage, const FramePlan& plan, const ViewSamples& samples) = 0;

    // By shadow volumes, of samples at pixel centres of the view; or why not.
    virtual Expected<std::vector<Visibility>, Refusal>
    shadowVolumes(const Stage& stage, const View& view, std::span<const Light> lights, const ViewSamples& samples) = 0;
    // Times of a frame with them, where they are not refused.
    virtual RowTiming timeVolumes(const Stage& stage, const View& view, std::span<const Light> lights, int frames,
                                  bool isShaded) = 0;

    // The maps of a plan, one image a layer of its atlas: 1 near, 0 far and empty.
    virtual std::vector<Image<float>> maps(const Stage& stage, const FramePlan& plan) = 0;

    // Times of the frame that run() makes, without bringing results back: the median of `frames` undisturbed ones after two
    // more, and each pass by itself.
    virtual RowTiming time(const Stage& stage, const FramePlan& plan, const View& view, int frames,
                           const TimedExtras& extras = {}) = 0;

    // The picture with this visibility, one a light; an empty one counts as lit.
    virtual Image<Rgba8> shade(const Stage& stage, const View& view, std::span<const Light> lights,
                               const ViewSamples& samples, std::span<const Visibility> visibility) = 0;

    // Bytes of its buffers and textures on the device now; nothing where there is no device.
    virtual std::optional<std::uint64_t> deviceBytes() const { return std::nullopt; }

    // What the results say of the machine: the driver, the processor.
    virtual std::string host() const = 0;
};

// By the word after --executor: "gl" or "trace". Throws UsageError, gl::GraphicsError.
std::unique_ptr<Executor> makeExecutor(std::string_view name);

} // namespace lixel::app
