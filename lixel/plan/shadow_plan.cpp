// SPDX-License-Identifier: MIT
#include "lixel/plan/shadow_plan.h"

#include "lixel/plan/clip_convention.h"
#include "lixel/plan/fit/focused.h"
#include "lixel/plan/fit/uniform.h"
#include "lixel/plan/place.h"

namespace lixel {
namespace {

struct FitOf
{
    const FitInput& input;
    FitResult operator()(const UniformFit&) const { return fitUniform(input); }
    FitResult operator()(const FocusedFit&) const { return fitFocused(input); }
};

shared::ShadowRegion tableRow(const PlannedRegion& region)
{
    const LixelRectangle& r = region.rectangle;
    shared::ShadowRegion row;
    row.lightClipFromLocal = toShared(toHost(region.lightClipFromLocal, kExecutorConvention));
    row.lixelFromNdc = {0.5f * float(r.width()), 0.5f * float(r.height()), float(r.x0) + 0.5f * float(r.width()),
                        float(r.y0) + 0.5f * float(r.height())};
    row.rectangle = {float(r.x0), float(r.y0), float(r.x1), float(r.y1)};
    row.place = {float(r.layer), 0, 0, 0};
    return row;
}

} // namespace

std::int64_t FramePlan::lixelsOf(std::size_t light) const
{
    std::int64_t sum = 0;
    for (const PlannedRegion& region : lights[light].regions)
        sum += std::int64_t(region.rectangle.width()) * region.rectangle.height();
    return sum;
}

shared::mat4 toShared(const Mat4d& matrix)
{
    shared::mat4 out;
    for (int column = 0; column < 4; ++column)
        out[column] = {float(matrix.m[0][column]), float(matrix.m[1][column]), float(matrix.m[2][column]),
                       float(matrix.m[3][column])};
    return out;
}

FramePlan planShadows(const PlanInput& input)
{
    FitScratch scratch;
    return planShadows(input, scratch);
}

FramePlan planShadows(const PlanInput& input, FitScratch& scratch, FramePlan recycled)
{
    LX_ASSERT(input.lixels.width > 0 && input.lixels.height > 0);
    FramePlan plan = std::move(recycled);
    plan.atlas = input.lixels;
    plan.lookup = lookupLayout(input.technique.store, input.technique.kernel);
    plan.originWorld = input.originWorld;
    plan.lights.resize(input.lights.size());
    plan.regionTable.clear();
    plan.halfSpaceTable.clear();
    plan.lightTable.clear();
    plan.layers = 0;

    Box sceneWorld;
    for (const Box& box : input.casterBoxesWorld) sceneWorld.include(box);
    const Box sceneLocal = translated(sceneWorld, -input.originWorld);

    // A layer a light; the one region of `whole` takes all of it.
    for (std::size_t i = 0; i < input.lights.size(); ++i) {
        ShadowPlan& light = plan.lights[i];
        light.regions.clear();
        light.refused.reset();
        const FitInput fitInput{input.view, input.lights[i], input.originWorld, input.casterBoxesWorld,
                                sceneLocal, scratch};
        const FitResult fit = std::visit(FitOf{fitInput}, input.technique.fit);
        shared::ShadowLight row;
        row.regions = {float(plan.regionTable.size()), 0, 0, 0};
        if (fit) {
            const LixelRectangle rectangle{0, 0, input.lixels.width, input.lixels.height, plan.layers++};
            light.regions.push_back({place(*fit, rectangle, plan.lookup), rectangle});
            plan.regionTable.push_back(tableRow(light.regions.back()));
            row.regions.y = 1;
            row.regions.z = 1;
        } else {
            light.refused = fit.error();
        }
        plan.lightTable.push_back(row);
    }
    return plan;
}

} // namespace lixel
