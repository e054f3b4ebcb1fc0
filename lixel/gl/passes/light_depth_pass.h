// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/gl/device/program.h"
#include "lixel/gl/passes/drawn_maps.h"
#include "lixel/gl/passes/exact_warp.h"
#include "lixel/gl/passes/plan_tables.h"
#include "lixel/gl/passes/surfaces.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lixel::gl {

// Draws the casters through every region of a plan into its rectangle of the atlas, as many regions at once as the device
// has viewports. Geometry between the light and a region's near side is drawn at the near side. Casters from buffers that no
// lixel of a region can see are left out of it. Regions that are not `among` those to draw keep what they have. Into warped maps casters are drawn as their warp says (WarpRaster); a host's get
// there by their vertices alone, and throw GraphicsError where a warp asks for more.
//   reads   PlanTables, Surfaces or a host's casters        writes   ShadowAtlas
class LightDepthPass
{
public:
    static constexpr const char* kName = "light depth";
    // By the plan's own matrices, or not at all: then everything is drawn into every region, which gives the same maps, and is
    // what there is where the device alone knows the tables.
    enum class Culling { ByRegion, Off };
    // What is drawn: depth; or, to see what lixels really sample, also the Local position of the surface, into colour 0 of the atlas's
    // framebuffer, w = 1. Holes, warps and a host's casters are then not served.
    enum class Output { Depth, DepthAndPosition };
    explicit LightDepthPass(const Device& device, Output output = Output::Depth);

    void run(const FramePlan& plan, const PlanTables& tables, const Surfaces& casters, const ShadowAtlas& atlas,
             Culling culling = Culling::ByRegion, const RegionMarks& among = {});
    void run(const FramePlan& plan, const PlanTables& tables, const CasterCallback& casters, const ShadowAtlas& atlas,
             Culling culling = Culling::ByRegion, const RegionMarks& among = {});

    // Of the last run: triangles of buffers times the regions they were drawn into, or were left out of.
    std::uint64_t trianglesDrawn() const { return drawn_; }
    std::uint64_t trianglesCulled() const { return culled_; }

    // For passes around warps that are over before maps are drawn.
    WarpRoom& warpRoom() { return warpRoom_; }
    // On the device, of what exact drawing into warped maps keeps, the room included.
    std::size_t warpBytes() const { return exact_.bytes() + warpRoom_.bytes(); }

private:
    // Of regions [first, first + count) of the plan those whose bit is in `among`.
    struct Batch
    {
        int first = 0, count = 0;
        std::uint32_t among = 0;

        bool has(int i) const { return (among >> i & 1u) != 0; }
    };
    template <typename Draw>
    void forEachBatch(const FramePlan& plan, const PlanTables& tables, const ShadowAtlas& atlas,
                      const RegionMarks& among, const Draw& draw);
    void bindBatch(const FramePlan& plan, const PlanTables& tables, const ShadowAtlas& atlas, const Batch& batch);
    // How casters get into a map: as they are, their vertices moved, cut up before that, or by rays.
    enum class Way { Plain, Moved, Tessellated, Exact };
    static Way wayInto(const PlannedRegion& region);
    struct Programs
    {
        Program opaque, masked;
    };
    const Programs& programsFor(Way way);
    void listCasters(const std::vector<const PlannedRegion*>& regions, const Surfaces& casters, const Batch& batch,
                     Culling culling);
    void drawSurfaces(const std::vector<const PlannedRegion*>& regions, const Surfaces& casters, const Batch& batch,
                      Culling culling);
    void drawListed(Way way, const Surfaces& casters, const Batch& batch);

    Output output_;
    std::array<Programs, 3> programs_; // of the ways that draw; made when first needed
    ExactWarp exact_;
    WarpRoom warpRoom_;
    int mostViewports_ = 1;
    Buffer batch_, commands_, instances_;
    CasterDraws draws_;
    std::vector<std::vector<Plane>> volumes_;
    std::uint64_t drawn_ = 0, culled_ = 0;
};

// What lies outside of these half-spaces, in Local space, cannot darken a lixel of the region: its sides and its far plane,
// but not the near one. None of a paraboloid, which sees more than half of all directions.
std::vector<Plane> casterVolume(const LightProjection& projection);

} // namespace lixel::gl
