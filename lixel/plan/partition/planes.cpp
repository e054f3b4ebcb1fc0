// SPDX-License-Identifier: MIT
#include "lixel/plan/partition/planes.h"

#include "lixel/base/convex.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace lixel {
namespace {

// Floats of points on a plane, and of the plane, round by this part of their terms, with room.
constexpr double kOnPlane = 8 * 0x1p-24;

Vec4d asRow(const Plane& plane) { return {plane.normal.x, plane.normal.y, plane.normal.z, plane.offset}; }

Plane asPlane(Vec4d row)
{
    const double size = length(xyz(row));
    return {(1 / size) * xyz(row), row.w / size};
}

Vec4d lightLocal(const FitInput& input)
{
    if (input.light.kind == LightKind::Directional) return direction(-input.light.directionWorld);
    return point(input.light.positionWorld - input.originWorld);
}

// The plane with its light on the positive side, scaled to 1 there; nothing where the light lies in it.
std::optional<Vec4d> turned(const Plane& plane, Vec4d light)
{
    const double ofLight = dot(asRow(plane), light);
    if (!(std::abs(ofLight) > 1e-12 * length(xyz(light)))) return std::nullopt;
    return (1 / ofLight) * asRow(plane);
}

// Whether something seen of the plane faces the light: eye and light are on one side.
bool facesLight(const Plane& plane, Vec4d light, Vec4d eye)
{
    return dot(asRow(plane), light) * dot(asRow(plane), eye) > 0;
}

// What is not behind the plane, as the light sees it; with room for the rounding of points on it.
Plane notBehind(const Plane& plane, Vec4d light, const Box& sceneLocal)
{
    const double side = dot(asRow(plane), light) < 0 ? -1 : 1;
    const auto reach = [](double low, double high) { return std::max(std::abs(low), std::abs(high)); };
    const Box& box = sceneLocal;
    const double farthest = reach(box.min.x, box.max.x) + reach(box.min.y, box.max.y) + reach(box.min.z, box.max.z);
    return {side * plane.normal, side * plane.offset + kOnPlane * (farthest + std::abs(plane.offset))};
}

// Whether both planes meet within the box: whether their line has a part in it.
bool meetIn(const Box& box, const Plane& a, const Plane& b)
{
    const Vec3d along = cross(a.normal, b.normal);
    const double size = dot(along, along);
    if (!(size > 1e-12)) return false;
    const Vec3d at = (-a.offset * cross(b.normal, along) - b.offset * cross(along, a.normal)) / size;
    double from = -std::numeric_limits<double>::infinity(), to = -from;
    const std::array<std::array<double, 4>, 3> axes{{{at.x, along.x, box.min.x, box.max.x},
                                                     {at.y, along.y, box.min.y, box.max.y},
                                                     {at.z, along.z, box.min.z, box.max.z}}};
    for (const auto& [p, d, low, high] : axes) {
        // A line within a side of the box counts as in it.
        const double room = 1e-9 * (std::abs(low) + std::abs(high) + (high - low));
        if (std::abs(d) < 1e-12) {
            if (p < low - room || p > high + room) return false;
            continue;
        }
        const double first = (low - room - p) / d, second = (high + room - p) / d;
        from = std::max(from, std::min(first, second));
        to = std::min(to, std::max(first, second));
    }
    return from < to;
}

// Half-spaces through the light and the sides of a plane's polygon, inside positive; nothing where the light lies in one.
void addSides(const InterestPlane& plane, Vec4d light, CellPlanes& sides)
{
    const auto& corners = plane.polygonLocal;
    if (corners.size() < 3) return;
    Vec3d middle;
    for (const Vec3d& corner : corners) middle = middle + (1.0 / double(corners.size())) * corner;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3d a = corners[i], along = corners[(i + 1) % corners.size()] - a;
        const Vec3d normal = normalized(cross(along, xyz(light) - light.w * a));
        if (!(length(normal) > 0)) continue;
        const Plane side = planeThrough(a, normal);
        sides.push_back(side.signedDistance(middle) < 0 ? Plane{-side.normal, -side.offset} : side);
    }
}

} // namespace

InterestPlane interestPlane(const NamedPlane& plane, Vec3d originWorld, int number, FitScratch::OnPlane& scratch)
{
    const Vec3d at = plane.pointWorld - originWorld;
    InterestPlane out{planeThrough(at, plane.normalWorld), {}, number};
    if (plane.polygonWorld.size() < 3) return out;
    const Vec3d u = anyPerpendicular(plane.normalWorld), v = cross(plane.normalWorld, u);
    scratch.points.clear();
    for (const Vec3d& corner : plane.polygonWorld) {
        const Vec3d p = corner - originWorld - at;
        scratch.points.push_back({dot(u, p), dot(v, p)});
    }
    scratch.hull.resize(scratch.points.size() + 1);
    const std::span<const Vec2d> hull{scratch.hull.data(), convexHull(scratch.points, scratch.hull)};
    const auto add = [&](Vec2d p) { out.polygonLocal.push_back(at + p.x * u + p.y * v); };
    if (hull.size() > out.polygonLocal.capacity()) {
        const OrientedRectangle r = minimumAreaRectangle(hull);
        const Vec2d a = r.halfSize.x * r.axis, b = r.halfSize.y * Vec2d{-r.axis.y, r.axis.x};
        for (const Vec2d& corner : {r.centre - a - b, r.centre + a - b, r.centre + a + b, r.centre - a + b})
            add(corner);
    } else if (hull.size() >= 3) {
        for (const Vec2d& corner : hull) add(corner);
    }
    return out;
}

CellsResult splitPlanes(const FitInput& input, std::span<const InterestPlane> planes, Twist twist)
{
    if (planes.empty()) return Unexpected{FitFailure::NoSuchPlane};
    const Vec4d light = lightLocal(input), eye = eyeLocal(input.view, input.originWorld);
    Cells cells;
    for (const InterestPlane& plane : planes) {
        Cell cell;
        cell.plane = PlaneOfCell{plane.planeLocal, twist, std::nullopt};
        cell.planeNumber = plane.number;
        addSides(plane, light, cell.servesLocal);
        const auto own = turned(plane.planeLocal, light);
        for (const InterestPlane& other : planes) {
            if (!own || &other == &plane || !plane.polygonLocal.empty() || !other.polygonLocal.empty()) continue;
            if (!facesLight(other.planeLocal, light, eye)) continue; // it has no map
            const auto others = turned(other.planeLocal, light);
            if (!others || !meetIn(input.sceneLocal, plane.planeLocal, other.planeLocal)) continue;
            // Zero at the light and on the line; positive where a ray comes to this plane first.
            const Plane cut = asPlane(*others - *own);
            cell.servesLocal.push_back(cut);
            if (!cell.plane->throughLineLocal) cell.plane->throughLineLocal = cut;
        }
        if (cell.plane->throughLineLocal == std::nullopt && !cell.servesLocal.empty())
            cell.plane->throughLineLocal = cell.servesLocal[0];
        cell.holdsLocal = cell.servesLocal;
        if (input.wantsWholePixels) cell.servesLocal.push_back(notBehind(plane.planeLocal, light, input.sceneLocal));
        cells.push_back(cell);
    }
    return cells;
}

} // namespace lixel
