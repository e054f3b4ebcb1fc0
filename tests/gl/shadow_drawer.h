// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/gl/passes/light_depth_pass.h"
#include "lixel/gl/passes/lookup_pass.h"
#include "lixel/gl/passes/prepare_pass.h"
#include "lixel/plan/shadow_plan.h"
#include "lixel/trace/trace_executor.h"
#include "small_scenes.h"

#include <optional>
#include <variant>

namespace lixel::test {

// The passes from a plan to visibility, with what they keep from frame to frame.
struct ShadowDrawer
{
    gl::Device& device;
    gl::Surfaces surfaces{device};
    gl::PlanTables tables;
    gl::ShadowAtlas atlas;
    gl::LightDepthPass depthPass{device};
    gl::PreparedMaps prepared;
    gl::PreparePass preparePass;
    gl::LookupPass lookupPass;
    gl::PointList points{device};
    gl::VisibilityList visibility;

    using Culling = gl::LightDepthPass::Culling;
    Culling culling;
    explicit ShadowDrawer(gl::Device& on, Culling which = Culling::ByRegion) : device(on), culling(which) {}
    TracedAtlas drawAtlas(const FramePlan& plan, const CasterSource& casters);

    void writeAtlas(const FramePlan& plan, const TracedAtlas& maps);
    std::vector<Visibility> lookUp(const FramePlan& plan, const ViewSamples& samples);
};

// Of any kind, above the centre and aimed at it, `least` to `most` half sizes away.
Light anyLightOn(Rng& rng, Vec3d centreWorld, double half, double least = 2.5, double most = 50);

// Lights whose plan is refused stay in it.
FramePlan planFor(const SmallScene& scene, const View& view, std::span<const Light> lights, LixelSize lixels,
                  const MapTechnique& technique = {});

// The same for one light with four regions, one for each quarter of the picture, in quarters of one layer. Nothing where one of
// them is refused.
std::optional<FramePlan> planOfQuarters(const Box& boxWorld, const View& view, const Light& light, Vec3d originWorld,
                                        LixelSize lixels);

} // namespace lixel::test
