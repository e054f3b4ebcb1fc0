// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/visible_body.h"

#include "lixel/plan/fit/light_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

namespace lixel {
namespace {

constexpr std::size_t kConeSides = 8;

// Corners outside a plane by less than this part of what their distance is made of lie in it: several planes meet at a light, and
// rounding would cut what is there again and again.
constexpr double kInPlane = 1e-13;

// Casters beside a map by less than this part of the scene only touch it; they count as in it, so that rounding does not decide.
constexpr double kTouching = 1e-9;

// Half-spaces around a spot's cone, last in their list: eight through the light, touching the cone.
void addCone(const Light& light, Vec3d lightLocal, BodyPlanes& planes)
{
    const double sine = std::sin(light.coneAngle / 2), cosine = std::cos(light.coneAngle / 2);
    const Vec3d axis = light.directionWorld, u = anyPerpendicular(axis), v = cross(axis, u);
    for (int i = 0; i < int(kConeSides); ++i) {
        const double a = 2 * std::numbers::pi * i / double(kConeSides);
        const Vec3d outward = std::cos(a) * u + std::sin(a) * v;
        planes.push_back(planeThrough(lightLocal, sine * axis - cosine * outward));
    }
}

void addRange(double range, Vec3d lightLocal, BodyPlanes& planes)
{
    for (const Vec3d axis : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}})
        for (const double sign : {1.0, -1.0})
            planes.push_back(planeThrough(lightLocal + sign * range * axis, -sign * axis));
}

// What must hold for a point of the region to be in the light's reach.
void addReached(const FitInput& input, BodyPlanes& planes)
{
    for (const Plane& plane : input.cellLocal) planes.push_back(plane);
    if (input.light.kind == LightKind::Directional) return;
    const Vec3d lightLocal = input.light.positionWorld - input.originWorld;
    if (std::isfinite(input.light.range)) addRange(input.light.range, lightLocal, planes);
    if (input.light.kind == LightKind::Spot) addCone(input.light, lightLocal, planes);
}

// A spot inside the scene is a corner of what it reaches. The cone of directions is spanned by the other corners.
// A region that begins at the light may have no others.
void dropPointsAt(Vec3d lightLocal, double least, std::vector<Vec3d>& points)
{
    std::erase_if(points, [&](Vec3d p) { return squaredDistance(p, lightLocal) <= least * least; });
}

// Whether some point of the box may be so near to p, or is by rounding.
bool isNear(const Box& box, Vec3d p, double least)
{
    const double room = 2 * least;
    return box.min.x - room <= p.x && p.x <= box.max.x + room && box.min.y - room <= p.y && p.y <= box.max.y + room &&
           box.min.z - room <= p.z && p.z <= box.max.z + room;
}

// Whether a ball around the box lies within a spot's cone: then none of the planes around the cone needs asking.
class ConeTest
{
public:
    ConeTest(const Light& light, Vec3d originWorld)
        : lightLocal_(light.positionWorld - originWorld),
          axis_(light.directionWorld),
          sine_(std::sin(light.coneAngle / 2)),
          cosine_(std::cos(light.coneAngle / 2)),
          isSpot_(light.kind == LightKind::Spot)
    {
    }
    bool holds(const Box& box) const
    {
        if (!isSpot_) return false;
        const Vec3d to = box.centre() - lightLocal_;
        const double along = dot(to, axis_), asideSquared = std::max(0.0, dot(to, to) - along * along);
        // Further than the ball's radius from the cone's side: along * sine - aside * cosine > radius.
        const double most = along * sine_ - 0.5 * length(box.max - box.min);
        return most > 0 && most * most > asideSquared * cosine_ * cosine_;
    }

private:
    Vec3d lightLocal_, axis_;
    double sine_, cosine_;
    bool isSpot_;
};

void findPoints(const FitInput& input, const BodyPlanes& planes, std::vector<Vec3d>& points)
{
    points.clear();
    const ConeTest cone(input.light, input.originWorld);
    const std::span<const Plane> all{planes.data(), planes.size()};
    const Vec3d lightLocal = input.light.positionWorld - input.originWorld;
    const double atLight = 1e-9 * (input.sceneLocal.diagonal() + length(lightLocal)); // above the rounding of clipping
    bool isLightNear = false;
    for (const Box& boxWorld : input.casterBoxesWorld) {
        if (boxWorld.isEmpty()) continue;
        const Box box = translated(boxWorld, -input.originWorld);
        isLightNear |= isNear(box, lightLocal, atLight);
        appendClippedBox(box, cone.holds(box) ? all.first(all.size() - kConeSides) : all, points);
    }
    if (isLightNear && input.light.kind != LightKind::Directional) dropPointsAt(lightLocal, atLight, points);
}

// A corner of a box that is being cut, and the planes it lies on: bits 0 to 5 the box's, then those that cut it.
struct CutCorner
{
    Vec3d p;
    std::uint64_t planes = 0;
};

// A polytope between n planes has 2 n - 4 corners at most.
using CutCorners = FixedVector<CutCorner, 2 * (6 + BodyPlanes::capacity()) - 4>;
static_assert(6 + BodyPlanes::capacity() <= 64);

bool hasTwo(std::uint64_t bits)
{
    return (bits & (bits - 1)) != 0;
} // at least; std::popcount is a call without its instruction

