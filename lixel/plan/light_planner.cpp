// SPDX-License-Identifier: MIT
#include "lixel/plan/light_planner.h"

#include "lixel/plan/fit/desired_view.h"
#include "lixel/plan/fit/focused.h"
#include "lixel/plan/fit/lispsm.h"
#include "lixel/plan/fit/minimal_frustum.h"
#include "lixel/plan/fit/paraboloid.h"
#include "lixel/plan/fit/plane_optimal.h"
#include "lixel/plan/fit/psm.h"
#include "lixel/plan/fit/scene_optimal.h"
#include "lixel/plan/fit/tsm.h"
#include "lixel/plan/fit/uniform.h"
#include "lixel/plan/fit/visible_body.h"
#include "lixel/plan/partition/cascades.h"
#include "lixel/plan/partition/cube.h"
#include "lixel/plan/partition/dual_paraboloid.h"
#include "lixel/plan/place.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

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
    FitResult operator()(const PlaneOptimalFit& fit) const { return fitPlaneOptimal(input, fit); }
    FitResult operator()(const SceneOptimalFit& fit) const { return fitSceneOptimal(input, fit); }
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
    CellsResult operator()(const DualParaboloidPartition&) const { return splitDualParaboloid(input); }
    CellsResult operator()(const PlanesPartition&) const { return Unexpected{FitFailure::NoSuchPlane}; }
};

// What the maps of paraboloids hold, by the fit that goes with them (technique.h has which do).
ParaboloidExtent extentOf(const FitChoice& fit)
{
    if (std::holds_alternative<UniformFit>(fit)) return ParaboloidExtent::Scene;
    return std::holds_alternative<DesiredViewFit>(fit) ? ParaboloidExtent::Samples : ParaboloidExtent::Body;
}

// Samples for energies are as many as a picture is observed by, and no more.
constexpr std::size_t kMostEdges = 1u << 16;

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

// Of half-spaces in float: of their numbers, three products and three sums.
constexpr double kFloatRounding = 4 * 0x1p-24;

// Whether a point is in a cell, by more than rounding of so much of the terms.
bool holdsPoint(const CellPlanes& cell, Vec3d p, double rounding = 0)
{
    return std::all_of(cell.begin(), cell.end(), [&](const Plane& plane) {
        const Vec3d n = plane.normal;
        const double terms = std::abs(n.x * p.x) + std::abs(n.y * p.y) + std::abs(n.z * p.z) + std::abs(plane.offset);
        return plane.signedDistance(p) >= rounding * terms;
    });
}

void gatherSeenIn(const CellPlanes& cell, std::span<const Vec3d> seenLocal, std::vector<Vec3d>& inside)
{
    inside.clear();
    for (const Vec3d& p : seenLocal)
        if (holdsPoint(cell, p)) inside.push_back(p);
}

// The planes of some names; nothing where one is not there.
std::optional<InterestPlanes> namedPlanes(const PlanesPartition& partition, const PlanInput& input, FitScratch& scratch)
{
    InterestPlanes out;
    for (const std::string& name : partition.names) {
        const auto found = std::find_if(input.planes.begin(), input.planes.end(),
                                        [&](const NamedPlane& plane) { return plane.name == name; });
        if (found == input.planes.end()) return std::nullopt;
        out.push_back(interestPlane(*found, input.originWorld, int(found - input.planes.begin()), scratch.plane));
    }
    return out;
}

} // namespace

LightPlanner::LightPlanner(const PlanInput& input, std::size_t number, const Box& sceneLocal, FitScratch& scratch)
    : input_(input),
      scratch_(scratch),
      fitInput_{input.view,
                input.lights[number],
                input.originWorld,
                input.casterBoxesWorld,
                sceneLocal,
                scratch,
                {},
                input.seen != nullptr,
                {},
                input.technique.isStable,
                {},
                input.technique.allocation == Allocation::Exact},
      predictor_(input.view, input.originWorld),
      number_(number)
{
    const Light& light = input.lights[number];
    gatherSeen(input, light, scratch);
    seenLocal_ = scratch.seenLocal;
    const NeedSource source{input.observed, number, scratch.seenLocal, scratch.seenNormal, &input.view};
    gatherNeedSamples(source, light, input.originWorld, scratch.boundaryDirections, scratch.need);
    fitInput_.seenIsAll = input.seenIsAll;
    fitInput_.mapAspect = double(input.lixels.width) / input.lixels.height;
    if (const SceneOptimalFit* fit = sceneOptimalOf(input.technique)) {
        gatherShadows(source, light, input.originWorld, scratch.scene.shadowsLocal);
        scratch.scene.edges.clear();
        if (isNewMapDue(*fit))
            gatherNeedSamples(source, light, input.originWorld, scratch.boundaryDirections, scratch.scene.edges,
                              {kMostEdges, kMostEdges, fit->awayFromBoundaries, true});
    }
}

