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

LightDepthPass::LightDepthPass(const Device& device, Output output)
    : mostViewports_(std::min(device.limits().viewports, 32))
{
    const std::array<std::string, 1> masked{"MASKED"}, position{"POSITION"};
    if (output == Output::DepthAndPosition) {
        opaque_ = Program::graphics({"caster.vert.glsl", "opaque.frag.glsl"}, position);
        return;
    }
    opaque_ = Program::graphics({"caster.vert.glsl", "opaque.frag.glsl"});
    masked_ = Program::graphics({"caster.vert.glsl", "caster.frag.glsl"}, masked);
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
                         const ShadowAtlas& atlas, Culling culling)
{
    LX_ASSERT(casters.originWorld() == plan.originWorld);
    drawn_ = culled_ = 0;
    forEachBatch(plan, tables, atlas, [&](const Batch& batch) { drawSurfaces(plan, casters, batch, culling); });
}

void LightDepthPass::drawSurfaces(const FramePlan& plan, const Surfaces& casters, const Batch& batch, Culling culling)
{
    const std::vector<const PlannedRegion*> regions = regionsOf(plan);
    volumes_.assign(std::size_t(batch.count), {});
    for (std::size_t i = 0; i < volumes_.size() && culling == Culling::ByRegion; ++i)
        volumes_[i] = casterVolume(regions[std::size_t(batch.first) + i]->lightClipFromLocal);
    draws_.list(casters.runs(), volumes_, std::uint32_t(batch.first));
    drawn_ += draws_.drawn();
    culled_ += draws_.culled();
    if (draws_.commands().empty()) return;

    // Room for the most there can be, so that a map that moves makes no buffer when it sees more than before.
    const std::size_t runs = casters.runs().size();
    commands_.reserve(runs * sizeof(DrawCommand));
    instances_.reserve(runs * std::size_t(batch.count) * sizeof(CasterInstance));
    commands_.assign(std::span<const DrawCommand>(draws_.commands()));
    instances_.assign(std::span<const CasterInstance>(draws_.instances()));
    casters.bindVertices(instances_);
    casters.bindMaterials();
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, commands_.name());
    for (const CasterDraws::Group& group : draws_.groups()) {
        const bool isMasked = group.maskedRange >= 0;
        LX_ASSERT(!isMasked || masked_.name());
        (isMasked ? masked_ : opaque_).use();
        if (isMasked) {
            const Surfaces::Wraps wraps = casters.bindTexture(casters.ranges()[std::size_t(group.maskedRange)]);
            masked_.set(kSurfaceWrap, wraps.u, wraps.v);
        }
        glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT,
                                    reinterpret_cast<const void*>(sizeof(DrawCommand) * std::uintptr_t(group.first)),
                                    GLsizei(group.count), sizeof(DrawCommand));
    }
}

void LightDepthPass::run(const FramePlan& plan, const PlanTables& tables, const CasterCallback& casters,
                         const ShadowAtlas& atlas, Culling culling)
{
    LX_ASSERT(casters.originWorld == plan.originWorld);
    const std::vector<const PlannedRegion*> regions = regionsOf(plan);
    drawn_ = culled_ = 0;
    std::vector<CasterView> views;
    forEachBatch(plan, tables, atlas, [&](const Batch& batch) {
        views.clear();
        for (int i = batch.first; i < batch.first + batch.count; ++i)
            views.push_back({std::uint32_t(i), culling == Culling::ByRegion
                                                   ? casterVolume(regions[std::size_t(i)]->lightClipFromLocal)
                                                   : std::vector<Plane>{}});
        casters.draw(views);
    });
}

} // namespace lixel::gl
