// SPDX-License-Identifier: MIT
#include "lixel/gl/passes/lookup_pass.h"

#include "lixel/base/assert.h"
#include "lixel/shared/gl_slots.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <string>
#include <vector>

namespace lixel::gl {
namespace {

// Locations in lookup.comp.glsl.
constexpr int kPointCount = 0, kLight = 1, kTapsPerSide = 2;

} // namespace

const Program& LookupPass::programFor(bool isInDouble, bool isWarped)
{
    Program& program = programs_[isInDouble][isWarped];
    if (program.name()) return program;
    std::vector<std::string> defines;
    if (!isInDouble) defines.push_back("LIXEL_NO_DOUBLE");
    if (!isWarped) defines.push_back("LIXEL_NO_WARP");
    program = Program::compute("lookup.comp.glsl", defines);
    return program;
}

void LookupPass::run(const FramePlan& plan, const PlanTables& tables, const ShadowAtlas& atlas, const PointList& points,
                     VisibilityList& visibility)
{
    LX_ASSERT(points.originWorld() == plan.originWorld);
    visibility.resize(points, plan.lights.size());
    tables.bind();
    atlas.depth.bind(shared::kUnitAtlas);
    const auto anyRegion = [&](auto is) { return std::any_of(plan.regionTable.begin(), plan.regionTable.end(), is); };
    const bool isInDouble = anyRegion([](const shared::ShadowRegion& region) { return region.place.w > 0; });
    const bool isWarped = anyRegion([](const shared::ShadowRegion& region) { return region.warp.kind.x > 0; });
    const Program& program = programFor(isInDouble, isWarped);
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