// Whether some map is to be looked for, and not only kept.
bool LightPlanner::isNewMapDue(const SceneOptimalFit& fit) const
{
    if (number_ >= input_.before.size() || input_.before[number_].maps.empty()) return true;
    const std::vector<RememberedMap>& maps = input_.before[number_].maps;
    return std::any_of(maps.begin(), maps.end(), [&](const RememberedMap& map) { return isNewMapDueAfter(map, fit); });
}

std::optional<FitFailure> LightPlanner::choose(ShadowPlan& out)
{
    const auto* planes = std::get_if<PlanesPartition>(&input_.technique.partition);
    std::optional<FitFailure> refused;
    if (!planes) {
        refused = addElseTo(addAll(input_.technique.partition, input_.technique.fit));
    } else if (planes->names.empty()) {
        if (!input_.seen) return FitFailure::NoViewSamples;
        lookForPlanes(out.foundPlanes);
        refused = tryPlanes(planesThatPay(out.foundPlanes, planes->twist), planes->twist, out.leftOut);
    } else {
        const auto named = namedPlanes(*planes, input_, scratch_);
        if (!named) return FitFailure::NoSuchPlane;
        refused = tryPlanes(*named, planes->twist, out.leftOut);
    }
    if (refused) return refused;
    if (candidates_.empty()) return FitFailure::NothingInView;
    findNeeds();
    // The last one asks nothing, so that rounding loses no one between regions; but what its map cannot hold it never serves.
    Candidate& last = candidates_.back();
    last.halfSpacesLocal.clear();
    if (last.fit.narrowedToLocal) last.halfSpacesLocal.push_back(*last.fit.narrowedToLocal);
    return std::nullopt;
}

// What serves the rest, where there is any. What does not fit one map is split like a cube.
std::optional<FitFailure> LightPlanner::addElseTo(std::optional<FitFailure> refused)
{
    const auto& otherwise = input_.technique.otherwise;
    if (!otherwise || !(keepUnserved() || refused)) return refused;
    if (std::holds_alternative<PlanesPartition>(input_.technique.partition)) findUnservedRays();
    const std::size_t before = candidates_.size();
    std::optional<FitFailure> refusedToo = addAll(otherwise->partition, otherwise->fit);
    const bool isWhole = std::holds_alternative<WholePartition>(otherwise->partition);
    if (refusedToo == FitFailure::ExtentNotInHemisphere && isWhole)
        refusedToo = addAll(CubePartition{}, otherwise->fit);
    // Regions that were there serve what they can, but an else(...) promises the rest.
    if (refusedToo == FitFailure::NothingInView && before > 0) refusedToo.reset();
    return refusedToo;
}

// Regions of planes, and what serves the rest. A plane that has none is left out, with its reason; refused is only what leaves
// no region at all.
std::optional<FitFailure> LightPlanner::tryPlanes(const InterestPlanes& planes, Twist twist,
                                                  std::vector<LeftOutPlane>& leftOut)
{
    candidates_.clear();
    leftOut.clear();
    isCropping_ = false;
    fitInput_.visible = nullptr;
    seenLocal_ = triedLocal_.value_or(scratch_.seenLocal);
    fitInput_.cellLocal.clear();
    std::optional<FitFailure> refused = FitFailure::NoSuchPlane;
    if (!planes.empty()) {
        const CellsResult cells = splitPlanes(fitInput_, {planes.data(), planes.size()}, twist);
        for (const Cell& cell : *cells)
            if (const auto failure = add(cell, input_.technique.fit)) leftOut.push_back({cell.planeNumber, *failure});
        fitInput_.plane.reset();
        if (!candidates_.empty()) refused.reset();
        else refused = leftOut.front().why;
    }
    return addElseTo(refused);
}

