// SPDX-License-Identifier: MIT
#include "lixel/plan/warp/region_warps.h"

#include "lixel/plan/partition/partition.h"
#include "lixel/plan/shadow_plan.h"
#include "lixel/plan/warp/now.h"
#include "lixel/plan/warp/rtw.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace lixel {
namespace {

constexpr std::uint8_t kUnserved = 0xff;
static_assert(2 * kMostCells < kUnserved, "regions of a light are numbered in a byte");

// Continuous lixel of a point before the warp; nothing where the region does not serve it.
std::optional<Vec2d> lixelIn(const PlannedRegion& region, Vec3d p)
{
    for (const Plane& plane : region.halfSpacesLocal)
        if (plane.signedDistance(p) < 0) return std::nullopt;
    const auto ndc = region.projection().ndcAt(p);
    if (!ndc || ndc->z > 1) return std::nullopt;
    const LixelRectangle& r = region.rectangle;
    const Vec2d at{r.x0 + (0.5 + 0.5 * ndc->x) * r.width(), r.y0 + (0.5 + 0.5 * ndc->y) * r.height()};
    const bool isInside = at.x >= r.x0 + region.guard.x && at.x < r.x1 - region.guard.x &&
                          at.y >= r.y0 + region.guard.y && at.y < r.y1 - region.guard.y;
    return isInside ? std::optional(at) : std::nullopt;
}

void assignSamples(std::span<const PlannedRegion> regions, RegionWarpScratch& scratch)
{
    scratch.regionOf.assign(scratch.samples.size(), kUnserved);
    for (std::size_t i = 0; i < scratch.samples.size(); ++i) {
        const Vec3d p = toDouble(scratch.samples[i].positionLocal);
        const auto found = std::find_if(regions.begin(), regions.end(),
                                        [&](const PlannedRegion& r) { return lixelIn(r, p).has_value(); });
        if (found != regions.end()) scratch.regionOf[i] = std::uint8_t(found - regions.begin());
    }
}

// In the square of their region; those in guard bands are not moved, and do not count.
void placeSamples(const PlannedRegion& region, const LixelRectangle& square, std::uint8_t number,
                  RegionWarpScratch& scratch)
{
    scratch.placed.clear();
    for (std::size_t i = 0; i < scratch.samples.size(); ++i) {
        if (scratch.regionOf[i] != number) continue;
        const Vec2d at = lixelIn(region, toDouble(scratch.samples[i].positionLocal)).value();
        const auto x = float((at.x - square.x0) / square.width()), y = float((at.y - square.y0) / square.height());
        if (x < 0 || y < 0 || x >= 1 || y >= 1) continue;
        scratch.placed.push_back({x, y, scratch.samples[i].units});
    }
}

std::vector<float> takeSpare(RegionWarpScratch& scratch)
{
    if (scratch.spareKnots.empty()) return {};
    std::vector<float> knots = std::move(scratch.spareKnots.back());
    scratch.spareKnots.pop_back();
    return knots;
}

} // namespace

// The first one goes on top, so that each region finds its own again.
void recycleKnots(FramePlan& plan, RegionWarpScratch& scratch)
{
    for (auto light = plan.lights.rbegin(); light != plan.lights.rend(); ++light)
        for (auto region = light->regions.rbegin(); region != light->regions.rend(); ++region) {
            if (region->warp.isIdentity()) continue;
            scratch.spareKnots.push_back(std::move(region->warp.columnKnots));
            scratch.spareKnots.push_back(std::move(region->warp.rowKnots));
            region->warp = {};
        }
}

namespace {

// Nothing where a region has no room for one.
std::optional<LixelRectangle> squareOf(const PlannedRegion& region, const LookupLayout& lookup)
{
    const LixelRectangle& r = region.rectangle;
    const int band = int(std::ceil(lookup.reach));
    if (std::min(r.width(), r.height()) <= 2 * band) return std::nullopt;
    return LixelRectangle{r.x0 + band, r.y0 + band, r.x1 - band, r.y1 - band, r.layer};
}

// By the samples that are placed; even without any.
void warpRegion(const WarpChoice& choice, const LixelRectangle& square, RegionWarpScratch& scratch, TextureWarp& warp)
{
    const WarpOptions& options = *warpOptionsOf(choice);
    warp.square = square;
    warp.columns = std::min(square.width(), options.grid);
    warp.rows = std::min(square.height(), options.grid);
    warp.raster = options.raster;
    warp.rowKnots = takeSpare(scratch);
    warp.columnKnots = takeSpare(scratch);
    if (const auto* rtw = std::get_if<RtwWarp>(&choice)) makeRtw(scratch.placed, *rtw, scratch.warp, warp);
    if (const auto* now = std::get_if<NowWarp>(&choice)) makeNow(scratch.placed, *now, scratch.warp, warp);
}

} // namespace

void warpRegions(const ImportanceSource& source, const WarpChoice& choice, const LookupLayout& lookup,
                 RegionWarpScratch& scratch, std::span<PlannedRegion> regions)
{
    const WarpOptions* options = warpOptionsOf(choice);
    if (!options) return;
    weighSamples(source, *options, scratch.importance, scratch.samples);
    assignSamples(regions, scratch);
    for (std::size_t i = 0; i < regions.size(); ++i) {
        const auto square = squareOf(regions[i], lookup);
        if (!square) continue;
        placeSamples(regions[i], *square, std::uint8_t(i), scratch);
        if (!scratch.placed.empty()) warpRegion(choice, *square, scratch, regions[i].warp);
    }
}

void warpParaboloids(WarpRaster raster, RegionWarpScratch& scratch, std::span<PlannedRegion> regions)
{
    for (PlannedRegion& region : regions) {
        if (!region.paraboloid || !region.warp.isIdentity()) continue;
        region.warp = {WarpLines::Rectilinear, raster, 1, 1, takeSpare(scratch), takeSpare(scratch), region.rectangle};
        region.warp.rowKnots.assign({0, 1});
        region.warp.columnKnots.assign({0, 1});
    }
}

void warpRegionsEvenly(const WarpChoice& choice, const LookupLayout& lookup, RegionWarpScratch& scratch,
                       std::span<PlannedRegion> regions)
{
    if (!warpOptionsOf(choice)) return;
    scratch.placed.clear();
    for (PlannedRegion& region : regions)
        if (const auto square = squareOf(region, lookup)) warpRegion(choice, *square, scratch, region.warp);
}

} // namespace lixel
