// SPDX-License-Identifier: MIT
#include "lixel/gl/passes/warp_fill_pass.h"

#include "lixel/base/assert.h"
#include "lixel/plan/shading_light.h"
#include "lixel/plan/warp/line_functions.h"
#include "lixel/shared/gl_slots.h"
#include "lixel/shared/warp_fill.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>

namespace lixel::gl {
namespace {

// Locations in the shaders.
constexpr int kPointCount = 0;
constexpr int kFirstCell = 0, kLines = 1, kCells = 2, kReach = 3;             // warp_among
constexpr int kFirstKnot = 0, kPower = 3, kFloor = 4, kOfAverageLocation = 5; // warp_along, beside kLines and kCells
constexpr int kFrom = 0, kTo = 1, kAcross = 3, kSteps = 4;                    // warp_greatest, beside kCells and kReach

constexpr std::size_t kPointsOfGroup = 64 * 64; // of importance_nearest

void dispatch(const Program& program, std::size_t invocations)
{
    program.use();
    glDispatchCompute(GLuint((invocations + 63) / 64), 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

} // namespace

void WarpFillPass::makePrograms()
{
    if (programs_) return;
    const std::array<std::string, 1> smooth{"SMOOTH"};
    Programs& made = programs_.emplace();
    made.nearest = Program::compute("importance_nearest.comp.glsl");
    for (const bool isInDouble : {false, true}) {
        const std::array<std::string, 2> defines{isInDouble ? "LIXEL_DOUBLE" : "LIXEL_NO_DOUBLE", "MOVED"};
        made.weigh[isInDouble] = Program::compute("importance_count.comp.glsl", std::span(defines).first(1));
        made.moved[isInDouble] = Program::compute("importance_count.comp.glsl", defines);
    }
    made.among = Program::compute("warp_among.comp.glsl");
    made.along = Program::compute("warp_along.comp.glsl");
    made.greatest = Program::compute("warp_greatest.comp.glsl");
    made.smooth = Program::compute("warp_greatest.comp.glsl", smooth);
}

void WarpFillPass::listParts(const FramePlan& plan, std::size_t light)
{
    parts_.clear();
    cells_ = behindCells_ = 0;
    auto index = std::size_t(plan.lightTable[light].regions.x);
    for (const PlannedRegion& region : plan.lights[light].regions) {
        parts_.push_back({&region.warp, plan.regionTable[index++].warp, cells_});
        cells_ += region.warp.columns * region.warp.rows;
        behindCells_ = std::max(behindCells_, 2 * std::max(region.warp.columns, region.warp.rows));
    }
}

void WarpFillPass::makeRoom(const PointList& points)
{
    std::size_t sums = 0; // of the axis that needs most
    for (const Part& part : parts_) {
        const auto columns = std::size_t(part.warp->columns), rows = std::size_t(part.warp->rows);
        sums = std::max(sums, 2 * columns * rows + std::max(columns, rows));
    }
    WarpRoom::Parts parts;
    importance_ = parts.add(std::size_t(cells_ + behindCells_) * sizeof(std::uint32_t));
    weights_ = parts.add(points.size() * sizeof(std::uint32_t));
    sums_ = parts.add(sums * sizeof(float));
    room_->reserve(parts);
    room_->clear(importance_);
    room_->bindStorage(shared::kStorageImportance, importance_);
    room_->bindStorage(shared::kStorageLineSums, sums_);
}

void WarpFillPass::setUp(const FramePlan& plan, const WarpFill& fill, const View& view, const Light& light,
                         const PointList& points)
{
    const Importance& importance = warpOptionsOf(fill.choice)->importance;
    const Vec4d eye = eyeLocal(view, plan.originWorld);
    shared::WarpFillSetup setup;
    setup.light = shadingLight(light, plan.originWorld);
    setup.eye = {float(eye.x), float(eye.y), float(eye.z), float(eye.w)};
    setup.picture = {float(points.width()), float(points.height()), 0, 0};
    setup.regions = {plan.lightTable[fill.light].regions.x, float(parts_.size()), 0, 0};
    setup.importance = {float(importance.factors), float(importance.greatestOf), importance.isCounted ? 1.0f : 0.0f, 0};
    setup_.assign(std::span<const shared::WarpFillSetup>(&setup, 1));
    setup_.bindUniform(shared::kUniformWarpFill, sizeof(setup));
    const float farthest = std::numeric_limits<float>::max();
    nearest_.assign(std::span<const float>(&farthest, 1));
    nearest_.bindStorage(shared::kStorageNearest);
}

void WarpFillPass::count(const Program& program, const PointList& points)
{
    for (const PointList::Part& part : points.parts(sizeof(std::uint32_t))) {
        points.bind(part);
        room_->bindStorage(shared::kStorageWeights,
                           {weights_.first + part.first * sizeof(std::uint32_t), part.count * sizeof(std::uint32_t)});
        program.set(kPointCount, std::uint32_t(part.count));
        dispatch(program, part.count);
    }
}

void WarpFillPass::makeFunctions(const Axis& axis, const WarpOptions& options)
{
    const int reach = std::min(int(std::lround(axis.smooth * axis.lines)), axis.lines);
    const Program &among = programs_->among, &along = programs_->along;
    among.set(kFirstCell, axis.firstCell);
    among.set(kLines, axis.lines);
    among.set(kCells, axis.cells);
    among.set(kReach, reach < axis.lines ? reach / 2 : axis.lines, reach - reach / 2);
    dispatch(among, std::size_t(axis.cells));
    along.set(kFirstKnot, axis.firstKnot);
    along.set(kLines, axis.lines);
    along.set(kCells, axis.cells);
    along.set(kPower, float(options.power));
    along.set(kFloor, float(std::clamp(options.floor, kLeastFloor, 1.0)));
    along.set(kOfAverageLocation, float(kOfAverage));
    dispatch(along, std::size_t(axis.lines));
}

void WarpFillPass::makeNow(const NowWarp& now, const Program& moved, const PointList& points)
{
    const WarpOptions& options = now.options;
    for (const Part& part : parts_)
        if (!part.warp->isIdentity())
            makeFunctions({part.firstCell, part.warp->rows, part.warp->columns, int(part.row.grid.x), options.smooth},
                          options);
    room_->clear({importance_.first, std::size_t(cells_) * sizeof(std::uint32_t)});
    count(moved, points);
    for (const Part& part : parts_)
        if (!part.warp->isIdentity())
            makeFunctions({part.firstCell, part.warp->columns, part.warp->rows, int(part.row.grid.w), options.smooth},
                          options);
}

// Of x from the greatest of every column, or of y from those of the rows.
void WarpFillPass::smoothGreatest(const Part& part, const WarpOptions& options, bool isOfColumns)
{
    const int columns = part.warp->columns, rows = part.warp->rows;
    const int cells = isOfColumns ? columns : rows, reach = int(std::lround(options.smooth * cells));
    const Program &greatest = programs_->greatest, &smooth = programs_->smooth;
    greatest.set(kFrom, part.firstCell);
    greatest.set(kTo, cells_);
    greatest.set(kCells, cells);
    greatest.set(kAcross, isOfColumns ? rows : columns);
    greatest.set(kSteps, isOfColumns ? 1 : columns, isOfColumns ? columns : 1);
    dispatch(greatest, std::size_t(cells));
    const std::array<int, 2> reaches{reach / 2, reach - reach / 2}, from{cells_, cells_ + cells};
    smooth.set(kCells, cells);
    for (std::size_t i = 0; i < 2; ++i) {
        smooth.set(kFrom, from[i]);
        smooth.set(kTo, from[1 - i]);
        smooth.set(kReach, reaches[i]);
        dispatch(smooth, std::size_t(cells));
    }
    makeFunctions({cells_, 1, cells, int(isOfColumns ? part.row.grid.x : part.row.grid.w), 0}, options);
}

void WarpFillPass::makeRtw(const RtwWarp& rtw)
{
    for (const Part& part : parts_) {
        if (part.warp->isIdentity()) continue;
        smoothGreatest(part, rtw.options, true);
        smoothGreatest(part, rtw.options, false);
    }
}

void WarpFillPass::run(const FramePlan& plan, const WarpFill& fill, const View& view, const Light& light,
                       const PointList& points, const PlanTables& tables, WarpRoom& room)
{
    LX_ASSERT(points.originWorld() == plan.originWorld && fill.light < plan.lights.size());
    const WarpOptions* options = warpOptionsOf(fill.choice);
    LX_ASSERT(options);
    if (options->importance.has(kEdgesWeight) && points.parts(sizeof(std::uint32_t)).size() > 1)
        throw GraphicsError(
            "the picture is too large for the graphics device to find its edges at once; use an importance "
            "without edges or --executor trace");
    makePrograms();
    listParts(plan, fill.light);
    room_ = &room;
    makeRoom(points);
    setUp(plan, fill, view, light, points);
    tables.bind();
    if (options->importance.has(kDistanceWeight))
        for (const PointList::Part& part : points.parts()) {
            points.bind(part);
            programs_->nearest.set(kPointCount, std::uint32_t(part.count));
            programs_->nearest.use();
            glDispatchCompute(GLuint((part.count + kPointsOfGroup - 1) / kPointsOfGroup), 1, 1);
            glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        }
    const std::vector<PlannedRegion>& regions = plan.lights[fill.light].regions;
    const bool isInDouble =
        std::any_of(regions.begin(), regions.end(), [](const PlannedRegion& r) { return r.isInDouble; });
    count(programs_->weigh[isInDouble], points);
    if (const auto* now = std::get_if<NowWarp>(&fill.choice)) makeNow(*now, programs_->moved[isInDouble], points);
    if (const auto* rtw = std::get_if<RtwWarp>(&fill.choice)) makeRtw(*rtw);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

std::size_t WarpFillPass::bytes() const { return setup_.capacity() + nearest_.capacity(); }

} // namespace lixel::gl
