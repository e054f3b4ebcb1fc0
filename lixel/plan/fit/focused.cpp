// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/focused.h"

#include "lixel/plan/fit/light_frame.h"

#include <algorithm>
#include <numbers>

namespace lixel {
namespace {

using Planes = FixedVector<Plane, 20>;

// Half-spaces around a spot's cone: eight through the light, touching the cone.
void addCone(const Light& light, Vec3d lightLocal, Planes& planes)
{
    constexpr int kSides = 8;
    const double half = light.coneAngle / 2;
    const Vec3d axis = light.directionWorld, u = anyPerpendicular(axis), v = cross(axis, u);
    for (int i = 0; i < kSides; ++i) {
        const double a = 2 * std::numbers::pi * i / kSides;
        const Vec3d outward = std::cos(a) * u + std::sin(a) * v;
        planes.push_back(planeThrough(lightLocal, std::sin(half) * axis - std::cos(half) * outward));
    }
}

void addRange(double range, Vec3d lightLocal, Planes& planes)
{
    for (const Vec3d axis : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}})
        for (const double sign : {1.0, -1.0})
            planes.push_back(planeThrough(lightLocal + sign * range * axis, -sign * axis));
}

// What must hold for a point to be in view and in the light's reach.
Planes visiblePlanes(const FitInput& input)
{
    Planes planes;
    for (const Plane& plane : clipPlanes(clipFromLocal(input.view, input.originWorld))) planes.push_back(plane);
    if (input.light.kind == LightKind::Directional) return planes;
    const Vec3d lightLocal = input.light.positionWorld - input.originWorld;
    if (std::isfinite(input.light.range)) addRange(input.light.range, lightLocal, planes);
    if (input.light.kind == LightKind::Spot) addCone(input.light, lightLocal, planes);
    return planes;
}

// The corners of a box cut by the planes. Most boxes are wholly inside or outside, which costs a few products.
void addClippedBox(const Box& box, const Planes& planes, std::vector<Vec3d>& points)
{
    const Vec3d centre = box.centre(), half = 0.5 * (box.max - box.min);
    FixedVector<Plane, Planes::capacity()> cutting;
    for (const Plane& plane : planes) {
        const double middle = plane.signedDistance(centre);
        const double reach =
            std::abs(plane.normal.x) * half.x + std::abs(plane.normal.y) * half.y + std::abs(plane.normal.z) * half.z;
        if (middle < -reach) return;
        if (middle < reach) cutting.push_back(plane);
    }
    if (cutting.empty()) {
        for (const Vec3d& corner : box.corners()) points.push_back(corner);
        return;
    }
    ConvexBody body = bodyOf(box);
    for (const Plane& plane : cutting) clip(body, plane);
    for (const auto& face : body.faces) points.insert(points.end(), face.begin(), face.end());
}

// A spot inside the scene is a corner of what it reaches. The cone of directions is spanned by the other corners.
void dropPointsAt(Vec3d lightLocal, std::vector<Vec3d>& points)
{
    double farthest = 0;
    for (const Vec3d& p : points) farthest = std::max(farthest, length(p - lightLocal));
    const double least = 1e-9 * (farthest + length(lightLocal)); // above the rounding of clipping
    std::erase_if(points, [&](Vec3d p) { return length(p - lightLocal) <= least; });
}

} // namespace

void findVisiblePoints(const FitInput& input, std::vector<Vec3d>& points)
{
    points.clear();
    const Planes planes = visiblePlanes(input);
    for (const Box& boxWorld : input.casterBoxesWorld)
        if (!boxWorld.isEmpty()) addClippedBox(translated(boxWorld, -input.originWorld), planes, points);
    if (input.light.kind != LightKind::Directional) dropPointsAt(input.light.positionWorld - input.originWorld, points);
}

FitResult fitFocused(const FitInput& input)
{
    if (input.sceneLocal.isEmpty()) return Unexpected{FitFailure::EmptyScene};
    auto& [points, onPlane, hull] = input.scratch;
    findVisiblePoints(input, points);
    if (points.empty()) return Unexpected{FitFailure::NothingInView};

    Vec3d axis = input.light.directionWorld;
    if (input.light.kind != LightKind::Directional) {
        const DirectionCone cone = coneAround(points, input.light.positionWorld - input.originWorld);
        if (cone.cosHalfAngle < kLeastCosHalfAngle) return Unexpected{FitFailure::ExtentNotInHemisphere};
        axis = cone.axis;
    }
    const LightFrame frame = lightFrame(input.light, input.originWorld, axis);
    onPlane.clear();
    double far = -std::numeric_limits<double>::infinity();
    for (const Vec3d& p : points) {
        onPlane.push_back(onLightPlane(frame, p));
        far = std::max(far, (frame.framedFromLocal * point(p)).z);
    }
    hull.resize(onPlane.size() + 1);
    const std::size_t corners = convexHull(onPlane, hull);
    return fitRectangle(frame, minimumAreaRectangle({hull.data(), corners}), far, input);
}

} // namespace lixel