std::optional<FitFailure> LightPlanner::addAll(const Partition& partition, const FitChoice& fit)
{
    fitInput_.cellLocal.clear();
    fitInput_.seenLocal = seenLocal_;
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

// The one that serves a receiver, also where its half-spaces are rounded by so much of their terms; nothing where none does.
LightPlanner::Candidate* LightPlanner::serving(Vec3d pointLocal, double rounding)
{
    const auto found = std::find_if(candidates_.begin(), candidates_.end(), [&](const Candidate& candidate) {
        if (!holdsPoint(candidate.halfSpacesLocal, pointLocal, rounding)) return false;
        const auto ndc = candidate.fit.projection().ndcAt(pointLocal);
        return ndc && std::abs(ndc->x) <= 1 && std::abs(ndc->y) <= 1 && ndc->z <= 1;
    });
    return found == candidates_.end() ? nullptr : found;
}

void LightPlanner::findNeeds()
{
    for (Candidate& candidate : candidates_) candidate.need = {};
    for (const NeedSample& sample : scratch_.need)
        if (Candidate* candidate = serving(sample.pointLocal)) candidate->need += predictor_.of(candidate->fit, sample);
}

// Samples near shadow boundaries for a fit in a cell.
void LightPlanner::gatherEdgesIn(const CellPlanes& cell)
{
    std::vector<NeedSample>&all = scratch_.scene.edges, &inside = scratch_.scene.edgesInCell;
    fitInput_.edges = all;
    fitInput_.shadowsLocal = scratch_.scene.shadowsLocal;
    if (cell.empty()) return;
    inside.clear();
    std::copy_if(all.begin(), all.end(), std::back_inserter(inside),
                 [&](const NeedSample& sample) { return holdsPoint(cell, sample.pointLocal); });
    fitInput_.edges = inside;
    gatherSeenIn(cell, scratch_.scene.shadowsLocal, scratch_.scene.shadowsInCell);
    fitInput_.shadowsLocal = scratch_.scene.shadowsInCell;
}

// From here on only those view samples count that no region holds. Whether there may be any such receiver.
bool LightPlanner::keepUnserved()
{
    if (!input_.seen) return true;
    scratch_.seenUnservedLocal.clear();
    for (const Vec3d& p : triedLocal_.value_or(scratch_.seenLocal))
        if (!serving(p, kFloatRounding)) scratch_.seenUnservedLocal.push_back(p);
    seenLocal_ = scratch_.seenUnservedLocal;
    return !seenLocal_.empty() || !input_.seenIsAll;
}

// C^fallback, the rays that regions so far do not serve: of all that may be seen, or, where regions hold view samples only and
// those are all, of the samples that are left.
void LightPlanner::findUnservedRays()
{
    const RaySpace space(fitInput_.light, input_.originWorld);
    const bool isOfSamples = std::any_of(candidates_.begin(), candidates_.end(),
                                         [](const Candidate& candidate) { return candidate.fit.isOfSamples; });
    fitInput_.cellLocal.clear();
    const bool isAllKnown = input_.seen && input_.seenIsAll;
    if (isOfSamples || (candidates_.empty() && isAllKnown)) {
        if (!isAllKnown) return;
        scratch_.pointsOfRays.assign(seenLocal_.begin(), seenLocal_.end());
        raysThrough(fitInput_, space, scratch_.pointsOfRays, scratch_.rays);
        isCropping_ = true;
        return;
    }
    fitInput_.visible = nullptr;
    findVisiblePoints(fitInput_, scratch_.pointsOfRays);
    visible_ = raysThrough(fitInput_, space, scratch_.pointsOfRays, scratch_.rays);
    if (visible_) {
        scratch_.cornersOfRays.assign(visible_->corners.begin(), visible_->corners.end());
        visible_->corners = scratch_.cornersOfRays;
        fitInput_.visible = &*visible_;
    }
    isCropping_ = takeAwayServed(space);
}

Plane LightPlanner::turnedToLight(const Plane& plane) const
{
    const Light& light = fitInput_.light;
    const double ofLight = light.kind == LightKind::Directional
                               ? -dot(plane.normal, light.directionWorld)
                               : plane.signedDistance(light.positionWorld - input_.originWorld);
    return ofLight < 0 ? Plane{-plane.normal, -plane.offset} : plane;
}

// Whether no receiver that may be asked for is outside.
bool LightPlanner::holdsAllSeen(const Plane& plane) const
{
    return input_.seen && input_.seenIsAll &&
           std::all_of(scratch_.seenLocal.begin(), scratch_.seenLocal.end(),
                       [&](Vec3d p) { return plane.signedDistance(p) >= 0; });
}

// False where some region is no set of rays.
bool LightPlanner::takeAwayServed(const RaySpace& space)
{
    const double sceneSize = fitInput_.sceneLocal.diagonal();
    for (const Candidate& candidate : candidates_) {
        if (candidate.fit.narrowedToLocal) return false;
        FixedVector<Vec3d, 2 * CellPlanes::capacity()> insides;
        for (const CellPlanes* planes : {&candidate.halfSpacesLocal, &candidate.fit.holdsLocal})
            for (const Plane& plane : *planes) {
                if (!space.holdsLight(plane, sceneSize)) {
                    if (!holdsAllSeen(plane)) return false;
                    continue;
                }
                insides.push_back(space.insideOf(plane));
            }
        subtract(scratch_.rays, {insides.data(), insides.size()}, scratch_.raysRoom);
    }
    return true;
}

// What of the fit the unserved rays of a cell need; nothing where there are none.
std::optional<Fit> LightPlanner::cropped(const Fit& fit, const Cell& cell)
{
    const RaySpace space(fitInput_.light, input_.originWorld);
    scratch_.raysRoom.assign(scratch_.rays.begin(), scratch_.rays.end());
    for (const Plane& plane : cell.holdsLocal) {
        if (!space.holdsLight(plane, fitInput_.sceneLocal.diagonal())) continue;
        for (RayPolygon& polygon : scratch_.raysRoom) polygon = clipped(polygon, space.insideOf(plane));
    }
    std::span<const Vec3d> held = scratch_.pointsOfRays;
    if (fit.isOfSamples) {
        held = fitInput_.seenLocal;
    } else if (!cell.holdsLocal.empty()) {
        findVisiblePoints(fitInput_, scratch_.points);
        held = scratch_.points;
    }
    return croppedTo(fit, space, scratch_.raysRoom, held, scratch_.plane);
}

std::optional<FitFailure> LightPlanner::add(const Cell& cell, const FitChoice& fit)
{
    fitInput_.cellLocal = cell.holdsLocal;
    fitInput_.plane = cell.plane;
    fitInput_.seenLocal = seenLocal_;
    if (!cell.holdsLocal.empty()) {
        gatherSeenIn(cell.holdsLocal, seenLocal_, scratch_.seenInCellLocal);
        fitInput_.seenLocal = scratch_.seenInCellLocal;
    }
    gatherEdgesIn(cell.holdsLocal);
    fitInput_.before = nullptr;
    if (number_ < input_.before.size() && candidates_.size() < input_.before[number_].maps.size())
        fitInput_.before = &input_.before[number_].maps[candidates_.size()];
    const FitResult result = cell.paraboloidAxis ? fitParaboloid(fitInput_, *cell.paraboloidAxis, extentOf(fit))
                                                 : std::visit(FitOf{fitInput_}, fit);
    if (!result) return result.error();
    std::optional<Fit> chosen = *result;
    if (isCropping_) chosen = cropped(*result, cell);
    if (!chosen) return FitFailure::NothingInView;
    Candidate candidate{*chosen, cell.servesLocal, cell.planeNumber, {}, {}};
    if (chosen->pixels && cell.plane) candidate.pixelPlaneLocal = turnedToLight(cell.plane->planeLocal);
    if (chosen->narrowedToLocal) candidate.halfSpacesLocal.push_back(*chosen->narrowedToLocal);
    candidates_.push_back(candidate);
    return std::nullopt;
}

// What a first pass left of the budget's rectangle, without rows or columns, whichever leaves more. Nothing where it took all.
std::optional<LixelRectangle> LightPlanner::leftOfBudget(int layer) const
{
    const auto [width, height] = input_.lixels;
    const auto spentOf = [&](int length) { return (input_.lixelsSpent + length - 1) / length; };
    const std::int64_t rows = height - spentOf(width), columns = width - spentOf(height);
    if (std::max(rows, columns) < 1) return std::nullopt;
    if (rows * width >= columns * height) return LixelRectangle{0, 0, width, int(rows), layer};
    return LixelRectangle{0, 0, int(columns), height, layer};
}

// Sizes where some maps have a lixel a pixel and a guard band around; the others share the rest, as squares. False where that is
// less than a lixel for each.
bool LightPlanner::sizeAll(const LookupLayout& lookup, std::span<LixelSize> sizes) const
{
    const int band = 2 * int(std::ceil(lookup.reach));
    auto left = std::int64_t(input_.lixels.width) * input_.lixels.height - input_.lixelsSpent;
    FixedVector<double, Candidates::capacity()> shares;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
        const auto& pixels = candidates_[i].fit.pixels;
        if (!pixels) {
            shares.push_back(candidates_[i].need.best());
            continue;
        }
        sizes[i] = {pixels->width() + band, pixels->height() + band};
        left -= std::int64_t(sizes[i].width) * sizes[i].height;
    }
    if (left < std::int64_t(shares.size())) return false;
    if (shares.empty()) return true;
    const std::int64_t all = left;
    sharesByNeed({shares.data(), shares.size()});
    std::size_t next = 0;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
        if (candidates_[i].fit.pixels) continue;
        // A lixel is kept for each that is still to come.
        const std::int64_t most = left - std::int64_t(shares.size() - next - 1);
        const double share = shares[next] * double(all);
        const int side = std::max(1, int(std::sqrt(std::min(share, double(most)))));
        sizes[i] = {side, side};
        left -= std::int64_t(side) * side, ++next;
    }
    return true;
}

