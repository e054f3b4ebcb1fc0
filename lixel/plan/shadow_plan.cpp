// SPDX-License-Identifier: MIT
#include "lixel/plan/shadow_plan.h"

#include "lixel/plan/clip_convention.h"
#include "lixel/plan/fit/desired_view.h"
#include "lixel/plan/fit/focused.h"
#include "lixel/plan/fit/lispsm.h"
#include "lixel/plan/fit/minimal_frustum.h"
#include "lixel/plan/fit/psm.h"
#include "lixel/plan/fit/tsm.h"
#include "lixel/plan/fit/uniform.h"
#include "lixel/plan/partition/cascades.h"
#include "lixel/plan/partition/cube.h"
#include "lixel/plan/place.h"

#include <algorithm>
#include <cmath>

namespace lixel {
namespace {

struct FitOf
{
    const FitInput& input;
    FitResult operator()(const UniformFit&) const { return fitUniform(input); }
    FitResult operator()(const FocusedFit&) const { return fitFocused(input); }
    FitResult operator()(const DesiredViewFit& fit) const { return fitDesiredView(input, fit.isRotated); }
    FitResult operator()(const MinimalFrustumFit&) const { return fitMinimalFrustum(input); }
    FitResult operator()(const PsmFit& fit) const { return fitPsm(input, fit.shift); }
    FitResult operator()(const TsmFit& fit) const { return fitTsm(input, fit.focusDepth); }
    FitResult operator()(const LispsmFit&) const { return fitLispsm(input); }
    FitResult operator()(const MatrixFit&) const { return Unexpected{FitFailure::NotGiven}; }
    FitResult operator()(const PlanFit&) const { return Unexpected{FitFailure::NotGiven}; }
};

struct CellsOf
{
    const FitInput& input;
    CellsResult operator()(const WholePartition&) const { return wholeSpace(); }
    CellsResult operator()(const PssmPartition& p) const { return splitPssm(input, p.count, p.lambda); }
    CellsResult operator()(const SdsmPartition& p) const { return splitSdsm(input, p.count); }
    CellsResult operator()(const CubePartition&) const { return splitCube(input); }
};

shared::ShadowRegion tableRow(const PlannedRegion& region)
{
    const LixelRectangle& r = region.rectangle;
    shared::ShadowRegion row;
    row.lightClipFromLocal = toShared(toHost(region.lightClipFromLocal, kExecutorConvention));
    row.lixelFromNdc = {0.5f * float(r.width()), 0.5f * float(r.height()), float(r.x0) + 0.5f * float(r.width()),
                        float(r.y0) + 0.5f * float(r.height())};
    row.rectangle = {float(r.x0), float(r.y0), float(r.x1), float(r.y1)};
    row.place = {float(r.layer), 0, 0, 0}; // half-spaces: appendTables
    return row;
}

bool isGiven(const FitChoice& fit)
{
    return std::holds_alternative<MatrixFit>(fit) || std::holds_alternative<PlanFit>(fit);
}

// The receivers that one light's maps are for: those of the view samples that face it.
void gatherSeen(const PlanInput& input, const Light& light, FitScratch& scratch)
{
    scratch.seenLocal.clear();
    scratch.seenNormal.clear();
    if (!input.seen) return;
    for (std::size_t i = 0; i < input.seen->size(); ++i) {
        const Vec3d p = toDouble(input.seen->positionLocal[i]), n = toDouble(input.seen->normal[i]);
        if (!isLightFacing(light, input.originWorld, p, n)) continue;
        scratch.seenLocal.push_back(p);
        scratch.seenNormal.push_back(n);
    }
}

void gatherSeenIn(const CellPlanes& cell, FitScratch& scratch)
{
    scratch.seenInCellLocal.clear();
    scratch.seenInCellNormal.clear();
    for (std::size_t i = 0; i < scratch.seenLocal.size(); ++i) {
        const Vec3d p = scratch.seenLocal[i];
        if (std::any_of(cell.begin(), cell.end(), [&](const Plane& plane) { return plane.signedDistance(p) < 0; }))
            continue;
        scratch.seenInCellLocal.push_back(p);
        scratch.seenInCellNormal.push_back(scratch.seenNormal[i]);
    }
}

// One region before it has lixels.
struct Candidate
{
    Fit fit;
    CellPlanes halfSpacesLocal;
    double share = 0; // its need first
};
using Candidates = FixedVector<Candidate, 2 * kMostCells>;

// The plan of one light: cells, a fit in each, lixels for each, each in its place.
class LightPlanner
{
public:
    LightPlanner(const PlanInput& input, const Light& light, const Box& sceneLocal, FitScratch& scratch)
        : input_(input),
          scratch_(scratch),
          fitInput_{input.view,
                    light,
                    input.originWorld,
                    input.casterBoxesWorld,
                    sceneLocal,
                    scratch,
                    {},
                    input.seen != nullptr,
                    {},
                    input.technique.isStable}
    {
        gatherSeen(input, light, scratch);
    }

    // What was refused, if anything; then nothing of the light is served.
    std::optional<FitFailure> choose()
    {
        const MapTechnique& technique = input_.technique;
        std::optional<FitFailure> refused = addAll(technique.partition, technique.fit);
        if (technique.otherwise && (keepUnserved() || refused)) {
            const std::optional<FitFailure> refusedToo =
                addAll(technique.otherwise->partition, technique.otherwise->fit);
            if (refused) refused = refusedToo;
        }
        if (refused) return refused;
        if (candidates_.empty()) return FitFailure::NothingInView;
        candidates_.back().halfSpacesLocal.clear(); // so that rounding loses no one between regions
        return std::nullopt;
    }

