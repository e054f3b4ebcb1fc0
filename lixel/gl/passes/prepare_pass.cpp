// SPDX-License-Identifier: MIT
#include "lixel/gl/passes/prepare_pass.h"

#include "lixel/shared/gl_slots.h"

#include <epoxy/gl.h>

namespace lixel::gl {
namespace {

constexpr int kRegion = 0; // location in prepare.comp.glsl
constexpr int kGroupSide = 8;

GLuint groupsOf(float lixels) { return GLuint((int(lixels) + kGroupSide - 1) / kGroupSide); }

} // namespace

void PreparePass::dispatch(const FramePlan& plan, const RegionMarks& among, const char* what)
{
    const Program& program = programs_.with({what, lookupDefine(plan.lookup.how)});
    program.use();
    for (std::size_t i = 0; i < plan.regionTable.size(); ++i) {
        if (!among.empty() && !among[i]) continue;
        const shared::vec4& r = plan.regionTable[i].rectangle;
        program.set(kRegion, int(i));
        glDispatchCompute(groupsOf(r.z - r.x), groupsOf(r.w - r.y), 1);
    }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void PreparePass::run(const FramePlan& plan, const PlanTables& tables, const ShadowAtlas& atlas, PreparedMaps& maps,
                      const RegionMarks& among)
{
    maps.resize(plan);
    tables.bind();
    atlas.depth.bind(shared::kUnitAtlas);
    if (plan.lookup.preparedWords > 0) {
        maps.words.bindImage(shared::kImagePrepared);
        if (plan.lookup.hasMoreWords) maps.moreWords.bindImage(shared::kImageMoreWords);
        dispatch(plan, among, "WORDS");
    }
    if (plan.lookup.hasGradients) {
        maps.gradients.bindImage(shared::kImagePrepared);
        dispatch(plan, among, "GRADIENTS");
    }
    if (plan.lookup.momentChannels > 0) {
        maps.across.bindImage(shared::kImagePrepared);
        dispatch(plan, among, "ACROSS");
        maps.across.bind(shared::kUnitMoments);
        maps.moments.bindImage(shared::kImagePrepared);
        dispatch(plan, among, "ALONG");
    }
    maps.set(plan);
}

} // namespace lixel::gl
