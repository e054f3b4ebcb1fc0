// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/paraboloid.h"

#include "lixel/plan/fit/light_frame.h"
#include "lixel/plan/fit/visible_body.h"

#include <algorithm>
#include <cmath>

namespace lixel {
namespace {

// As of perspective maps: they start no nearer than this part of the distance where they end.
constexpr double kLeastNearPerFar = 1e-4;

// Receivers nearer than this part of the farthest are next to the light, and no map resolves them.
constexpr double kNextToLight = 1.0 / 64;

// What floats round of their terms, on the way to a place on the paraboloid, and the part of a map that this must stay below: a
// tenth of a lixel of 512.
constexpr double kRoomPerRounding = 8 * 0x1p-24;
constexpr double kLeastPerRounding = 2e3 * 0x1p-24;

// Rectangles that hold just what they must would lose it to the rounding of their own numbers.
constexpr double kBorder = 1 + 1e-6;

struct Extent
{
    Vec2d least, greatest;
};

// The disc of a cone of rays on the paraboloid, within that of the half sphere: a circle, as of every stereographic map. A cone of a half
// sphere and more is not convex: what lies between its points may be anywhere around the light.
Extent aroundCone(const DirectionCone& cone, Vec3d axis)
{
    const double below = axis.z + cone.cosHalfAngle;
    if (!(below > 0) || !(cone.cosHalfAngle > 0)) return {{-1, -1}, {1, 1}};
    const double sine = std::sqrt(std::max(0.0, 1 - cone.cosHalfAngle * cone.cosHalfAngle)), radius = sine / below;
    const Vec2d centre{axis.x / below, axis.y / below};
    return {{std::max(centre.x - radius, -1.0), std::max(centre.y - radius, -1.0)},
            {std::min(centre.x + radius, 1.0), std::min(centre.y + radius, 1.0)}};
}

// Of a light's axes, its place, and what must be held.
struct ParaboloidBody
{
    LightFrame frame;
    std::span<const Vec3d> pointsLocal;
    double farthest = 0;

    ParaboloidBody(const LightFrame& of, std::span<const Vec3d> points) : frame(of), pointsLocal(points)
    {
        for (const Vec3d& p : points) farthest = std::max(farthest, length(p - frame.apexLocal));
    }

    Vec3d rayTo(Vec3d p) const { return xyz(frame.framedFromLocal * direction(normalized(p - frame.apexLocal))); }

    // Of the points' places, each moved by no more than this times a float's rounding.
    double terms() const
    {
        double most = 1;
        for (const Vec3d& p : pointsLocal) {
            const double away = std::max(length(p - frame.apexLocal), kNextToLight * farthest);
            double sum = 0;
            for (const int row : {0, 1, 3}) {
                const Vec4d r = frame.framedFromLocal.row(row);
                sum += std::abs(r.x * p.x) + std::abs(r.y * p.y) + std::abs(r.z * p.z) + std::abs(r.w);
            }
            most = std::max(most, 2 + sum / away);
        }
        return most;
    }
};

Extent around(const ParaboloidBody& body)
{
    Extent extent{{1, 1}, {-1, -1}};
    for (const Vec3d& p : body.pointsLocal) {
        const Vec2d at = onParaboloid(body.rayTo(p));
        extent.least = {std::min(extent.least.x, at.x), std::min(extent.least.y, at.y)};
        extent.greatest = {std::max(extent.greatest.x, at.x), std::max(extent.greatest.y, at.y)};
    }
    return extent;
}

Extent extentOf(const ParaboloidBody& body, ParaboloidExtent kind, FitScratch& scratch)
{
    if (kind == ParaboloidExtent::Scene) return {{-1, -1}, {1, 1}};
    if (kind == ParaboloidExtent::Samples) return around(body);
    const DirectionCone cone = coneAround(body.pointsLocal, body.frame.apexLocal, scratch.directions);
    return aroundCone(cone, xyz(body.frame.framedFromLocal * direction(cone.axis)));
}

double distanceTo(const Box& box, Vec3d p)
{
    const auto outside = [](double low, double x, double high) { return std::max({low - x, x - high, 0.0}); };
    return length(Vec3d{outside(box.min.x, p.x, box.max.x), outside(box.min.y, p.y, box.max.y),
                        outside(box.min.z, p.z, box.max.z)});
}

// From the nearest caster, wherever it lies around the light.
double nearOf(const FitInput& input, Vec3d lightLocal, double far)
{
    double nearest = far;
    for (const Box& box : input.casterBoxesWorld)
        if (!box.isEmpty()) nearest = std::min(nearest, distanceTo(box, lightLocal + input.originWorld));
    return std::clamp(nearest * (1 - 1e-6), kLeastNearPerFar * far, 0.999 * far);
}

Expected<std::span<const Vec3d>, FitFailure> pointsOf(const FitInput& input, ParaboloidExtent extent)
{
    if (input.sceneLocal.isEmpty()) return Unexpected{FitFailure::EmptyScene};
    std::span<const Vec3d> points = input.seenLocal;
    if (extent == ParaboloidExtent::Samples) {
        if (!input.hasViewSamples) return Unexpected{FitFailure::NoViewSamples};
    } else {
        if (extent == ParaboloidExtent::Scene) findReachedPoints(input, input.scratch.points);
        else findVisiblePoints(input, input.scratch.points);
        points = input.scratch.points;
    }
    if (points.empty()) return Unexpected{FitFailure::NothingInView};
    return points;
}

} // namespace

FitResult fitParaboloid(const FitInput& input, Vec3d axisLocal, ParaboloidExtent extent)
{
    const auto points = pointsOf(input, extent);
    if (!points) return Unexpected{points.error()};
    const ParaboloidBody body(lightFrame(input.light, input.originWorld, axisLocal), *points);
    if (!(body.farthest > 0)) return Unexpected{FitFailure::NothingInView};
    const Extent held = extentOf(body, extent, input.scratch);
    const double terms = body.terms();
    const auto half = [&](double least, double greatest) {
        return std::max(0.5 * kBorder * (greatest - least) + kRoomPerRounding * terms, kLeastPerRounding * terms);
    };
    const Mat4d& framed = body.frame.framedFromLocal;
    Fit fit{Mat4d::fromRows(framed.row(0), framed.row(1), {0, 0, 0, 1}, framed.row(3))};
    Paraboloid paraboloid;
    paraboloid.centre = {0.5 * (held.least.x + held.greatest.x), 0.5 * (held.least.y + held.greatest.y)};
    paraboloid.halfSize = {half(held.least.x, held.greatest.x), half(held.least.y, held.greatest.y)};
    paraboloid.far = body.farthest * (1 + 1e-5 + 16 * 0x1p-24 * terms);
    paraboloid.near = nearOf(input, body.frame.apexLocal, body.farthest);
    fit.paraboloid = paraboloid;
    fit.isOfSamples = extent == ParaboloidExtent::Samples;
    return fit;
}

} // namespace lixel
