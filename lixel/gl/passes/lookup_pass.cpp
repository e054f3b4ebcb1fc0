// SPDX-License-Identifier: MIT
#include "lixel/gl/passes/lookup_pass.h"

#include "lixel/base/assert.h"
#include "lixel/shared/gl_slots.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <string>

namespace lixel::gl {
namespace {

// Locations in lookup.comp.glsl.
constexpr int kPointCount = 0, kLight = 1, kTapsPerSide = 2;

} // namespace

LookupPass::LookupPass() : inDouble_(Program::compute("lookup.comp.glsl"))
{
    const std::array<std::string, 1> floats{"LIXEL_NO_DOUBLE"};
    program_ = Program::compute("lookup.comp.glsl", floats);
}

void LookupPass::run(const FramePlan& plan, const PlanTables& tables, const ShadowAtlas& atlas, const PointList& points,
                     VisibilityList& visibility) const
{
    LX_ASSERT(points.originWorld() == plan.originWorld);
    visibility.resize(points, plan.lights.size());
    tables.bind();
    atlas.depth.bind(shared::kUnitAtlas);
    const bool isInDouble = std::any_of(plan.regionTable.begin(), plan.regionTable.end(),
                                        [](const shared::ShadowRegion& region) { return region.place.w > 0; });
    const Program& program = isInDouble ? inDouble_ : program_;
    program.set(kTapsPerSide, plan.lookup.tapsPerSide);
    program.use();
    for (const PointList::Part& part : visibility.parts()) {
        points.bind(part);
        visibility.bind(part);
        program.set(kPointCount, std::uint32_t(part.count));
        for (std::size_t light = 0; light < plan.lights.size(); ++light) {
            program.set(kLight, int(light));
            glDispatchCompute(GLuint((part.count + 63) / 64), 1, 1);
        }
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

} // namespace lixel::gl
