// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/gl/device/program.h"
#include "lixel/gl/passes/plan_tables.h"
#include "lixel/gl/passes/point_list.h"
#include "lixel/gl/passes/visibility_list.h"

#include <array>

namespace lixel::gl {

// The visibility of every light at every view sample, by lixel/shared/lookup.h.
//   reads   PlanTables, ShadowAtlas, PointList        writes   VisibilityList
class LookupPass
{
public:
    static constexpr const char* kName = "lookup";
    void run(const FramePlan& plan, const PlanTables& tables, const ShadowAtlas& atlas, const PointList& points,
             VisibilityList& visibility);

private:
    // For plans that have regions in double, or with a warp, and for those that have none: some drivers run both sides of every
    // branch.
    const Program& programFor(bool isInDouble, bool isWarped);

    std::array<std::array<Program, 2>, 2> programs_; // made when first needed
};

} // namespace lixel::gl