bool LightPlanner::placeAll(int layer, const LookupLayout& lookup, LixelSize& atlas,
                            std::vector<PlannedRegion>& regions)
{
    FixedVector<LixelRectangle, Candidates::capacity()> rectangles;
    FixedVector<double, Candidates::capacity()> shares;
    FixedVector<Need, Candidates::capacity()> needs;
    FixedVector<LixelSize, Candidates::capacity()> sizes;
    FixedVector<bool, Candidates::capacity()> turned;
    const bool isByNeed = input_.technique.allocation == Allocation::Need;
    double known = 0;
    for (const Candidate& candidate : candidates_) {
        rectangles.push_back({});
        shares.push_back(isByNeed ? candidate.need.best() : 0);
        known += shares.back();
        needs.push_back(candidate.need);
        sizes.push_back({});
        turned.push_back(false);
    }
    bool areTurned = false; // whether `turned` says so
    const std::span<LixelRectangle> pieces{rectangles.data(), rectangles.size()};
    std::span<const LixelSize> given = input_.lixelsOfRegions;
    if (given.size() != pieces.size() || input_.lixelsSpent > 0) given = {};
    if (fitInput_.wantsWholePixels) {
        if (!sizeAll(lookup, {sizes.data(), sizes.size()})) return false;
        given = {sizes.data(), sizes.size()};
    }
    if (given.empty()) {
        const auto whole = leftOfBudget(layer);
        if (!whole) return false;
        sharesByNeed({shares.data(), shares.size()});
        areTurned = known > 0 && std::isfinite(known);
        const bool isCut =
            areTurned ? cutRectangleByNeed(*whole, {shares.data(), shares.size()}, {needs.data(), needs.size()}, pieces,
                                           {turned.data(), turned.size()}, lookup.reach)
                      : cutRectangle(*whole, {shares.data(), shares.size()}, pieces);
        if (!isCut) return false;
        atlas = {std::max(atlas.width, input_.lixels.width), std::max(atlas.height, input_.lixels.height)};
    } else {
        const LixelSize packed = packRectangles(given, layer, pieces);
        atlas = {std::max(atlas.width, packed.width), std::max(atlas.height, packed.height)};
    }
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
        const LightProjection placed = place(candidates_[i].fit, pieces[i], lookup, input_.originWorld,
                                             areTurned ? std::optional(turned[i]) : std::nullopt);
        regions.push_back({placed.lightClipFromLocal,
                           pieces[i],
                           candidates_[i].halfSpacesLocal,
                           i + 1 < candidates_.size() ? guardBand(pieces[i], lookup) : Vec2d{},
                           candidates_[i].plane,
                           needsDouble(candidates_[i].fit, pieces[i].width(), pieces[i].height()),
                           candidates_[i].fit.pixels,
                           candidates_[i].pixelPlaneLocal,
                           {candidates_[i].fit.lightClipFromLocal, homogeneousWorld(fitInput_.light),
                            candidates_[i].fit.framesKept, candidates_[i].fit.rounding}});
        regions.back().paraboloid = placed.paraboloid;
    }
    return true;
}

} // namespace lixel
