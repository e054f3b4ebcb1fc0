// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/gl/device/program.h"
#include "lixel/gl/passes/plan_tables.h"
#include "lixel/gl/passes/surfaces.h"

namespace lixel::gl {

// Draws the casters through every region of a plan into its rectangle of the atlas, as many regions a call as the device
// has viewports. Geometry between the light and a region's near side is drawn at the near side.
//   reads   PlanTables, Surfaces or a host's casters        writes   ShadowAtlas
class LightDepthPass
{
public:
    static constexpr const char* kName = "light depth";
    explicit LightDepthPass(const Device& device);

    void run(const FramePlan& plan, const PlanTables& tables, const Surfaces& casters, const ShadowAtlas& atlas);
    void run(const FramePlan& plan, const PlanTables& tables, const CasterCallback& casters, const ShadowAtlas& atlas);

private:
    // Regions [first, first + count) of the plan.
    struct Batch
    {
        int first = 0, count = 0;
    };
    template <typename Draw>
    void forEachBatch(const FramePlan& plan, const PlanTables& tables, const ShadowAtlas& atlas, const Draw& draw);
    void bindBatch(const FramePlan& plan, const PlanTables& tables, const ShadowAtlas& atlas, const Batch& batch);
    void drawSurfaces(const Surfaces& casters, const Batch& batch) const;

    Program opaque_, masked_;
    int opaqueFirstView_ = -1, maskedFirstView_ = -1;
    int mostViewports_ = 1;
    Buffer batch_;
};

// What lies outside of these half-spaces, in Local space, cannot darken a lixel of the region: its sides and its far plane,
// but not the near one.
std::vector<Plane> casterVolume(const Mat4d& lightClipFromLocal);

} // namespace lixel::gl
