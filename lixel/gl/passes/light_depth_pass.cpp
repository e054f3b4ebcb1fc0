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

// Locations in caster.frag.glsl and alpha.glsl.
constexpr int kFirstTriangle = 1, kSurfaceWrap = 8;

std::vector<const PlannedRegion*> regionsOf(const FramePlan& plan)
{
    std::vector<const PlannedRegion*> regions;
    for (const ShadowPlan& light : plan.lights)
        for (const PlannedRegion& region : light.regions) regions.push_back(&region);
    LX_ASSERT(regions.size() == plan.regionTable.size());
    return regions;
}

} // namespace

std::vector<Plane> casterVolume(const Mat4d& lightClipFromLocal)
{
    const Vec4d x = lightClipFromLocal.row(0), y = lightClipFromLocal.row(1), z = lightClipFromLocal.row(2),
                w = lightClipFromLocal.row(3);
    std::vector<Plane> planes;
    for (const Vec4d& row : {w + x, w - x, w + y, w - y, w - z})
        if (const double l = length(xyz(row)); l > 0) planes.push_back({xyz(row) / l, row.w / l});
    return planes;
}

LightDepthPass::LightDepthPass(const Device& device) : mostViewports_(device.limits().viewports)
{
    opaque_ = Program::graphics({"caster.vert.glsl", "opaque.frag.glsl"});
    const std::array<std::string, 1> masked{"MASKED"};
    masked_ = Program::graphics({"caster.vert.glsl", "caster.frag.glsl"}, masked);
    opaqueFirstView_ = glGetUniformLocation(opaque_.name(), "lixelFirstView");
    maskedFirstView_ = glGetUniformLocation(masked_.name(), "lixelFirstView");
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
                                  const Draw& draw)
{
    const GLfloat far = 0;
    glClearTexImage(atlas.depth.name(), 0, GL_DEPTH_COMPONENT, GL_FLOAT, &far);
    const int regions = int(plan.regionTable.size());
    for (int first = 0; first < regions; first += mostViewports_) {
        const Batch batch{first, std::min(mostViewports_, regions - first)};
        bindBatch(plan, tables, atlas, batch);
        draw(batch);
    }
}

void LightDepthPass::run(const FramePlan& plan, const PlanTables& tables, const Surfaces& casters,
                         const ShadowAtlas& atlas)
{
    LX_ASSERT(casters.originWorld() == plan.originWorld);
    forEachBatch(plan, tables, atlas, [&](const Batch& batch) { drawSurfaces(casters, batch); });
}

void LightDepthPass::drawSurfaces(const Surfaces& casters, const Batch& batch) const
{
    if (casters.triangleCount() == 0) return;
    const auto instances = std::uint32_t(batch.count);
    casters.bindVertices();
    opaque_.set(opaqueFirstView_, batch.first);
    opaque_.use();
    casters.draw(0, casters.opaqueCount(), instances);

    casters.bindMaterials();
    masked_.set(maskedFirstView_, batch.first);
    masked_.use();
    for (const DrawRange& range : casters.ranges()) {
        if (!range.isMasked) continue;
        const Surfaces::Wraps wraps = casters.bindTexture(range);
        masked_.set(kSurfaceWrap, wraps.u, wraps.v);
        masked_.set(kFirstTriangle, range.firstTriangle);
        casters.draw(range.firstTriangle, range.triangleCount, instances);
    }
}

void LightDepthPass::run(const FramePlan& plan, const PlanTables& tables, const CasterCallback& casters,
                         const ShadowAtlas& atlas)
{
    LX_ASSERT(casters.originWorld == plan.originWorld);
    const std::vector<const PlannedRegion*> regions = regionsOf(plan);
    std::vector<CasterView> views;
    forEachBatch(plan, tables, atlas, [&](const Batch& batch) {
        views.clear();
        for (int i = batch.first; i < batch.first + batch.count; ++i)
            views.push_back({std::uint32_t(i), casterVolume(regions[std::size_t(i)]->lightClipFromLocal)});
        casters.draw(views);
    });
}

} // namespace lixel::gl
