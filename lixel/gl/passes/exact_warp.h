// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/gl/device/program.h"
#include "lixel/gl/passes/caster_draws.h"
#include "lixel/gl/passes/plan_tables.h"
#include "lixel/gl/passes/surfaces.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace lixel::gl {

// Draws casters into a warped map as rays through its lixels meet them (WarpRaster::Exact), which no rasterizer of straight edges
// does. In compute:
//
//   rays     each lixel's ray, the inverse of the warp at its centre, and boxes around those of runs of 16 of a column
//   bounds   least and greatest of the warp's functions of x over blocks of lines
//   sort     the box of each triangle, warped, tells which columns of lixels to look at: many triangles have none
//   draw     of each column the lixels that may see the triangle, each one's ray against the triangle itself (ray_triangle.glsl);
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
             const Surfaces& casters, const CasterDraws& draws, const ShadowAtlas& atlas);

    std::size_t bytes() const; // on the device, of tables and temporaries

private:
    struct Programs
    {
        Program rays, bounds;
        struct Drawing
        {
            Program sort;
            Program small, large, smallMasked, largeMasked;
        };
        Drawing inFloat, inDouble; // the second for regions in double: some drivers run both sides of every branch
    };
    struct Span
    {
        std::uint32_t firstTriangle = 0, triangleCount = 0;
    };

    void makePrograms();
    void makeBounds(const TextureWarp& warp, const shared::ShadowWarp& row);
    void makeRays(const LixelRectangle& r);
    void listSpans(const CasterDraws& draws);
    void drawGroup(const Programs::Drawing& programs, const CasterDraws::Group& group, const Surfaces& casters,
                   std::uint32_t firstSpan, std::uint32_t spanCount);
    void drawQueues(const Program& small, const Program& large);
    void copyInto(const ShadowAtlas& atlas, const LixelRectangle& r);

    std::optional<Programs> programs_; // once there is such a map
    Buffer region_, setup_, bounds_, rays_, runs_, spansOnDevice_, queues_, queued_, depths_;
    shared::vec4 size_;          // WarpRasterSetup::size of the region
    std::uint32_t capacity_ = 0; // of each queue, triangles
    std::vector<Span> spans_;
    std::vector<std::uint32_t> spansBefore_; // those of each group, and all
};

} // namespace lixel::gl
