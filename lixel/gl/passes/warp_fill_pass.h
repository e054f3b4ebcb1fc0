// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/light.h"
#include "lixel/base/view.h"
#include "lixel/gl/device/program.h"
#include "lixel/gl/passes/plan_tables.h"
#include "lixel/gl/passes/point_list.h"
#include "lixel/gl/passes/warp_room.h"
#include "lixel/plan/warp/warp_choice.h"
#include "lixel/plan/warp/warp_fill.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace lixel::gl {

// Makes the warps of one light's regions from the view samples, in the buffer that drawing and lookup read: importance by integer
// atomics, sums among lines, densities and their prefix sums. The twin of warpRegions() (lixel/plan/warp/region_warps.h).
//   reads   PointList        writes   PlanTables, which hold the layout's rows
class WarpFillPass
{
public:
    static constexpr const char* kName = "importance";
    void run(const FramePlan& plan, const WarpFill& fill, const View& view, const Light& light, const PointList& points,
             const PlanTables& tables, WarpRoom& room);

    std::size_t bytes() const; // on the device, besides the room

private:
    // A region's part of the importance maps and of the table of knots.
    struct Part
    {
        const TextureWarp* warp = nullptr;
        shared::ShadowWarp row;
        int firstCell = 0;
    };
    // Functions of one axis.
    struct Axis
    {
        int firstCell = 0, lines = 0, cells = 0, firstKnot = 0;
        double smooth = 0;
    };

    void makePrograms();
    void listParts(const FramePlan& plan, std::size_t light);
    void makeRoom(const PointList& points);
    void setUp(const FramePlan& plan, const WarpFill& fill, const View& view, const Light& light,
               const PointList& points);
    void count(const Program& program, const PointList& points);
    void makeFunctions(const Axis& axis, const WarpOptions& options);
    void makeNow(const NowWarp& now, const Program& moved, const PointList& points);
    void makeRtw(const RtwWarp& rtw);
    void smoothGreatest(const Part& part, const WarpOptions& options, bool isOfColumns);

    struct Programs
    {
        Program nearest, among, along, greatest, smooth;
        std::array<Program, 2> weigh, moved; // the second for regions in double
    };
    std::optional<Programs> programs_; // once there is such a plan
    Buffer setup_, nearest_;
    WarpRoom* room_ = nullptr; // of this run
    WarpRoom::Part importance_, weights_, sums_;
    std::vector<Part> parts_;
    int cells_ = 0;       // of all importance maps
    int behindCells_ = 0; // room for lines behind them
};

} // namespace lixel::gl
