// SPDX-License-Identifier: MIT
#include "lixel/plan/shadow_plan.h"

#include "lixel/plan/light_planner.h"
#include "lixel/plan/region_table.h"
#include "lixel/plan/warp/region_warps.h"

#include <algorithm>
#include <cmath>

namespace lixel {
namespace {

// A first pass has one lixel in so many: shadows need only be found, not drawn.
constexpr double kFirstPassOfAll = 16;

// Warps are led by boundaries themselves, not by sums over them: 384 cells a side had 4 % fewer errors than 180.
constexpr ObservationGrid kGridOfWarps{256, 256};

bool isGiven(const FitChoice& fit)
{
    return std::holds_alternative<MatrixFit>(fit) || std::holds_alternative<PlanFit>(fit);
}

// Another engine's regions, as they are.
std::optional<FitFailure> takeGiven(const PlanInput& input, const Light& light, int layer, LixelSize& atlas,
                                    std::vector<PlannedRegion>& regions)
{
    const auto found = std::find_if(input.given.begin(), input.given.end(), [&](const GivenLight& given) {
        return given.light.empty() || given.light == light.name;
    });
    if (found == input.given.end() || found->regions.empty()) return FitFailure::NotGiven;
    for (const GivenRegion& region : found->regions) {
        PlannedRegion planned;
        planned.lightClipFromLocal = region.lightClipFromWorld * translation(input.originWorld);
        planned.rectangle =
            region.rectangle.value_or(LixelRectangle{0, 0, input.lixels.width, input.lixels.height, layer});
        planned.rectangle.layer = layer;
        for (const Plane& plane : region.halfSpacesWorld)
            planned.halfSpacesLocal.push_back({plane.normal, plane.offset + dot(plane.normal, input.originWorld)});
        atlas = {std::max(atlas.width, planned.rectangle.x1), std::max(atlas.height, planned.rectangle.y1)};
        regions.push_back(planned);
    }
    return std::nullopt;
}

void appendTables(const ShadowPlan& light, FramePlan& plan)
{
    shared::ShadowLight row;
    row.regions = {float(plan.regionTable.size()), float(light.regions.size()), light.refused ? 0.0f : 1.0f, 0};
    for (const PlannedRegion& region : light.regions) {
        shared::ShadowRegion entry = tableRow(region);
        entry.place.y = float(plan.halfSpaceTable.size());
        entry.place.z = float(region.halfSpacesLocal.size());
        for (const Plane& p : region.halfSpacesLocal)
            plan.halfSpaceTable.push_back({float(p.normal.x), float(p.normal.y), float(p.normal.z), float(p.offset)});
        entry.warp = appendWarp(region.warp, plan.warpTable);
        plan.regionTable.push_back(entry);
    }
    plan.lightTable.push_back(row);
}

} // namespace

std::int64_t FramePlan::lixelsOf(std::size_t light) const
{
    std::int64_t sum = lixelsSpent;
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

std::vector<LightMemory> rememberedBy(const FramePlan& plan)
{
    std::vector<LightMemory> out;
    for (const ShadowPlan& light : plan.lights) {
        LightMemory& memory = out.emplace_back();
        for (std::size_t i = 0; i < light.foundPlanes.size(); ++i) {
            const bool hadRegion = std::any_of(light.regions.begin(), light.regions.end(),
                                               [&](const PlannedRegion& region) { return region.plane == int(i); });
            memory.planes.push_back({light.foundPlanes[i].planeLocal, hadRegion});
        }
        for (const PlannedRegion& region : light.regions) memory.maps.push_back(region.fit);
    }
    return out;
}

std::optional<FirstPass> firstPassOf(const MapTechnique& technique, LixelSize lixels)
{
    const auto* planes = std::get_if<PlanesPartition>(&technique.partition);
    const SceneOptimalFit* sceneOptimal = sceneOptimalOf(technique);
    const WarpOptions* warp = warpOptionsOf(technique.warp);
    const bool isSteered = warp && warp->importance.has(kBoundariesWeight);
    if (!sceneOptimal && !isSteered && (!planes || !planes->names.empty())) return std::nullopt;
    MapTechnique first; // focused
    first.otherwise = Fallback{CubePartition{}, FocusedFit{}};
    const double lixelsInAll = double(lixels.width) * lixels.height / kFirstPassOfAll;
    const int side = std::max(1, int(std::sqrt(lixelsInAll)));
    const ObservationGrid grid = sceneOptimal ? ObservationGrid{sceneOptimal->samples, sceneOptimal->samples}
                                 : isSteered  ? kGridOfWarps
                                              : ObservationGrid{};
    return FirstPass{first, {side, side}, grid};
}

FramePlan planShadows(const PlanInput& input)
{
    FitScratch scratch;
    return planShadows(input, scratch);
}

FramePlan planShadows(const PlanInput& input, FitScratch& scratch, FramePlan recycled)
{
    LX_ASSERT(input.lixels.width > 0 && input.lixels.height > 0);
    LX_ASSERT(!input.seen || input.seen->originWorld == input.originWorld);
    FramePlan plan = std::move(recycled);
    recycleKnots(plan, scratch.warps);
    plan.atlas = {1, 1};
    plan.lookup = lookupLayout(input.technique);
    plan.originWorld = input.originWorld;
    plan.lixelsSpent = input.lixelsSpent;
    plan.lights.resize(input.lights.size());
    plan.regionTable.clear();
    plan.halfSpaceTable.clear();
    plan.lightTable.clear();
    plan.warpTable.clear();
    plan.layers = 0;

    Box sceneWorld;
    for (const Box& box : input.casterBoxesWorld) sceneWorld.include(box);
    const Box sceneLocal = translated(sceneWorld, -input.originWorld);

    // A layer a light, cut up among its regions.
    for (std::size_t i = 0; i < input.lights.size(); ++i) {
        ShadowPlan& light = plan.lights[i];
        light.regions.clear();
        light.leftOut.clear();
        light.foundPlanes.clear();
        if (isGiven(input.technique.fit)) {
            light.refused = takeGiven(input, input.lights[i], plan.layers, plan.atlas, light.regions);
        } else {
            LightPlanner planner(input, i, sceneLocal, scratch);
            light.refused = planner.choose(light);
            if (!light.refused && !planner.placeAll(plan.layers, plan.lookup, plan.atlas, light.regions))
                light.refused = FitFailure::TooFewLixels;
            const std::span<const ViewSamples> seenByLight =
                i < input.seenByLights.size() ? std::span(input.seenByLights[i]) : std::span<const ViewSamples>{};
            warpRegions({input.view, input.lights[i], input.originWorld, input.seen, seenByLight, input.observed, i},
                        input.technique.warp, plan.lookup, scratch.warps, light.regions);
            warpParaboloids(rasterOf(input.technique), scratch.warps, light.regions);
        }
        if (!light.refused) ++plan.layers;
        appendTables(light, plan);
    }
    return plan;
}

} // namespace lixel
