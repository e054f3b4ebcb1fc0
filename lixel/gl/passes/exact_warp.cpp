// SPDX-License-Identifier: MIT
#include "lixel/gl/passes/exact_warp.h"

#include "lixel/base/assert.h"
#include "lixel/gl/device/draw_state.h"
#include "lixel/shared/gl_slots.h"
#include "lixel/shared/warp_raster.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>

namespace lixel::gl {
namespace {

// Locations in the shaders.
constexpr int kFirstPair = 0, kBlocks = 1, kKnots = 2, kFirstBefore = 3, kBefore = 4, kIsLevel0 = 5; // warp_bounds
constexpr int kFirstSpan = 0, kSortCapacity = 1;                                                     // warp_sort
constexpr int kStrides = 0, kDrawCapacity = 1, kQueue = 2, kSurfaceWrap = 8;                         // warp_draw

constexpr std::uint32_t kTrianglesOfSpan = 128;         // a work group each
constexpr std::uint32_t kSpansAtOnce = 512;             // so that queues stay small
constexpr int kPieceOfColumn = 4 * shared::LX_WARP_RUN; // lixels an invocation of warp_rays
// As in warp_queues.glsl: queues, those whose triangles are large, and bytes of a triangle in them.
constexpr int kQueues = 5, kFirstLarge = 3;
constexpr std::size_t kBytesQueued = 8;
// Lixels that the invocations of a work group share when a triangle covers them all: some drivers end loops at 65,535 rounds.
constexpr std::int64_t kLixelsOfGroup = 64 * 40000;

int groupsOf(std::int64_t items) { return int((items + 63) / 64); }

void dispatch(const Program& program, std::int64_t invocations)
{
    program.use();
    glDispatchCompute(GLuint(groupsOf(invocations)), 1, 1);
}

// Levels of bounds over so many lines of so many knots; returns how many pairs there are in all.
int layOutLevels(int lines, int knots, shared::vec4 (&levels)[8])
{
    int first = 0;
    int blocks = (lines + shared::LX_BOUND_LINES - 1) / shared::LX_BOUND_LINES;
    for (int level = 0;; ++level) {
        LX_ASSERT(level < shared::LX_BOUND_LEVELS);
        levels[level] = {float(first), float(blocks), 0, 0};
        first += blocks * knots;
        if (blocks == 1) return first;
        blocks = (blocks + shared::LX_BOUND_BLOCKS - 1) / shared::LX_BOUND_BLOCKS;
    }
}

int linesOf(const TextureWarp& warp) { return warp.lines == WarpLines::Rectilinear ? 1 : warp.rows; }

Program computeIn(const char* file, std::initializer_list<std::string> defines)
{
    return Program::compute(file, std::span<const std::string>(defines.begin(), defines.size()));
}

} // namespace

void ExactWarp::makeRoom(const LixelRectangle& r, int boundPairs, std::uint32_t triangles)
{
    const std::size_t lixels = std::size_t(r.width()) * std::size_t(r.height());
    capacity_ = std::min(triangles, kSpansAtOnce * kTrianglesOfSpan);
    WarpRoom::Parts parts;
    parts_.bounds = parts.add(std::size_t(boundPairs) * sizeof(shared::vec2));
    parts_.rays = parts.add(lixels * sizeof(shared::vec2));
    parts_.runs = parts.add(std::size_t(r.width()) * std::size_t(size_.z) * sizeof(shared::vec4));
    parts_.queued = parts.add(kQueues * std::size_t(capacity_) * kBytesQueued);
    parts_.depths = parts.add(lixels * sizeof(float));
    room_->reserve(parts);
    room_->clear(parts_.depths);
    room_->bindStorage(shared::kStorageWarpBounds, parts_.bounds);
    room_->bindStorage(shared::kStorageWarpRays, parts_.rays);
    room_->bindStorage(shared::kStorageWarpRuns, parts_.runs);
    room_->bindStorage(shared::kStorageWarpQueued, parts_.queued);
    room_->bindStorage(shared::kStorageWarpDepths, parts_.depths);
}

void ExactWarp::makeBounds(const TextureWarp& warp, const shared::ShadowWarp& row, const shared::WarpRasterSetup& setup)
{
    const int lines = linesOf(warp), knots = warp.columns + 1;
    const Program& program = programs_->bounds;
    program.set(kKnots, knots);
    for (int level = 0; level == 0 || setup.levels[level - 1].y > 1; ++level) {
        const shared::vec4 own = setup.levels[level], before = setup.levels[std::max(level - 1, 0)];
        program.set(kFirstPair, int(own.x));
        program.set(kBlocks, int(own.y));
        program.set(kFirstBefore, level == 0 ? int(row.grid.x) : int(before.x));
        program.set(kBefore, level == 0 ? lines : int(before.y));
        program.set(kIsLevel0, level == 0 ? 1 : 0);
        dispatch(program, std::int64_t(own.y) * knots);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    }
}

void ExactWarp::makeRays(const LixelRectangle& r)
{
    const int pieces = (r.height() + kPieceOfColumn - 1) / kPieceOfColumn;
    dispatch(programs_->rays, std::int64_t(pieces) * r.width());
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void ExactWarp::listSpans(const CasterDraws& draws)
{
    spans_.clear(), spansBefore_.clear();
    for (const CasterDraws::Group& group : draws.groups()) {
        spansBefore_.push_back(std::uint32_t(spans_.size()));
        for (std::uint32_t i = group.first; i < group.first + group.count; ++i) {
            const DrawCommand& command = draws.commands()[i];
            const std::uint32_t first = command.firstIndex / 3, end = first + command.indexCount / 3;
            for (std::uint32_t at = first; at < end; at += kTrianglesOfSpan)
                spans_.push_back({at, std::min(kTrianglesOfSpan, end - at)});
        }
    }
    spansBefore_.push_back(std::uint32_t(spans_.size()));
    spansOnDevice_.assign(std::span<const Span>(spans_));
    spansOnDevice_.bindStorage(shared::kStorageWarpSpans);
}

void ExactWarp::drawQueues(const Program& small, const Program& large)
{
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, queues_.name());
    for (int queue = 0; queue < kQueues; ++queue) {
        const Program& program = queue < kFirstLarge ? small : large;
        program.set(kQueue, queue);
        program.use();
        glDispatchComputeIndirect(GLintptr(std::size_t(queue) * 4 * sizeof(std::uint32_t)));
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

void ExactWarp::drawGroup(const Programs::Drawing& programs, const CasterDraws::Group& group, const Surfaces& casters,
                          std::uint32_t firstSpan, std::uint32_t spanCount)
{
    const bool isMasked = group.maskedRange >= 0;
    const Program& small = isMasked ? programs.smallMasked : programs.small;
    const Program& large = isMasked ? programs.largeMasked : programs.large;
    for (const Program* program : {&small, &large}) {
        program->set(kDrawCapacity, capacity_);
        if (!isMasked) continue;
        const Surfaces::Wraps wraps = casters.bindTexture(casters.ranges()[std::size_t(group.maskedRange)]);
        const Surfaces::Strides strides = casters.bindVertexData();
        program->set(kSurfaceWrap, wraps.u, wraps.v);
        program->set(kStrides, strides.uv, strides.colour);
    }
    programs.sort.set(kSortCapacity, capacity_);
    const auto lixels = std::int64_t(size_.x) * std::int64_t(size_.y);
    const auto shares = std::uint32_t((lixels + kLixelsOfGroup - 1) / kLixelsOfGroup);
    std::array<std::uint32_t, 4 * kQueues> empty{}; // as in warp_queues.glsl
    for (std::size_t queue = 0; queue < kQueues; ++queue) {
        empty[4 * queue + 1] = queue + 1 == kQueues ? shares : 1;
        empty[4 * queue + 2] = 1;
    }
    for (std::uint32_t at = 0; at < spanCount; at += kSpansAtOnce) {
        queues_.assign(std::span<const std::uint32_t>(empty));
        queues_.bindStorage(shared::kStorageWarpQueues);
        programs.sort.set(kFirstSpan, firstSpan + at);
        programs.sort.use();
        glDispatchCompute(std::min(kSpansAtOnce, spanCount - at), 1, 1);
        drawQueues(small, large);
    }
}

void ExactWarp::copyInto(const ShadowAtlas& atlas, const LixelRectangle& r)
{
    glMemoryBarrier(GL_PIXEL_BUFFER_BARRIER_BIT);
    applyPixelTransfer();
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, room_->name());
    glTextureSubImage3D(atlas.depth.name(), 0, r.x0, r.y0, r.layer, r.width(), r.height(), 1, GL_DEPTH_COMPONENT,
                        GL_FLOAT, reinterpret_cast<const void*>(parts_.depths.first));
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}

const ExactWarp::Programs::Drawing& ExactWarp::programsFor(const PlannedRegion& region)
{
    if (!programs_) {
        programs_.emplace();
        programs_->rays = computeIn("warp_rays.comp.glsl", {});
        programs_->bounds = computeIn("warp_bounds.comp.glsl", {});
    }
    const Numbers numbers = region.paraboloid   ? Numbers::Paraboloid
                            : region.isInDouble ? Numbers::Double
                                                : Numbers::Float;
    Programs::Drawing& drawing = programs_->drawings[std::size_t(numbers)];
    if (drawing.sort.name()) return drawing;
    const std::string name = numbers == Numbers::Double ? "LIXEL_DOUBLE" : "LIXEL_NO_DOUBLE";
    const std::string kind = numbers == Numbers::Paraboloid ? "PARABOLOID" : "MATRIX";
    drawing.sort = computeIn("warp_sort.comp.glsl", {name, kind});
    drawing.small = computeIn("warp_draw.comp.glsl", {name, kind});
    drawing.large = computeIn("warp_draw.comp.glsl", {name, kind, "RUNS"});
    drawing.smallMasked = computeIn("warp_draw.comp.glsl", {name, kind, "MASKED"});
    drawing.largeMasked = computeIn("warp_draw.comp.glsl", {name, kind, "RUNS", "MASKED"});
    return drawing;
}

void ExactWarp::run(const FramePlan& plan, const PlannedRegion& region, int index, const PlanTables& tables,
                    const Surfaces& casters, const CasterDraws& draws, const ShadowAtlas& atlas, WarpRoom& room)
{
    LX_ASSERT(!region.warp.isIdentity());
    if (casters.triangleCount() > casters.trianglesPerBinding())
        throw GraphicsError(
            fmt::format("the scene has {} triangles, the graphics device takes {} in one buffer when maps are "
                        "warped exactly; use raster=tessellate or --executor trace",
                        casters.triangleCount(), casters.trianglesPerBinding()));
    const Programs::Drawing& drawing = programsFor(region);
    room_ = &room;
    const LixelRectangle& r = region.rectangle;
    const int runs = (r.height() + shared::LX_WARP_RUN - 1) / shared::LX_WARP_RUN;
    size_ = {float(r.width()), float(r.height()), float(runs), 0};
    tables.bind();
    tables.copyRegion(std::size_t(index), region_);
    region_.bindUniform(shared::kUniformRegion, sizeof(shared::ShadowRegion));
    shared::WarpRasterSetup setup;
    setup.size = size_;
    makeRoom(r, layOutLevels(linesOf(region.warp), region.warp.columns + 1, setup.levels), casters.triangleCount());
    setup_.assign(std::span<const shared::WarpRasterSetup>(&setup, 1));
    setup_.bindUniform(shared::kUniformWarpRaster, sizeof(setup));
    makeBounds(region.warp, plan.regionTable[std::size_t(index)].warp, setup);
    makeRays(r);
    listSpans(draws);
    casters.bindTriangles(0, casters.triangleCount());
    casters.bindMaterials();
    for (std::size_t i = 0; i < draws.groups().size(); ++i)
        drawGroup(drawing, draws.groups()[i], casters, spansBefore_[i], spansBefore_[i + 1] - spansBefore_[i]);
    copyInto(atlas, r);
}

std::size_t ExactWarp::bytes() const
{
    return region_.capacity() + setup_.capacity() + spansOnDevice_.capacity() + queues_.capacity();
}

} // namespace lixel::gl
