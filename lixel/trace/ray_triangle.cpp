// SPDX-License-Identifier: MIT
#include "lixel/trace/ray_triangle.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lixel {
namespace {

Vec3d absolute(Vec3d a) { return {std::abs(a.x), std::abs(a.y), std::abs(a.z)}; }

// The components of |a| x |b| with plus for minus: what rounding errors of cross(a, b) are proportional to.
Vec3d crossMagnitude(Vec3d a, Vec3d b)
{
    return {std::abs(a.y * b.z) + std::abs(a.z * b.y), std::abs(a.z * b.x) + std::abs(a.x * b.z),
            std::abs(a.x * b.y) + std::abs(a.y * b.x)};
}

// A sum and a bound on its rounding error.
struct Bounded
{
    double value = 0, error = 0;

    bool maybePositive() const { return value >= -error; }
    bool maybeNegative() const { return value <= error; }
    bool isCertain() const { return std::abs(value) > error; }
};

// dot(a, cross(b, c)). Seven roundings lie on the way to each term (two of the differences that b and c are, one
// product, one difference, one product, two sums), each of 2^-53 of its value: 2^-50 of the magnitudes bounds them all.
Bounded tripleProduct(Vec3d a, Vec3d b, Vec3d c)
{
    return {dot(a, cross(b, c)), 0x1p-50 * dot(absolute(a), crossMagnitude(b, c))};
}

// A triangle's normal, as long as twice its area, and the magnitudes behind it.
struct Normal
{
    Vec3d value, magnitude;

    explicit Normal(const Corners& c)
        : value(cross(c[1] - c[0], c[2] - c[0])), magnitude(crossMagnitude(c[1] - c[0], c[2] - c[0]))
    {
    }
    Bounded along(Vec3d a) const { return {dot(value, a), 0x1p-50 * dot(magnitude, absolute(a))}; }
};

} // namespace

std::optional<TriangleHit> intersect(const Ray& ray, const Corners& corners)
{
    // The signed volumes of the ray's direction with each edge as seen from the origin: all of one sign within the
    // triangle.
    const Vec3d a = corners[0] - ray.origin, b = corners[1] - ray.origin, c = corners[2] - ray.origin;
    const Bounded wa = tripleProduct(ray.direction, b, c);
    const Bounded wb = tripleProduct(ray.direction, c, a);
    const bool maybePositive = wa.maybePositive() && wb.maybePositive();
    const bool maybeNegative = wa.maybeNegative() && wb.maybeNegative();
    if (!maybePositive && !maybeNegative) return std::nullopt;
    const Bounded wc = tripleProduct(ray.direction, a, b);
    if (!(maybePositive && wc.maybePositive()) && !(maybeNegative && wc.maybeNegative())) return std::nullopt;

    // The distance from the plane itself: better conditioned than the volumes.
    const Normal normal(corners);
    const Bounded speed = normal.along(ray.direction);
    if (!speed.isCertain()) return std::nullopt;
    const double height = -dot(normal.value, a);
    const double t = -height / speed.value;
    if (!(t > ray.tMin)) return std::nullopt;
    if (ray.end) {
        const Bounded heightOfEnd = normal.along(*ray.end - corners[0]);
        if (!heightOfEnd.isCertain() || (heightOfEnd.value > 0) == (height > 0)) return std::nullopt;
    }
    const double sum = wa.value + wb.value + wc.value;
    if (sum == 0) return TriangleHit{t, 1.0 / 3, 1.0 / 3};
    return TriangleHit{t, wb.value / sum, wc.value / sum};
}

std::optional<double> meetPlane(Vec3d origin, Vec3d direction, const Corners& corners)
{
    const Normal normal(corners);
    const Bounded speed = normal.along(direction);
    if (!speed.isCertain()) return std::nullopt;
    return dot(normal.value, corners[0] - origin) / speed.value;
}

std::optional<Vec3d> unitNormal(const Corners& corners)
{
    const Normal normal(corners);
    const Vec3d n = normal.value;
    const double doubleArea = length(n), rounding = 0x1p-50 * length(normal.magnitude);
    if (!(doubleArea > rounding)) return std::nullopt;
    return n / doubleArea;
}

std::optional<Vec3d> drawnInto(const Corners& corners, Vec3d p, double leastWeight)
{
    const std::optional<Vec3d> n = unitNormal(corners);
    if (!n) return std::nullopt;
    const auto [a, b, c] = corners;
    const Vec3d onPlane = p - dot(*n, p - a) * *n;
    const double doubleArea = dot(*n, cross(b - a, c - a));
    double wb = dot(*n, cross(onPlane - a, c - a)) / doubleArea, wc = dot(*n, cross(b - a, onPlane - a)) / doubleArea;
    double wa = 1 - wb - wc;
    if (wa >= leastWeight && wb >= leastWeight && wc >= leastWeight) return onPlane;
    wa = std::max(wa, leastWeight), wb = std::max(wb, leastWeight), wc = std::max(wc, leastWeight);
    const double sum = wa + wb + wc;
    return a + (wb / sum) * (b - a) + (wc / sum) * (c - a);
}

Interval clipToBox(Vec3d origin, Vec3d direction, const Box& box, Interval interval)
{
    const double from[3] = {origin.x, origin.y, origin.z}, along[3] = {direction.x, direction.y, direction.z};
    const double low[3] = {box.min.x, box.min.y, box.min.z}, high[3] = {box.max.x, box.max.y, box.max.z};
    for (int axis = 0; axis < 3; ++axis) {
        if (along[axis] == 0) {
            if (!(from[axis] >= low[axis] && from[axis] <= high[axis])) return {0, -1};
            continue;
        }
        double enter = (low[axis] - from[axis]) / along[axis], leave = (high[axis] - from[axis]) / along[axis];
        if (enter > leave) std::swap(enter, leave);
        interval = {std::max(interval.first, enter), std::min(interval.last, leave)};
    }
    return interval;
}

SearchRay searchRay(Vec3d origin, Vec3d direction, Interval interval)
{
    const double length = lixel::length(direction);
    if (!(interval.first <= interval.last) || !(length > 0)) return {{}, {}, 0, -1};
    SearchRay ray;
    ray.origin = toFloat(origin + interval.first * direction);
    ray.direction = toFloat(direction / length);
    ray.tMax = std::nextafter(float((interval.last - interval.first) * length), std::numeric_limits<float>::infinity());
    return ray;
}

} // namespace lixel
