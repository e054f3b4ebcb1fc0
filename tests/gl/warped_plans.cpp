// SPDX-License-Identifier: MIT
#include "warped_plans.h"

#include "plan/random_warps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lixel::test {
namespace {

// Lines whose density is a sum of waves that turn slowly from line to line.
void appendSmoothLines(int lines, int cells, double strength, Rng& rng, std::vector<float>& knots)
{
    const double turn = rng.uniform(-3, 3), phase = rng.uniform(0, 6), waves = rng.uniform(0.5, 3);
    for (int line = 0; line < lines; ++line) {
        std::vector<double> density;
        double sum = 0;
        for (int i = 0; i < cells; ++i) {
            const double along = (i + 0.5) / cells, across = (line + 0.5) / lines;
            density.push_back(
                std::pow(strength, std::sin(2 * std::numbers::pi * waves * along + turn * across + phase)));
            sum += density.back();
        }
        double below = 0;
        knots.push_back(0);
        for (int i = 0; i < cells; ++i) {
            below += density[std::size_t(i)] / sum;
            knots.push_back(i + 1 < cells ? float(below) : 1.0f);
        }
    }
}

// One function a line of counts, which lie `alongStep` apart along it and `acrossStep` from line to line.
void appendCounted(const std::vector<double>& counts, int lines, int cells, int acrossStep, int alongStep, int smooth,
                   std::vector<float>& knots)
{
    for (int line = 0; line < lines; ++line) {
        std::vector<double> density(std::size_t(cells), 0);
        double sum = 0;
        for (int other = std::max(line - smooth, 0); other <= std::min(line + smooth, lines - 1); ++other)
            for (int i = 0; i < cells; ++i) {
                const double count = counts[std::size_t(other * acrossStep + i * alongStep)];
                density[std::size_t(i)] += count, sum += count;
            }
        double below = 0;
        knots.push_back(0);
        for (int i = 0; i < cells; ++i) {
            const double even = 1.0 / cells;
            below += sum > 0 ? 0.05 * even + 0.95 * density[std::size_t(i)] / sum : even;
            knots.push_back(i + 1 < cells ? float(below) : 1.0f);
        }
    }
}

} // namespace

TextureWarp countedWarp(const PlannedRegion& region, const ViewSamples& samples, int smooth)
{
    TextureWarp warp;
    warp.lines = WarpLines::Interpolated;
    warp.square = region.rectangle;
    warp.columns = region.rectangle.width(), warp.rows = region.rectangle.height();
    const LightImage image(region.lightClipFromLocal, region.rectangle);
    std::vector<Vec2d> places;
    for (const Vec3f& position : samples.positionLocal)
        if (const auto lixel = image.lixelAt(toDouble(position)))
            places.push_back(
                {(lixel->x - region.rectangle.x0) / warp.columns, (lixel->y - region.rectangle.y0) / warp.rows});
    const auto counted = [&](auto placeOf) {
        std::vector<double> counts(std::size_t(warp.columns) * std::size_t(warp.rows), 0);
        for (const Vec2d& place : places) {
            const Vec2d at = placeOf(place);
            const int x = std::clamp(int(at.x * warp.columns), 0, warp.columns - 1);
            const int y = std::clamp(int(at.y * warp.rows), 0, warp.rows - 1);
            ++counts[std::size_t(y) * std::size_t(warp.columns) + std::size_t(x)];
        }
        return counts;
    };
    appendCounted(counted([](Vec2d p) { return p; }), warp.rows, warp.columns, warp.columns, 1, smooth, warp.rowKnots);
    appendCounted(std::vector<double>(std::size_t(warp.columns) * std::size_t(warp.rows), 0), warp.columns, warp.rows,
                  1, warp.columns, 0, warp.columnKnots);
    const std::vector<double> counts = counted([&](Vec2d p) {
        const shared::LxWarped w = shared::lxWarped(tableRow(warp), {float(p.x), float(p.y)}, knotsOf(warp));
        return Vec2d{w.at.x, w.at.y};
    });
    warp.columnKnots.clear();
    appendCounted(counts, warp.columns, warp.rows, 1, warp.columns, smooth, warp.columnKnots);
    return warp;
}

void rebuildWarps(FramePlan& plan)
{
    plan.warpTable.clear();
    std::size_t i = 0;
    for (const ShadowPlan& light : plan.lights)
        for (const PlannedRegion& region : light.regions)
            plan.regionTable[i++].warp = appendWarp(region.warp, plan.warpTable);
}

TextureWarp smoothWarp(const LixelRectangle& square, int lines, double strength, Rng& rng)
{
    TextureWarp warp;
    warp.lines = WarpLines::Interpolated;
    warp.columns = warp.rows = lines;
    warp.square = square;
    appendSmoothLines(lines, lines, strength, rng, warp.rowKnots);
    appendSmoothLines(lines, lines, strength, rng, warp.columnKnots);
    return warp;
}

void warpRegions(FramePlan& plan, Rng& rng, WarpRaster raster, int guard)
{
    for (ShadowPlan& light : plan.lights)
        for (PlannedRegion& region : light.regions) {
            if (rng.chance(0.1)) continue;
            LixelRectangle square = region.rectangle;
            if (square.width() > 2 * guard && square.height() > 2 * guard)
                square = {square.x0 + guard, square.y0 + guard, square.x1 - guard, square.y1 - guard, square.layer};
            region.warp =
                rng.chance(0.5) ? anyWarp(square, rng) : smoothWarp(square, rng.integer(2, 90), rng.uniform(1, 4), rng);
            region.warp.raster = raster;
        }
    rebuildWarps(plan);
}

} // namespace lixel::test
