// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/assert.h"
#include "lixel/gl/device/device.h"
#include "lixel/gl/device/pass_timer.h"
#include "lixel/gl/executor.h"
#include "lixel/gl/passes/drawn_maps.h"
#include "lixel/gl/passes/drawn_positions.h"
#include "lixel/gl/passes/gather_pass.h"
#include "lixel/gl/passes/light_depth_pass.h"
#include "lixel/gl/passes/lookup_pass.h"
#include "lixel/gl/passes/observation_readback.h"
#include "lixel/gl/passes/prepare_pass.h"
#include "lixel/gl/passes/sdsm_pass.h"
#include "lixel/gl/passes/shade_pass.h"
#include "lixel/gl/passes/shadow_volume_pass.h"
#include "lixel/gl/passes/view_pass.h"
#include "lixel/gl/passes/warp_fill_pass.h"

#include <algorithm>
#include <functional>
#include <optional>

namespace lixel {

// What an executor keeps from call to call, and how its passes follow each other.
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
    gl::RegionMarks missing; // of the plan that is drawn
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
    gl::VolumeCasters volumeCasters{device};
    std::optional<gl::ShadowVolumePass> volumePass; // once asked for
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

    bool isSameView(const View& view) const
    {
        return drawn->clipFromAnchored == view.clipFromAnchored && drawn->anchorWorld == view.anchorWorld &&
               drawn->eyeAnchored == view.eyeAnchored && drawn->width == view.width && drawn->height == view.height;
    }

    // The view, unless it is there already.
    void needView(const CasterBuffers& casters, const View& view)
    {
        const bool isThere = drawn && isSameView(view) && casters.version != 0 && casters.version == drawnVersion;
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
            warpFillPass.run(frame.plan, fill, frame.view, frame.lights[fill.light], pixels, tables,
                             lightDepthPass.warpRoom());
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
        if (!isKnown) inAtlas.forget();
        if (inAtlas.findMissing(plan, casters, missing)) drawMissing(plan, casters, hasOwnMatrices, isKnown);
        if (!plan.lookup.isPrepared() || !prepared.findMissing(plan, missing)) return;
        gl::PassTimer::Scope scope(timer, gl::PreparePass::kName);
        preparePass.run(plan, tables, atlas, prepared, missing);
        ++plansPrepared;
    }

    void drawMissing(const FramePlan& plan, const CasterSource& casters, bool hasOwnMatrices, bool isKnown)
    {
        const auto culling = hasOwnMatrices ? gl::LightDepthPass::Culling::Off : gl::LightDepthPass::Culling::ByRegion;
        inAtlas.forget(); // of what is half drawn, should this throw
        prepared.forget(missing);
        atlas.resize(device, plan);
        const CasterBuffers* buffers = std::get_if<CasterBuffers>(&casters);
        // What is seen mostly casts as well, and is then here once.
        const bool isSeen = buffers && buffers->version != 0 && buffers->version == seen.version();
        gl::Surfaces& surfaces = isSeen ? seen : casting;
        if (buffers && !isSeen) surfaces.update(*buffers);
        gl::PassTimer::Scope scope(timer, gl::LightDepthPass::kName);
        if (buffers) lightDepthPass.run(plan, tables, surfaces, atlas, culling, missing);
        else lightDepthPass.run(plan, tables, std::get<CasterCallback>(casters), atlas, culling, missing);
        if (isKnown) inAtlas.set(plan, casters);
        mapsDrawn += std::uint64_t(std::ranges::count(missing, 1));
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

    void countVolumes(const View& view, std::span<const Light> lights, const gl::PointList& points,
                      gl::VisibilityList& visibility)
    {
        if (!volumePass) volumePass.emplace();
        visibility.resize(points, lights.size());
        {
            gl::PassTimer::Scope scope(timer, gl::ShadowVolumePass::kVolumes);
            volumePass->begin(volumeCasters, view, points);
        }
        for (std::size_t light = 0; light < lights.size(); ++light) {
            {
                gl::PassTimer::Scope scope(timer, gl::ShadowVolumePass::kSilhouettes);
                volumePass->findSilhouettes(volumeCasters, lights[light]);
            }
            gl::PassTimer::Scope scope(timer, gl::ShadowVolumePass::kVolumes);
            volumePass->count(volumeCasters);
            volumePass->decide(points, visibility, light);
        }
    }

    // Draws a frame twice to warm up, then `frames` times undisturbed and as often pass by pass.
    FrameTimes timesOf(int frames, const std::function<void()>& drawOne);

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

} // namespace lixel
