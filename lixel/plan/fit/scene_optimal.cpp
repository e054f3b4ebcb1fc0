// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/scene_optimal.h"

#include "lixel/base/enclosing_polygon.h"
#include "lixel/plan/fit/hull_map.h"
#include "lixel/plan/fit/light_frame.h"
#include "lixel/plan/fit/lispsm.h"
#include "lixel/plan/fit/map_search.h"
#include "lixel/plan/fit/psm.h"
#include "lixel/plan/fit/tsm.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lixel {
namespace {

// An earlier map is kept as it is while the rectangle around what it must hold takes up this part of it.
constexpr double kLeastTaken = 0.85;

// An image smaller than this is one point.
constexpr double kLeastImage = 1e-12;

// The body with its image in [-1, 1], so that axes have the same meaning at any distance of the light.
std::optional<FramedBody> scaled(const FramedBody& body, FitScratch& scratch)
{
    const OrientedRectangle box = rectangleAround(body, RectangleKind::Upright, scratch);
    const double half = std::max(box.halfSize.x, box.halfSize.y);
    if (!(half > kLeastImage)) return std::nullopt;
    const double scale = 1 / half;
    return warped(body, {{scale, 0, -scale * box.centre.x}, {0, scale, -scale * box.centre.y}, {0, 0, 1}});
}

// Rays of the hull's corners, counter-clockwise, or of a polygon's around it that has few enough; fewer than three where all is in
// line.
std::span<const Vec3d> raysOf(const FramedBody& body, FitScratch& scratch)
{
    auto& [points, hull, numbered, numberedHull] = scratch.plane;
    points.clear();
    for (const Vec3d& corner : body.corners) points.push_back(onLightPlane(body.frame, corner));
    hull.resize(points.size() + 1);
    std::size_t count = convexHull(points, hull);
    if (count > HullMaps::kMostCorners) count = encloseWithFewerCorners({hull.data(), count}, HullMaps::kMostCorners);
    scratch.scene.corners.clear();
    for (std::size_t i = 0; i < count; ++i) scratch.scene.corners.push_back({hull[i].x, hull[i].y, 1});
    return scratch.scene.corners;
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

namespace {

// Whether the map is for receivers in shadow and near its edges only.
bool holdsSomeOnly(const FitInput& input, const SceneOptimalFit& choice)
{
    return choice.extent == MapExtent::Shadows && !input.shadowsLocal.empty();
}

// The receivers that the map is for, on a plane of the light. Corners stay where they are while other fits are tried.
Expected<FramedBody, FitFailure> bodyOf(const FitInput& input, const SceneOptimalFit& choice)
{
    if (input.sceneLocal.isEmpty()) return Unexpected{FitFailure::EmptyScene};
    if (!input.hasViewSamples) return Unexpected{FitFailure::NoViewSamples};
    if (input.seenLocal.empty()) return Unexpected{FitFailure::NothingInView};
    const std::span<const Vec3d> points = holdsSomeOnly(input, choice) ? input.shadowsLocal : input.seenLocal;
    const auto found = frameAround(input, points);
    if (!found) return Unexpected{found.error()};
    auto& corners = input.scratch.scene.bodyCorners;
    corners.assign(found->corners.begin(), found->corners.end());
    const FramedBody body{found->frame, points, corners};
    const bool isScaled = choice.search == MapSearchKind::Wide || !body.frame.isPerspective;
    return isScaled ? scaled(body, input.scratch).value_or(body) : body;
}

void gatherRays(const FitInput& input, const FramedBody& body)
{
    input.scratch.scene.all.assign(input.view, input.originWorld, body.frame.framedFromLocal, input.edges);
}

std::optional<MapQuestion> questionOf(const FitInput& input, const SceneOptimalFit& choice, const FramedBody& body)
{
    FitScratch::OfScene& scratch = input.scratch.scene;
    const std::span<const Vec3d> corners = raysOf(body, input.scratch);
    if (scratch.all.isEmpty() || corners.size() < 3) return std::nullopt;
    return MapQuestion{choice.metric, scratch.all, corners, input.mapAspect, choice.hasShear, scratch};
}

// One light's maps.
class SceneFit
{
public:
    // `isOfSome`: the body is not all that is seen.
    SceneFit(const FitInput& input, const SceneOptimalFit& choice, std::span<const double> angles,
             const FramedBody& body, bool isOfSome)
        : input_(input),
          choice_(choice),
          angles_(angles),
          scratch_(input.scratch.scene),
          body_(body),
          isOfSome_(isOfSome)
    {
    }

    Fit best()
    {
        const RememberedMap* before = input_.before;
        const auto kept = before ? keptFrom(*before) : std::nullopt;
        if (before && !isNewMapDueAfter(*before, choice_)) return kept ? *kept : untilNext();
        gatherRays(input_, body_);
        Fit found = choice_.search == MapSearchKind::Wide ? bestOfAll() : descended();
        if (!kept || isClearlyBetter(found, *kept)) return found;
        Fit out = *kept;
        out.framesKept = 0; // it was asked for anew, and is still good enough
        return out;
    }

private:
    Fit fitted(const FramedBody& framed, RectangleKind kind) const
    {
        OrientedRectangle rectangle = rectangleAround(framed, kind, input_.scratch);
        if (!input_.seenIsAll || isOfSome_) rectangle.halfSize = (1 + choice_.slack) * rectangle.halfSize;
        Fit fit = fitRectangle(framed.frame, rectangle, farthestInside(framed, rectangle), input_);
        fit.isOfSamples = true;
        fit.rounding = floatRounding(framed, rectangle);
        return fit;
    }

    // Of all receivers that the rectangle holds, whether it is made for them or not.
    double farthestInside(const FramedBody& framed, const OrientedRectangle& rectangle) const
    {
        double farthest = farthestDepth(framed);
        if (!isOfSome_) return farthest;
        const Vec2d a = rectangle.axis, b{-a.y, a.x};
        const Vec4d depth = framed.frame.framedFromLocal.row(2), w = framed.frame.framedFromLocal.row(3);
        for (const Vec3d& p : input_.seenLocal) {
            if (!(dot(w, point(p)) > 0)) continue;
            const Vec2d from = onLightPlane(framed.frame, p) - rectangle.centre;
            if (std::abs(dot(a, from)) <= rectangle.halfSize.x && std::abs(dot(b, from)) <= rectangle.halfSize.y)
                farthest = std::max(farthest, dot(depth, point(p)));
        }
        return farthest;
    }

    // Nothing where the rows are no map of the body.
    std::optional<Fit> fittedIn(const PlaneWarp& rows) const
    {
        const auto framed = warped(body_, rows);
        if (!framed) return std::nullopt;
        const Fit fit = fitted(*framed, RectangleKind::Upright);
        return isFinite(fit.lightClipFromLocal) ? std::optional(fit) : std::nullopt;
    }

    Fit leastArea() const { return fitted(body_, RectangleKind::LeastArea); }

    Fit fittedTo(const FoundMap& map) const
    {
        if (!std::isfinite(map.energy)) return leastArea();
        const auto fit = fittedIn(map.map);
        return fit ? *fit : leastArea();
    }

    Fit descended()
    {
        const auto asked = questionOf(input_, choice_, body_);
        return asked ? fittedTo(descend(*asked, {0, 0, 1}, {choice_.iterations, angles_})) : leastArea();
    }

    // None of the cheap fits is better.
    Fit bestOfAll()
    {
        const auto asked = questionOf(input_, choice_, body_);
        if (!asked) return leastArea();
        Fit best = fittedTo(searchWidely(*asked));
        double energy = energyOf(best);
        for (const FitResult& other : {FitResult(leastArea()), fitLispsm(input_), fitPsm(input_, PsmShift::Casters),
                                       fitTsm(input_, std::nullopt)}) {
            if (!other) continue;
            const double ofOther = energyOf(*other);
            if (ofOther < energy) best = *other, energy = ofOther;
        }
        return best;
    }

    // Of one lixel, as wide against its height as the map's are.
    std::optional<PlaneWarp> rowsOf(const Fit& fit) const
    {
        auto rows = planeWarpOf(body_.frame, fit.lightClipFromLocal);
        if (!rows) return std::nullopt;
        const double width = std::sqrt(input_.mapAspect);
        rows->x = width * rows->x, rows->y = (1 / width) * rows->y;
        return rows;
    }

    double energyOf(const Fit& fit) const
    {
        const auto rows = rowsOf(fit);
        return rows ? lixelEnergy(choice_.metric, scratch_.all, *rows) : std::numeric_limits<double>::infinity();
    }

    // By the paper's rule, and by its own metric as clearly: either alone lets two maps take turns, each the better one for what the
    // other lets be seen.
    bool isClearlyBetter(const Fit& found, const Fit& kept)
    {
        if (choice_.keep == std::numeric_limits<double>::infinity()) return true;
        return medianBadness(found) < choice_.keep * medianBadness(kept) &&
               energyOf(found) < energyRatio() * energyOf(kept);
    }

    // What `keep` is for energies in pixels; those of L2 and Area are squares, as badness is.
    double energyRatio() const
    {
        const bool isOfSquares = choice_.metric == LixelMetric::L2 || choice_.metric == LixelMetric::Area;
        return isOfSquares ? choice_.keep : std::sqrt(choice_.keep);
    }

    double medianBadness(const Fit& fit)
    {
        const auto rows = rowsOf(fit);
        if (!rows || scratch_.all.isEmpty()) return std::numeric_limits<double>::infinity();
        badnesses(scratch_.all, *rows, scratch_.values);
        const auto middle = scratch_.values.begin() + std::ptrdiff_t(scratch_.values.size() / 2);
        std::nth_element(scratch_.values.begin(), middle, scratch_.values.end());
        return *middle;
    }

    // An earlier map as it is, if it still holds what it must, or with the scale and shift that do. Nothing where it cannot.
    std::optional<Fit> keptFrom(const RememberedMap& before) const
    {
        Fit asItIs{before.lightClipFromLocal};
        asItIs.isOfSamples = true;
        asItIs.rounding = before.rounding;
        const bool isLightStill = before.lightWorld == homogeneousWorld(input_.light);
        std::optional<Fit> fit = isLightStill && holdsTightly(asItIs) ? std::optional(asItIs) : std::nullopt;
        if (!fit)
            if (const auto rows = planeWarpOf(body_.frame, before.lightClipFromLocal)) fit = fittedIn(*rows);
        if (fit) fit->framesKept = before.framesKept + 1;
        return fit;
    }

    // Whether the body is inside and takes up all but a little of the map.
    bool holdsTightly(const Fit& fit) const
    {
        Vec2d low{1, 1}, high{-1, -1};
        for (const Vec3d& p : body_.points) {
            const Vec4d c = fit.lightClipFromLocal * point(p);
            if (!(c.w > 0 && std::abs(c.x) <= c.w && std::abs(c.y) <= c.w && c.z <= c.w)) return false;
            const double x = c.x / c.w, y = c.y / c.w;
            low = {std::min(low.x, x), std::min(low.y, y)};
            high = {std::max(high.x, x), std::max(high.y, y)};
        }
        const double taken = 0.25 * (high.x - low.x) * (high.y - low.y),
                     room = (1 + choice_.slack) * (1 + choice_.slack);
        return taken * room > kLeastTaken;
    }

    // What holds all, where an earlier map no longer can: the next frame looks for a better one.
    Fit untilNext() const
    {
        Fit fit = leastArea();
        fit.framesKept = choice_.update;
        return fit;
    }

    const FitInput& input_;
    const SceneOptimalFit& choice_;
    std::span<const double> angles_;
    FitScratch::OfScene& scratch_;
    FramedBody body_;
    bool isOfSome_;
};

} // namespace

Expected<SceneQuestion, FitFailure> sceneQuestion(const FitInput& input, const SceneOptimalFit& choice)
{
    const auto body = bodyOf(input, choice);
    if (!body) return Unexpected{body.error()};
    gatherRays(input, *body);
    return SceneQuestion{body->frame, questionOf(input, choice, *body)};
}

FitResult fitSceneOptimal(const FitInput& input, const SceneOptimalFit& choice, std::span<const double> angles)
{
    const auto body = bodyOf(input, choice);
    if (!body) return Unexpected{body.error()};
    return SceneFit(input, choice, angles, *body, holdsSomeOnly(input, choice)).best();
}

} // namespace lixel
