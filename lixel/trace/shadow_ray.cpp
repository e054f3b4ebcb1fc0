// SPDX-License-Identifier: MIT
#include "lixel/trace/shadow_ray.h"

#include "lixel/base/assert.h"

#include <algorithm>
#include <cmath>

namespace lixel {
namespace {

// The least width of six corners, in such roundings, at which they still say what plane they lie in.
constexpr double kLeastWidth = 16;

double largestCoordinate(Vec3d a) { return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)}); }

double largestCoordinate(const Corners& c)
{
    return std::max({largestCoordinate(c[0]), largestCoordinate(c[1]), largestCoordinate(c[2])});
}

// The least height of a triangle, from its unit normal.
double leastHeight(const Corners& c, Vec3d normal)
{
    const double longest = std::max({length(c[1] - c[0]), length(c[2] - c[1]), length(c[0] - c[2])});
    return dot(normal, cross(c[1] - c[0], c[2] - c[0])) / longest;
}

// The state of one walk through the tree.
struct Walk
{
    const TraceScene& scene;
    Ray ray;
    std::uint32_t ownTriangle;
    std::optional<Corners> ownCorners;

    bool isBlockedBy(std::uint32_t triangle) const
    {
        if (triangle == ownTriangle) return false;
        const Corners corners = scene.corners(triangle);
        const std::optional<TriangleHit> hit = intersect(ray, corners);
        if (!hit || !scene.keeps(triangle, float(hit->u), float(hit->v))) return false;
        return !ownCorners || !areOneFlatSurface(*ownCorners, corners);
    }
};

} // namespace

RayStart rayStart(const TraceScene& scene, const SurfacePoint& sample)
{
    const Vec3d p = toDouble(sample.positionLocal), n = toDouble(sample.normal);
    if (sample.triangle != kNoTriangle) {
        LX_ASSERT(sample.triangle < scene.triangles().triangleCount());
        const Corners corners = scene.corners(sample.triangle);
        if (const std::optional<Vec3d> start = drawnInto(corners, p, kLeastWeightOfStart)) {
            const Vec3d exact = *unitNormal(corners);
            const double largest = std::max(largestCoordinate(corners), largestCoordinate(p));
            const double undecided = std::min(kCornerRounding * largest / leastHeight(corners, exact), kMostUndecided);
            return {*start, dot(exact, n) < 0 ? -exact : exact, largest, undecided};
        }
    }
    const double largest = largestCoordinate(p);
    return {p + kLiftOfUnknown * largest * n, n, largest, kCornerRounding};
}

std::optional<Ray> rayTowards(const RayStart& start, const Light& light, Vec3d originWorld)
{
    const bool isAtInfinity = light.kind == LightKind::Directional;
    Ray ray;
    ray.origin = start.positionLocal;
    ray.direction = isAtInfinity ? -light.directionWorld : (light.positionWorld - originWorld) - ray.origin;
    const double distance = length(ray.direction), rise = dot(start.normal, ray.direction);
    if (!(distance > 0)) return std::nullopt;
    if (rise > start.undecided * distance) {
        ray.tMin = kStartRounding * start.largestCoordinate / rise;
    } else {
        ray.origin = start.positionLocal + kCornerRounding * start.largestCoordinate * start.normal;
        ray.direction = ray.direction + (start.undecided * distance - rise) * start.normal;
    }
    if (!isAtInfinity) ray.end = ray.origin + ray.direction;
    return ray;
}

bool areOneFlatSurface(const Corners& a, const Corners& b)
{
    const Vec3d p[6] = {a[0], a[1], a[2], b[0], b[1], b[2]};
    const double rounding = kCornerRounding * std::max(largestCoordinate(a), largestCoordinate(b));

    // The widest base there is: the pair farthest apart and the corner farthest from the line through it.
    int first = 0, second = 1;
    double longest = -1;
    for (int i = 0; i < 6; ++i) {
        for (int j = i + 1; j < 6; ++j) {
            const double squared = dot(p[j] - p[i], p[j] - p[i]);
            if (squared > longest) longest = squared, first = i, second = j;
        }
    }
    if (!(longest > 0)) return false;
    Vec3d normal;
    for (const Vec3d& corner : p) {
        const Vec3d n = cross(p[second] - p[first], corner - p[first]);
        if (dot(n, n) > dot(normal, normal)) normal = n;
    }
    const double width = length(normal) / std::sqrt(longest);
    if (!(width > kLeastWidth * rounding)) return false;
    const Vec3d unit = normalized(normal);
    return std::all_of(std::begin(p), std::end(p),
                       [&](Vec3d corner) { return std::abs(dot(unit, corner - p[first])) <= rounding; });
}

bool isInShadow(const TraceScene& scene, const SurfacePoint& sample, const Light& light)
{
    const std::optional<Ray> ray = rayTowards(rayStart(scene, sample), light, scene.originWorld());
    if (!ray) return false;
    Walk walk{scene, *ray, sample.triangle, std::nullopt};
    if (sample.triangle != kNoTriangle) walk.ownCorners = scene.corners(sample.triangle);
    const Interval whole{0, ray->end ? 1 : std::numeric_limits<double>::infinity()};
    const Interval inScene = clipToBox(ray->origin, ray->direction, scene.searchBoxLocal(), whole);
    const auto isBlocked = [](void* query, std::uint32_t triangle) {
        return static_cast<const Walk*>(query)->isBlockedBy(triangle);
    };
    return scene.embree().anyBlocks(searchRay(ray->origin, ray->direction, inScene), isBlocked, &walk);
}

} // namespace lixel
