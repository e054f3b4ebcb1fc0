// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/gl/device/program.h"
#include "lixel/gl/passes/plan_tables.h"
#include "lixel/gl/passes/prepared_maps.h"

#include <string>
#include <vector>

namespace lixel::gl {

// What a plan's lookup makes of its maps: several depths a lixel, slopes, moments; by lixel/shared/lookup/.
//   reads   PlanTables, ShadowAtlas        writes   PreparedMaps
class PreparePass
{
public:
    static constexpr const char* kName = "prepare";
    void run(const FramePlan& plan, const PlanTables& tables, const ShadowAtlas& atlas, PreparedMaps& maps,
             const RegionMarks& among = {});

private:
    void dispatch(const FramePlan& plan, const RegionMarks& among, const char* what);

    ProgramSet programs_{"prepare.comp.glsl"};
};

} // namespace lixel::gl
