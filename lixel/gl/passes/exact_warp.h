// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/gl/device/program.h"
#include "lixel/gl/passes/caster_draws.h"
#include "lixel/gl/passes/plan_tables.h"
#include "lixel/gl/passes/surfaces.h"
#include "lixel/gl/passes/warp_room.h"
#include "lixel/shared/warp_raster.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace lixel::gl {

// Draws casters into a warped map, or one on a paraboloid, as rays through its lixels meet them (WarpRaster::Exact), which no
// rasterizer of straight edges does. In compute:
//
//   rays     each lixel's ray, the inverse of the warp at its centre, and boxes around those of runs of 16 of a column
//   bounds   least and greatest of the warp's functions of x over blocks of lines
//   sort     the box of each triangle, warped, tells which columns of lixels to look at: many triangles have none
//   draw     of each column the lixels that may see the triangle, each one's ray against the triangle itself (ray_triangle.glsl,
//            paraboloid_triangle.glsl);
//            the nearest depth by atomic maximum
//
// Where the warp bends over a triangle therefore does not matter, and no triangle is moved or cut up.
//   reads   PlanTables, Surfaces        writes   a region's rectangle of ShadowAtlas
class ExactWarp
{
public:
    // Region `index` of the plan, whose warp is not the identity. `draws` lists the casters of this region alone. Throws GraphicsError,
    // by name, at more triangles than the device binds at once.
    void run(const FramePlan& plan, const PlannedRegion& region, int index, const PlanTables& tables,
             const Surfaces& casters, const CasterDraws& draws, const ShadowAtlas& atlas, WarpRoom& room);

    std::size_t bytes() const; // on the device, besides the room

private:
    struct Programs
    {
        Program rays, bounds;
        struct Drawing
        {
            Program sort;
            Program small, large, smallMasked, largeMasked;
        };
        std::array<Drawing, 3> drawings; // by Numbers; each once there is such a map
    };
    // What regions are reckoned in; programs apart, as some drivers run both sides of every branch.
    enum class Numbers { Float, Double, Paraboloid };
    struct Span
    {
        std::uint32_t firstTriangle = 0, triangleCount = 0;
    };

    const Programs::Drawing& programsFor(const PlannedRegion& region);
    void makeBounds(const TextureWarp& warp, const shared::ShadowWarp& row, const shared::WarpRasterSetup& setup);
    void makeRays(const LixelRectangle& r);
    void listSpans(const CasterDraws& draws);
    void drawGroup(const Programs::Drawing& programs, const CasterDraws::Group& group, const Surfaces& casters,
                   std::uint32_t firstSpan, std::uint32_t spanCount);
    void drawQueues(const Program& small, const Program& large);
    void copyInto(const ShadowAtlas& atlas, const LixelRectangle& r);

    std::optional<Programs> programs_; // once there is such a map
    // What is kept of a map while it is drawn.
    struct Room
    {
        WarpRoom::Part bounds, rays, runs, queued, depths;
    };
    void makeRoom(const LixelRectangle& r, int boundPairs, std::uint32_t triangles);

    Buffer region_, setup_, spansOnDevice_, queues_;
    WarpRoom* room_ = nullptr; // of this run
    Room parts_;
    shared::vec4 size_;          // WarpRasterSetup::size of the region
    std::uint32_t capacity_ = 0; // of each queue, triangles
    std::vector<Span> spans_;
    std::vector<std::uint32_t> spansBefore_; // those of each group, and all
};

} // namespace lixel::gl
