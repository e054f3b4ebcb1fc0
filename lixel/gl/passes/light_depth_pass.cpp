// SPDX-License-Identifier: MIT
#include "lixel/gl/passes/light_depth_pass.h"

#include "lixel/base/assert.h"
#include "lixel/gl/device/device.h"
#include "lixel/gl/device/draw_state.h"
#include "lixel/shared/gl_slots.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace lixel::gl {
namespace {

// Location in alpha.glsl.
constexpr int kSurfaceWrap = 8;

// Behind a paraboloid there is no place (place_caster.glsl).
void clipAtRims(bool areThere) { (areThere ? glEnable : glDisable)(GL_CLIP_DISTANCE0); }

std::vector<const PlannedRegion*> regionsOf(const FramePlan& plan)
{
    std::vector<const PlannedRegion*> regions;
    for (const ShadowPlan& light : plan.lights)
        for (const PlannedRegion& region : light.regions) regions.push_back(&region);
    LX_ASSERT(regions.size() == plan.regionTable.size());
    return regions;
}

bool isAmong(const RegionMarks& among, std::size_t i) { return among.empty() || among[i] != 0; }

// To far: all of the atlas, or the rectangles of some regions.
void clear(const FramePlan& plan, const ShadowAtlas& atlas, const RegionMarks& among)
{
    const GLfloat far = 0;
    if (std::ranges::find(among, 0) == among.end()) {
        glClearTexImage(atlas.depth.name(), 0, GL_DEPTH_COMPONENT, GL_FLOAT, &far);
        return;
    }
    for (std::size_t i = 0; i < among.size(); ++i) {
        if (!among[i]) continue;
        const shared::vec4& r = plan.regionTable[i].rectangle;
        glClearTexSubImage(atlas.depth.name(), 0, GLint(r.x), GLint(r.y), GLint(plan.regionTable[i].place.x),
                           GLsizei(r.z - r.x), GLsizei(r.w - r.y), 1, GL_DEPTH_COMPONENT, GL_FLOAT, &far);
    }
}

} // namespace

std::vector<Plane> casterVolume(const LightProjection& projection)
{
    if (projection.paraboloid) return {};
    const Mat4d& lightClipFromLocal = projection.lightClipFromLocal;
    const Vec4d x = lightClipFromLocal.row(0), y = lightClipFromLocal.row(1), z = lightClipFromLocal.row(2),
                w = lightClipFromLocal.row(3);
    std::vector<Plane> planes;
    for (const Vec4d& row : {w + x, w - x, w + y, w - y, w - z})
        if (const double l = length(xyz(row)); l > 0) planes.push_back({xyz(row) / l, row.w / l});
    return planes;
}

LightDepthPass::LightDepthPass(const Device& device, Output output)
    : output_(output), mostViewports_(std::min(device.limits().viewports, 32))
{
    programsFor(Way::Plain);
}

LightDepthPass::Way LightDepthPass::wayInto(const PlannedRegion& region)
{
    if (region.warp.isIdentity()) return Way::Plain;
    switch (region.warp.raster) {
    case WarpRaster::Vertices: return Way::Moved;
    case WarpRaster::Tessellate: return Way::Tessellated;
    case WarpRaster::Exact: return Way::Exact;
    }
    return Way::Exact;
}

const LightDepthPass::Programs& LightDepthPass::programsFor(Way way)
{
    Programs& programs = programs_[std::size_t(way)];
    if (programs.opaque.name()) return programs;
    std::vector<std::string> defines;
    Program::Files opaque{"caster.vert.glsl", "opaque.frag.glsl"}, masked{"caster.vert.glsl", "caster.frag.glsl"};
    if (way == Way::Plain) defines.push_back("LIXEL_NO_WARP");
    if (way == Way::Tessellated) {
        defines.push_back("LIXEL_TESSELLATE");
        opaque.control = masked.control = "caster.tesc.glsl";
        opaque.evaluation = masked.evaluation = "caster.tese.glsl";
    }
    if (output_ == Output::DepthAndPosition) {
        defines.push_back("POSITION");
        programs.opaque = Program::graphics(opaque, defines);
        return programs;
    }
    programs.opaque = Program::graphics(opaque, defines);
    defines.push_back("MASKED");
    programs.masked = Program::graphics(masked, defines);
    return programs;
}

void LightDepthPass::bindBatch(const FramePlan& plan, const PlanTables& tables, const ShadowAtlas& atlas,
                               const Batch& batch)
{
    apply(DrawState{.clampsDepth = true});
    atlas.framebuffer.bind();
    tables.bind();
    const std::array<float, 4> words{float(batch.first), 0, 0, 0};
    batch_.assign(std::span<const float>(words));
    batch_.bindUniform(shared::kUniformBatch, sizeof(words));
    for (int i = 0; i < batch.count; ++i) {
        const shared::vec4& r = plan.regionTable[std::size_t(batch.first + i)].rectangle;
        glViewportIndexedf(GLuint(i), r.x, r.y, r.z - r.x, r.w - r.y);
    }
}

template <typename Draw>
void LightDepthPass::forEachBatch(const FramePlan& plan, const PlanTables& tables, const ShadowAtlas& atlas,
                                  const RegionMarks& among, const Draw& draw)
{
    clear(plan, atlas, among);
    const int regions = int(plan.regionTable.size());
    for (int first = 0; first < regions; first += mostViewports_) {
        Batch batch{first, std::min(mostViewports_, regions - first)};
        for (int i = 0; i < batch.count; ++i)
            if (isAmong(among, std::size_t(first + i))) batch.among |= 1u << i;
        if (batch.among == 0) continue;
        bindBatch(plan, tables, atlas, batch);
        draw(batch);
    }
}

