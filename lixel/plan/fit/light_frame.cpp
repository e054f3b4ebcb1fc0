// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/light_frame.h"

#include <algorithm>
#include <numeric>

namespace lixel {
namespace {

// Perspective maps start no nearer than this part of their far depth: reversed float depth keeps its relative precision down
// to here while a triangle that spans the whole range is interpolated. Casters still nearer are clamped, which shadows alike.
constexpr double kLeastNearPerFar = 1e-4;

// A rectangle has this size at least, against its distance from the light plane's origin: a map of one line or point is still a map.
constexpr double kLeastRelativeHalfSize = 1e-9;

// Directions nearer the cone's border than this count as inside: above rounding, far below a lixel.
constexpr double kConeSlack = 1e-14;

// A little room so that receivers on the very border stay inside after rounding to float.
constexpr double kBorder = 1 + 1e-6;

// Half-open tests do not matter here: a box that only touches is included.
bool reachesInto(const LightFrame& frame, const OrientedRectangle& rectangle, const std::array<Vec4d, 8>& cornersFramed)
{
    const Vec2d side{-rectangle.axis.y, rectangle.axis.x};
    Vec2d low{1e300, 1e300}, high{-1e300, -1e300};
    for (const Vec4d& q : cornersFramed) {
        if (frame.isPerspective && q.w <= 0) return true; // beside or behind the light: its image is not bounded
        const Vec2d p = Vec2d{q.x / q.w, q.y / q.w} - rectangle.centre;
        low = {std::min(low.x, dot(rectangle.axis, p)), std::min(low.y, dot(side, p))};
        high = {std::max(high.x, dot(rectangle.axis, p)), std::max(high.y, dot(side, p))};
    }
    return low.x <= rectangle.halfSize.x && high.x >= -rectangle.halfSize.x && low.y <= rectangle.halfSize.y &&
           high.y >= -rectangle.halfSize.y;
}

double nearestCaster(const LightFrame& frame, const OrientedRectangle& rectangle, const FitInput& input)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (const Box& boxWorld : input.casterBoxesWorld) {
        if (boxWorld.isEmpty()) continue;
        std::array<Vec4d, 8> corners;
        const auto cornersLocal = translated(boxWorld, -input.originWorld).corners();
        for (std::size_t i = 0; i < 8; ++i) corners[i] = frame.framedFromLocal * point(cornersLocal[i]);
        if (!reachesInto(frame, rectangle, corners)) continue;
        for (const Vec4d& q : corners) nearest = std::min(nearest, q.z);
    }
    return nearest;
}

} // namespace

LightFrame lightFrame(const Light& light, Vec3d originWorld, Vec3d axisLocal)
{
    const bool isPerspective = light.kind != LightKind::Directional;
    const Vec3d axis = isPerspective ? axisLocal : light.directionWorld;
    const Vec3d right = anyPerpendicular(axis), up = cross(right, axis);
    const Vec3d apex = isPerspective ? light.positionWorld - originWorld : Vec3d{};
    const auto row = [&apex](Vec3d a) { return Vec4d{a.x, a.y, a.z, -dot(a, apex)}; };
    return {Mat4d::fromRows(row(right), row(up), row(axis), isPerspective ? row(axis) : Vec4d{0, 0, 0, 1}),
            isPerspective};
}

DirectionCone coneAround(std::span<const Vec3d> pointsLocal, Vec3d apexLocal)
{
    LX_ASSERT(!pointsLocal.empty());
    // Scattered order: neighbours in the list are neighbours in space, which would make the search below quadratic.
    std::size_t stride = std::size_t(0.618 * double(pointsLocal.size())) | 1;
    while (std::gcd(stride, pointsLocal.size()) != 1) stride += 2;
    const auto towards = [&](std::size_t i) {
        return normalized(pointsLocal[i * stride % pointsLocal.size()] - apexLocal);
    };
    const auto isOutside = [](const DirectionCone& cone, Vec3d d) {
        return dot(cone.axis, d) < cone.cosHalfAngle - kConeSlack;
    };
    const auto through = [](Vec3d axis, Vec3d d) { return DirectionCone{axis, dot(axis, d)}; };
    const auto throughThree = [&](Vec3d a, Vec3d b, Vec3d c) {
        const Vec3d axis = normalized(cross(b - a, c - a));
        return through(dot(axis, a) < 0 ? -axis : axis, a);
    };

    // Welzl 1991, on the sphere: the narrowest cone changes only for a direction outside it, which is then on its border.
    DirectionCone cone{towards(0), 1};
    for (std::size_t i = 1; i < pointsLocal.size(); ++i) {
        const Vec3d a = towards(i);
        if (!isOutside(cone, a)) continue;
        cone = {a, 1};
        for (std::size_t j = 0; j < i; ++j) {
            const Vec3d b = towards(j);
            if (!isOutside(cone, b)) continue;
            cone = through(normalized(a + b), a);
            for (std::size_t k = 0; k < j; ++k)
                if (isOutside(cone, towards(k))) cone = throughThree(a, b, towards(k));
        }
    }
    // Directions that do not fit a half-space have no such cone; the cosine then says so.
    for (std::size_t i = 0; i < pointsLocal.size(); ++i)
        cone.cosHalfAngle = std::min(cone.cosHalfAngle, dot(cone.axis, towards(i)));
    return cone;
}

Fit fitRectangle(const LightFrame& frame, OrientedRectangle rectangle, double farDepth, const FitInput& input)
{
    const double scale = length(rectangle.centre) + length(rectangle.halfSize);
    const double least = scale > 0 ? kLeastRelativeHalfSize * scale : kLeastRelativeHalfSize;
    rectangle.halfSize = {std::max(rectangle.halfSize.x * kBorder, least),
                          std::max(rectangle.halfSize.y * kBorder, least)};

    const double nearest = nearestCaster(frame, rectangle, input);
    double near = std::min(nearest, farDepth);
    if (frame.isPerspective) near = std::max(near, kLeastNearPerFar * farDepth);
    const double room = std::max(1e-6 * (farDepth - near), 1e-9 * (std::abs(farDepth) + std::abs(near)));
    near -= frame.isPerspective ? std::min(room, 0.5 * near) : room;
    const double far = farDepth + room;

    const Vec4d x = frame.framedFromLocal.row(0), y = frame.framedFromLocal.row(1),
                depth = frame.framedFromLocal.row(2), w = frame.framedFromLocal.row(3);
    const Vec2d a = rectangle.axis, b{-a.y, a.x};
    const auto along = [&](Vec2d axis, double half) {
        return (1 / half) * (axis.x * x + axis.y * y - dot(axis, rectangle.centre) * w);
    };
    // Depth in NDC: linear for parallel light; for a perspective (f + n)/(f - n) - 2fn/((f - n) w), times w.
    const Vec4d z = frame.isPerspective ? (1 / (far - near)) * ((far + near) * depth - Vec4d{0, 0, 0, 2 * far * near})
                                        : (1 / (far - near)) * (2.0 * depth - Vec4d{0, 0, 0, far + near});
    return {Mat4d::fromRows(along(a, rectangle.halfSize.x), along(b, rectangle.halfSize.y), z, w)};
}

} // namespace lixel
