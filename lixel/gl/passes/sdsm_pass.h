// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/gl/device/program.h"
#include "lixel/gl/passes/plan_tables.h"
#include "lixel/gl/passes/point_list.h"
#include "lixel/plan/partition/sdsm_fill.h"

namespace lixel::gl {

// Makes the tables of one light's sample-distribution cascades from the view samples, in the buffers that drawing and lookup read:
// depths by atomic minimum and maximum, splits, the bounds of each cascade's samples, matrices and half-spaces.
//   reads   PointList        writes   PlanTables, which hold the layout's rows
class SdsmPass
{
public:
    static constexpr const char* kName = "sdsm";
    SdsmPass();
    void run(const SdsmFill& fill, const PointList& points, const PlanTables& tables);

private:
    Program depths_, bounds_, regions_;
    Buffer setup_, casters_, greatest_;
};

} // namespace lixel::gl