void LightDepthPass::run(const FramePlan& plan, const PlanTables& tables, const Surfaces& casters,
                         const ShadowAtlas& atlas, Culling culling, const RegionMarks& among)
{
    LX_ASSERT(casters.originWorld() == plan.originWorld);
    drawn_ = culled_ = 0;
    const std::vector<const PlannedRegion*> regions = regionsOf(plan);
    forEachBatch(plan, tables, atlas, among,
                 [&](const Batch& batch) { drawSurfaces(regions, casters, batch, culling); });
    for (std::size_t i = 0; i < regions.size(); ++i) {
        if (wayInto(*regions[i]) != Way::Exact || !isAmong(among, i)) continue;
        LX_ASSERT(output_ == Output::Depth);
        listCasters(regions, casters, {int(i), 1, 1}, culling);
        exact_.run(plan, *regions[i], int(i), tables, casters, draws_, atlas, warpRoom_);
    }
}

void LightDepthPass::listCasters(const std::vector<const PlannedRegion*>& regions, const Surfaces& casters,
                                 const Batch& batch, Culling culling)
{
    volumes_.assign(std::size_t(batch.count), {});
    for (std::size_t i = 0; i < volumes_.size() && culling == Culling::ByRegion; ++i)
        volumes_[i] = casterVolume(regions[std::size_t(batch.first) + i]->projection());
    draws_.list(casters.runs(), volumes_, std::uint32_t(batch.first), batch.among);
    drawn_ += draws_.drawn();
    culled_ += draws_.culled();
}

void LightDepthPass::drawSurfaces(const std::vector<const PlannedRegion*>& regions, const Surfaces& casters,
                                  const Batch& batch, Culling culling)
{
    for (const Way way : {Way::Plain, Way::Moved, Way::Tessellated}) {
        Batch part{batch.first, batch.count};
        bool areOnParaboloids = false;
        for (int i = 0; i < batch.count; ++i) {
            const PlannedRegion& region = *regions[std::size_t(batch.first + i)];
            if (!batch.has(i) || wayInto(region) != way) continue;
            part.among |= 1u << i;
            areOnParaboloids |= region.paraboloid.has_value();
        }
        if (part.among == 0) continue;
        clipAtRims(areOnParaboloids);
        listCasters(regions, casters, part, culling);
        if (!draws_.commands().empty()) drawListed(way, casters, batch);
    }
}

void LightDepthPass::drawListed(Way way, const Surfaces& casters, const Batch& batch)
{
    // Room for the most there can be, so that a map that moves makes no buffer when it sees more than before.
    const std::size_t runs = casters.runs().size();
    commands_.reserve(runs * sizeof(DrawCommand));
    instances_.reserve(runs * std::size_t(batch.count) * sizeof(CasterInstance));
    commands_.assign(std::span<const DrawCommand>(draws_.commands()));
    instances_.assign(std::span<const CasterInstance>(draws_.instances()));
    casters.bindVertices(instances_);
    casters.bindMaterials();
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, commands_.name());
    const Programs& programs = programsFor(way);
    const GLenum primitive = way == Way::Tessellated ? GL_PATCHES : GL_TRIANGLES;
    if (way == Way::Tessellated) glPatchParameteri(GL_PATCH_VERTICES, 3);
    for (const CasterDraws::Group& group : draws_.groups()) {
        const bool isMasked = group.maskedRange >= 0;
        LX_ASSERT(!isMasked || programs.masked.name());
        (isMasked ? programs.masked : programs.opaque).use();
        if (isMasked) {
            const Surfaces::Wraps wraps = casters.bindTexture(casters.ranges()[std::size_t(group.maskedRange)]);
            programs.masked.set(kSurfaceWrap, wraps.u, wraps.v);
        }
        glMultiDrawElementsIndirect(primitive, GL_UNSIGNED_INT,
                                    reinterpret_cast<const void*>(sizeof(DrawCommand) * std::uintptr_t(group.first)),
                                    GLsizei(group.count), sizeof(DrawCommand));
    }
}

void LightDepthPass::run(const FramePlan& plan, const PlanTables& tables, const CasterCallback& casters,
                         const ShadowAtlas& atlas, Culling culling, const RegionMarks& among)
{
    LX_ASSERT(casters.originWorld == plan.originWorld);
    const std::vector<const PlannedRegion*> regions = regionsOf(plan);
    const auto asksForMore = [](const PlannedRegion* region) {
        return wayInto(*region) == Way::Exact || wayInto(*region) == Way::Tessellated;
    };
    if (std::any_of(regions.begin(), regions.end(), asksForMore))
        throw GraphicsError(
            "casters that the host draws get into warped maps by their vertices alone; use raster=vertices, or hand "
            "their buffers over");
    drawn_ = culled_ = 0;
    std::vector<CasterView> views;
    forEachBatch(plan, tables, atlas, among, [&](const Batch& batch) {
        views.clear();
        bool areOnParaboloids = false;
        for (int i = batch.first; i < batch.first + batch.count; ++i) {
            if (!batch.has(i - batch.first)) continue;
            areOnParaboloids |= regions[std::size_t(i)]->paraboloid.has_value();
            views.push_back({std::uint32_t(i), culling == Culling::ByRegion
                                                   ? casterVolume(regions[std::size_t(i)]->projection())
                                                   : std::vector<Plane>{}});
        }
        clipAtRims(areOnParaboloids);
        casters.draw(views);
    });
}

} // namespace lixel::gl
