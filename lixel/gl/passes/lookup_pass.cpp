// SPDX-License-Identifier: MIT
#include "lixel/gl/passes/lookup_pass.h"

#include "lixel/base/assert.h"
#include "lixel/shared/gl_slots.h"
#include "lixel/shared/paraboloid.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <string>
#include <vector>

namespace lixel::gl {
namespace {

// Locations in lookup.comp.glsl.
constexpr int kPointCount = 0, kLight = 1, kTapsPerSide = 2;

// What lixel_lookup.glsl has for hosts: the smallest of the programs.
bool isOneDepth(const shared::LxLookup& how)
{
    return how.store == shared::LX_STORE_DEPTH && how.kernel == shared::LX_KERNEL_GRID && how.isDualPlane == 0;
}

} // namespace

LookupPass::LookupPass() : comparing_(makeComparingSampler()) {}

void LookupPass::run(const FramePlan& plan, const PlanTables& tables, const Maps& maps, const PointList& points,
                     VisibilityList& visibility)
{
    LX_ASSERT(points.originWorld() == plan.originWorld);
    LX_ASSERT(!plan.lookup.isPrepared() || maps.prepared.areFor(plan));
    visibility.resize(points, plan.lights.size());
    tables.bind();
    maps.atlas.depth.bind(shared::kUnitAtlas);
    maps.atlas.depth.bind(shared::kUnitHardware, comparing_);
    maps.prepared.bind();
    std::vector<std::string> defines;
    const auto anyRegion = [&](auto is) { return std::any_of(plan.regionTable.begin(), plan.regionTable.end(), is); };
    if (!anyRegion([](const shared::ShadowRegion& region) { return region.place.w > 0; }))
        defines.emplace_back("LIXEL_NO_DOUBLE");
    if (!anyRegion([](const shared::ShadowRegion& region) { return region.warp.kind.x > 0; }))
        defines.emplace_back("LIXEL_NO_WARP");
    if (!anyRegion([](const shared::ShadowRegion& region) { return shared::lxIsOnParaboloid(region); }))
        defines.emplace_back("LIXEL_NO_PARABOLOID");
    if (!isOneDepth(plan.lookup.how)) defines.push_back(lookupDefine(plan.lookup.how));
    const Program& program = programs_.with(defines);
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
