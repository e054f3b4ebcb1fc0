// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/scene_optimal.h"

#include "lixel/plan/fit/light_frame.h"
#include "lixel/plan/fit/lispsm.h"
#include "lixel/plan/fit/map_search.h"
#include "lixel/plan/fit/psm.h"
#include "lixel/plan/fit/tsm.h"

#include <algorithm>
#include <cmath>

namespace lixel {
namespace {

// Of a hull with more corners so many are searched with; what is found holds all of them.
constexpr std::size_t kMostCorners = 40;

// The body with its image in [-1, 1], so that axes have the same meaning at any distance of the light.
std::optional<FramedBody> scaled(const FramedBody& body, FitScratch& scratch)
{
    const OrientedRectangle box = rectangleAround(body, RectangleKind::Upright, scratch);
    const double scale = 1 / std::max({box.halfSize.x, box.halfSize.y, 1e-300});
    return warped(body, {{scale, 0, -scale * box.centre.x}, {0, scale, -scale * box.centre.y}, {0, 0, 1}});
}

// Rays of the hull's corners, counter-clockwise.
std::span<const Vec3d> raysOf(const FramedBody& body, FitScratch::OfScene& scratch)
{
    const Mat4d& framed = body.frame.framedFromLocal;
    const std::size_t count = body.corners.size(), taken = std::min(count, kMostCorners);
    scratch.corners.clear();
    for (std::size_t i = 0; i < taken; ++i) {
        const Vec4d p = point(body.corners[i * count / taken]);
        scratch.corners.push_back({dot(framed.row(0), p), dot(framed.row(1), p), dot(framed.row(3), p)});
    }
    return scratch.corners;
}

Fit withSlack(Fit fit, double slack)
{
    for (const int row : {0, 1})
        fit.lightClipFromLocal.setRow(row, (1 / (1 + slack)) * fit.lightClipFromLocal.row(row));
    return fit;
}

} // namespace

std::optional<PlaneWarp> planeWarpOf(const LightFrame& frame, const Mat4d& lightClipFromLocal)
{
    const Vec4d f0 = frame.framedFromLocal.row(0), f1 = frame.framedFromLocal.row(1), f3 = frame.framedFromLocal.row(3);
    // Lights at a point: all rows vanish there, so that their directions say it all. Parallel light: w does not change along it.
    const Vec3d a = xyz(f0), b = xyz(f1), c = frame.isPerspective ? xyz(f3) : cross(a, b);
    const double volume = dot(a, cross(b, c));
    if (!(std::abs(volume) > 0)) return std::nullopt;
    const auto rowOf = [&](Vec4d row) {
        const Vec3d r = xyz(row);
        Vec3d out{dot(r, cross(b, c)) / volume, dot(r, cross(c, a)) / volume, dot(r, cross(a, b)) / volume};
        if (!frame.isPerspective) out.z = (row.w - out.x * f0.w - out.y * f1.w) / f3.w;
        return out;
    };
    const Vec4d x = lightClipFromLocal.row(0), y = lightClipFromLocal.row(1), w = lightClipFromLocal.row(3);
    return PlaneWarp{0.5 * rowOf(x), 0.5 * rowOf(y), rowOf(w)};
}

FitResult fitSceneOptimal(const FitInput& input, const SceneOptimalFit& choice)
{
    if (input.sceneLocal.isEmpty()) return Unexpected{FitFailure::EmptyScene};
    if (!input.hasViewSamples) return Unexpected{FitFailure::NoViewSamples};
    if (input.seenLocal.empty()) return Unexpected{FitFailure::NothingInView};
    FitScratch& scratch = input.scratch;
    const auto found = frameAround(input, input.seenLocal);
    if (!found) return Unexpected{found.error()};
    // Corners stay where they are while other fits are tried.
    scratch.scene.bodyCorners.assign(found->corners.begin(), found->corners.end());
    FramedBody body{found->frame, input.seenLocal, scratch.scene.bodyCorners};
    const bool isScaled = choice.search == MapSearchKind::Wide || !body.frame.isPerspective;
    if (isScaled) body = scaled(body, scratch).value_or(body);

    const double slack = input.seenIsAll ? 0 : choice.slack;
    const auto fitted = [&](const FramedBody& framed, RectangleKind kind) {
        Fit fit = withSlack(fitTightly(framed, kind, input), slack);
        fit.isOfSamples = true;
        return fit;
    };
    EdgeRays& rays = scratch.scene.all;
    rays.assign(input.view, input.originWorld, body.frame.framedFromLocal, input.edges);
    const std::span<const Vec3d> corners = raysOf(body, scratch.scene);
    if (rays.isEmpty() || corners.size() < 3) return fitted(body, RectangleKind::LeastArea);

    const MapQuestion question{choice.metric, rays, corners, input.mapAspect, choice.hasShear, scratch.scene};
    const bool isWide = choice.search == MapSearchKind::Wide;
    const FoundMap map =
        isWide ? searchWidely(question) : descend(question, {0, 0, 1}, {choice.iterations, kPaperAngles});
    const auto framed = warped(body, map.map);
    if (!framed || !std::isfinite(map.energy)) return fitted(body, RectangleKind::LeastArea);
    Fit best = fitted(*framed, RectangleKind::Upright);
    if (!isWide) return best;

    // None of the cheap fits is better.
    const auto energyOf = [&](const Fit& fit) {
        const auto rows = planeWarpOf(body.frame, fit.lightClipFromLocal);
        return rows ? lixelEnergy(choice.metric, rays, *rows) : std::numeric_limits<double>::infinity();
    };
    double energy = energyOf(best);
    for (const FitResult& other : {fitLispsm(input), fitPsm(input, PsmShift::Casters), fitTsm(input, std::nullopt)}) {
        if (!other) continue;
        const double ofOther = energyOf(*other);
        if (ofOther < energy) best = *other, energy = ofOther;
    }
    return best;
}

} // namespace lixel
