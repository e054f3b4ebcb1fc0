// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/gl/device/program.h"
#include "lixel/gl/passes/plan_tables.h"
#include "lixel/gl/passes/point_list.h"
#include "lixel/gl/passes/prepared_maps.h"
#include "lixel/gl/passes/visibility_list.h"

namespace lixel::gl {

// The visibility of every light at every view sample, by lixel/shared/lookup/visibility.h.
//   reads   PlanTables, ShadowAtlas, PreparedMaps of the plan's lookup, PointList        writes   VisibilityList
class LookupPass
{
public:
    static constexpr const char* kName = "lookup";
    // What a plan's lookup reads.
    struct Maps
    {
        const ShadowAtlas& atlas;
        const PreparedMaps& prepared;
    };
    LookupPass();
    void run(const FramePlan& plan, const PlanTables& tables, const Maps& maps, const PointList& points,
             VisibilityList& visibility);

private:
    // A program for each kind of lookup, and apart for plans with regions in double or with a warp: some drivers run both sides of every
    // branch.
    ProgramSet programs_{"lookup.comp.glsl"};
    Sampler comparing_;
};

} // namespace lixel::gl
