// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/gl/device/program.h"
#include "lixel/gl/passes/plan_tables.h"
#include "lixel/gl/passes/point_list.h"
#include "lixel/gl/passes/visibility_list.h"

namespace lixel::gl {

// The visibility of every light at every view sample, by lixel/shared/lookup.h.
//   reads   PlanTables, ShadowAtlas, PointList        writes   VisibilityList
class LookupPass
{
public:
    static constexpr const char* kName = "lookup";
    LookupPass();
    void run(const FramePlan& plan, const PlanTables& tables, const ShadowAtlas& atlas, const PointList& points,
             VisibilityList& visibility) const;

private:
    Program program_,
        inDouble_; // the second for plans with regions in double: some drivers run both sides of every branch
};

} // namespace lixel::gl
