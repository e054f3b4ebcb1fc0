// SPDX-License-Identifier: MIT
#include "lixel/gl/passes/lookup_pass.h"

#include "lixel/base/assert.h"
#include "lixel/shared/gl_slots.h"

#include <epoxy/gl.h>

namespace lixel::gl {
namespace {

// Locations in lookup.comp.glsl.
constexpr int kPointCount = 0, kLight = 1, kTapsPerSide = 2;

} // namespace

LookupPass::LookupPass() : program_(Program::compute("lookup.comp.glsl")) {}

void LookupPass::run(const FramePlan& plan, const PlanTables& tables, const ShadowAtlas& atlas, const PointList& points,
                     VisibilityList& visibility) const
{
    LX_ASSERT(points.originWorld() == plan.originWorld);
    visibility.resize(points, plan.lights.size());
    tables.bind();
    atlas.depth.bind(shared::kUnitAtlas);
    program_.set(kTapsPerSide, plan.lookup.tapsPerSide);
    program_.use();
    for (const PointList::Part& part : visibility.parts()) {
        points.bind(part);
        visibility.bind(part);
        program_.set(kPointCount, std::uint32_t(part.count));
        for (std::size_t light = 0; light < plan.lights.size(); ++light) {
            program_.set(kLight, int(light));
            glDispatchCompute(GLuint((part.count + 63) / 64), 1, 1);
        }
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

} // namespace lixel::gl