// What a plane leaves: the corners inside, and one on each edge that it crosses. Corners that share two planes share an edge (T.
// Motzkin et al. The Double Description Method. 1953); a corner in the plane, or nearer than `slack` to it, counts as inside, so
// that in terms of planes no more than three ever meet, whatever rounding makes of places. False where it cuts nothing: also where
// rounding makes more corners than a polytope has, for what is held is never less than there is.
bool cut(const CutCorners& corners, const Plane& plane, double slack, std::uint64_t bit, CutCorners& kept)
{
    std::array<double, CutCorners::capacity()> distance;
    bool isCut = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        distance[i] = plane.signedDistance(corners[i].p);
        isCut |= distance[i] < -slack;
    }
    if (!isCut) return false;
    kept.clear();
    FixedVector<std::uint32_t, CutCorners::capacity()> inside, outside;
    for (std::uint32_t i = 0; i < corners.size(); ++i)
        if (distance[i] < -slack) outside.push_back(i);
        else inside.push_back(i), kept.push_back(corners[i]);
    for (const std::uint32_t i : inside)
        for (const std::uint32_t o : outside) {
            const CutCorner &from = corners[i], &to = corners[o];
            const std::uint64_t shared = from.planes & to.planes;
            if (!hasTwo(shared)) continue;
            if (kept.size() == CutCorners::capacity()) return false;
            const double before = std::max(distance[i], 0.0);
            kept.push_back({from.p + before / (before - distance[o]) * (to.p - from.p), shared | bit});
        }
    return true;
}

} // namespace

void appendClippedBox(const Box& box, std::span<const Plane> planes, std::vector<Vec3d>& points)
{
    const Vec3d centre = box.centre(), half = 0.5 * (box.max - box.min);
    std::array<const Plane*, BodyPlanes::capacity()> cutting;
    std::size_t cuts = 0;
    for (const Plane& plane : planes) {
        const double middle = plane.signedDistance(centre);
        const double reach =
            std::abs(plane.normal.x) * half.x + std::abs(plane.normal.y) * half.y + std::abs(plane.normal.z) * half.z;
        if (middle < -reach) return;
        if (middle < reach) cutting[cuts++] = &plane;
    }
    const std::array<Vec3d, 8> boxCorners = box.corners();
    if (cuts == 0) {
        points.insert(points.end(), boxCorners.begin(), boxCorners.end());
        return;
    }
    CutCorners one, other, *corners = &one, *kept = &other;
    for (std::uint32_t i = 0; i < 8; ++i)
        corners->push_back({boxCorners[i], (i & 1 ? 2u : 1u) | (i & 2 ? 8u : 4u) | (i & 4 ? 32u : 16u)});
    const double farthest = length(centre) + length(half);
    for (std::size_t i = 0; i < cuts; ++i) {
        const double slack = kInPlane * (std::abs(cutting[i]->offset) + farthest);
        if (cut(*corners, *cutting[i], slack, std::uint64_t{64} << i, *kept)) std::swap(corners, kept);
    }
    for (const CutCorner& corner : *corners) points.push_back(corner.p);
}

void findVisiblePoints(const FitInput& input, std::vector<Vec3d>& points)
{
    if (input.cellLocal.empty() && input.visible) {
        points.assign(input.visible->points.begin(), input.visible->points.end());
        return;
    }
    BodyPlanes planes;
    for (const Plane& plane : clipPlanes(clipFromLocal(input.view, input.originWorld))) planes.push_back(plane);
    addReached(input, planes);
    findPoints(input, planes, points);
}

void findReachedPoints(const FitInput& input, std::vector<Vec3d>& points)
{
    BodyPlanes planes;
    addReached(input, planes);
    findPoints(input, planes, points);
}

double leastOverCasters(const FitInput& input, const Mat4d& lightClipFromLocal, Vec4d function, double most)
{
    const Vec4d x = lightClipFromLocal.row(0), y = lightClipFromLocal.row(1), z = lightClipFromLocal.row(2),
                w = lightClipFromLocal.row(3);
    const double slack = kTouching * (length(input.sceneLocal.centre()) + input.sceneLocal.diagonal());
    BodyPlanes planes;
    for (const Vec4d& side : {w + x, w - x, w + y, w - y, w - z})
        if (const double size = length(xyz(side)); size > 0)
            planes.push_back({(1 / size) * xyz(side), side.w / size + slack});

    const Vec3d steps{std::abs(function.x), std::abs(function.y), std::abs(function.z)};
    const auto leastOf = [&](const Box& boxWorld) {
        return dot(function, point(boxWorld.centre() - input.originWorld)) -
               0.5 * dot(steps, boxWorld.max - boxWorld.min);
    };
    // The box that goes lowest first: after it most others need no cutting.
    const Box* lowest = nullptr;
    double bound = most;
    for (const Box& box : input.casterBoxesWorld) {
        const double least = box.isEmpty() ? most : leastOf(box);
        if (least < bound) bound = least, lowest = &box;
    }
    std::vector<Vec3d>& points = input.scratch.casterPoints;
    const auto lower = [&](const Box& box) {
        points.clear();
        appendClippedBox(translated(box, -input.originWorld), {planes.data(), planes.size()}, points);
        for (const Vec3d& p : points) most = std::min(most, dot(function, point(p)));
    };
    if (lowest) lower(*lowest);
    for (const Box& box : input.casterBoxesWorld)
        if (!box.isEmpty() && &box != lowest && leastOf(box) < most) lower(box);
    return most;
}

ViewDepth viewDepth(const View& view, Vec3d originWorld)
{
    const Mat4d clip = clipFromLocal(view, originWorld);
    // A view's w grows along the line of sight; a parallel one's is constant, and its z does.
    const Vec4d w = clip.row(3), z = clip.row(2);
    const bool isPerspective = length(xyz(w)) > 1e-13 * (length(xyz(clip.row(0))) + length(xyz(z)));
    const Vec4d along = isPerspective ? w : (1 / w.w) * z + Vec4d{0, 0, 0, 1};
    const double size = length(xyz(along));
    return {(1 / size) * xyz(along), along.w / size, isPerspective};
}

} // namespace lixel