    // Into rectangles of one layer. False where there are too few lixels.
    bool placeAll(int layer, const LookupLayout& lookup, LixelSize& atlas, std::vector<PlannedRegion>& regions)
    {
        FixedVector<LixelRectangle, Candidates::capacity()> rectangles;
        FixedVector<double, Candidates::capacity()> shares;
        for (const Candidate& candidate : candidates_) {
            rectangles.push_back({});
            shares.push_back(input_.technique.allocation == Allocation::Need ? candidate.share : 0);
        }
        const std::span<LixelRectangle> pieces{rectangles.data(), rectangles.size()};
        if (input_.lixelsOfRegions.empty()) {
            sharesByNeed({shares.data(), shares.size()});
            if (!cutRectangle({0, 0, input_.lixels.width, input_.lixels.height, layer}, {shares.data(), shares.size()},
                              pieces))
                return false;
            atlas = input_.lixels;
        } else {
            if (input_.lixelsOfRegions.size() < pieces.size()) return false;
            const LixelSize packed = packRectangles(input_.lixelsOfRegions.first(pieces.size()), layer, pieces);
            atlas = {std::max(atlas.width, packed.width), std::max(atlas.height, packed.height)};
        }
        for (std::size_t i = 0; i < candidates_.size(); ++i)
            regions.push_back({place(candidates_[i].fit, pieces[i], lookup, input_.originWorld), pieces[i],
                               candidates_[i].halfSpacesLocal});
        return true;
    }

private:
    std::optional<FitFailure> addAll(const Partition& partition, const FitChoice& fit)
    {
        fitInput_.cellLocal.clear();
        fitInput_.seenLocal = scratch_.seenLocal;
        const CellsResult cells = std::visit(CellsOf{fitInput_}, partition);
        if (!cells) return cells.error();
        std::optional<FitFailure> refused;
        for (const Cell& cell : *cells) {
            const auto failure = add(cell, fit);
            // Nothing to see in one cell is no loss.
            if (failure && *failure != FitFailure::NothingInView) refused = failure;
        }
        return refused;
    }

    bool isServed(Vec3d pointLocal) const
    {
        return std::any_of(candidates_.begin(), candidates_.end(), [&](const Candidate& candidate) {
            for (const Plane& plane : candidate.halfSpacesLocal)
                if (plane.signedDistance(pointLocal) < 0) return false;
            const Vec4d c = candidate.fit.lightClipFromLocal * point(pointLocal);
            return c.w > 0 && std::abs(c.x) <= c.w && std::abs(c.y) <= c.w && c.z <= c.w;
        });
    }

    // Leaves only those view samples that no region holds. Whether there may be any such receiver.
    bool keepUnserved()
    {
        if (!input_.seen) return true;
        std::size_t kept = 0;
        for (std::size_t i = 0; i < scratch_.seenLocal.size(); ++i) {
            if (isServed(scratch_.seenLocal[i])) continue;
            scratch_.seenLocal[kept] = scratch_.seenLocal[i];
            scratch_.seenNormal[kept++] = scratch_.seenNormal[i];
        }
        scratch_.seenLocal.resize(kept);
        scratch_.seenNormal.resize(kept);
        return kept > 0 || !input_.seenIsAll;
    }

    std::optional<FitFailure> add(const Cell& cell, const FitChoice& fit)
    {
        fitInput_.cellLocal = cell.holdsLocal;
        std::span<const Vec3d> normals = scratch_.seenNormal;
        fitInput_.seenLocal = scratch_.seenLocal;
        if (!cell.holdsLocal.empty()) {
            gatherSeenIn(cell.holdsLocal, scratch_);
            fitInput_.seenLocal = scratch_.seenInCellLocal;
            normals = scratch_.seenInCellNormal;
        }
        const FitResult result = std::visit(FitOf{fitInput_}, fit);
        if (!result) return result.error();
        const double need = needOf(*result, input_.view, input_.originWorld, fitInput_.seenLocal, normals);
        candidates_.push_back({*result, cell.servesLocal, need});
        return std::nullopt;
    }

    const PlanInput& input_;
    FitScratch& scratch_;
    FitInput fitInput_;
    Candidates candidates_;
};

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
        plan.regionTable.push_back(entry);
    }
    plan.lightTable.push_back(row);
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
    LX_ASSERT(!input.seen || input.seen->originWorld == input.originWorld);
    FramePlan plan = std::move(recycled);
    plan.atlas = {1, 1};
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

    // A layer a light, cut up among its regions.
    for (std::size_t i = 0; i < input.lights.size(); ++i) {
        ShadowPlan& light = plan.lights[i];
        light.regions.clear();
        if (isGiven(input.technique.fit)) {
            light.refused = takeGiven(input, input.lights[i], plan.layers, plan.atlas, light.regions);
        } else {
            LightPlanner planner(input, input.lights[i], sceneLocal, scratch);
            light.refused = planner.choose();
            if (!light.refused && !planner.placeAll(plan.layers, plan.lookup, plan.atlas, light.regions))
                light.refused = FitFailure::TooFewLixels;
        }
        if (!light.refused) ++plan.layers;
        appendTables(light, plan);
    }
    return plan;
}

} // namespace lixel
