// SPDX-License-Identifier: MIT
#include "trace/reference_visibility.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace lixel::test {
namespace {

using Real = long double;

struct Point
{
    Real x = 0, y = 0, z = 0;
    Real operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
};
Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Point operator*(Real s, Point a) { return {s * a.x, s * a.y, s * a.z}; }
Real inner(Point a, Point b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point outer(Point a, Point b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
Real norm(Point a) { return std::sqrt(inner(a, a)); }
Real largest(Point a) { return std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)}); }
Point real(Vec3d a) { return {a.x, a.y, a.z}; }
Point real(Vec3f a) { return {a.x, a.y, a.z}; }

struct Triangle
{
    Point a, b, c;

    Real largestCoordinate() const { return std::max({largest(a), largest(b), largest(c)}); }
    Point normal() const
    {
        const Point n = outer(b - a, c - a);
        return (1 / norm(n)) * n;
    }
    Real leastHeight() const { return norm(outer(b - a, c - a)) / std::max({norm(b - a), norm(c - b), norm(a - c)}); }
};

Triangle triangleOf(const LocalTriangles& all, std::uint32_t t)
{
    const auto corner = [&](std::uint32_t k) { return real(all.positionLocal[all.indices[3 * std::size_t(t) + k]]); };
    return {corner(0), corner(1), corner(2)};
}

Point nearestOnSegment(Point p, Point from, Point to)
{
    const Point along = to - from;
    const Real t = std::clamp<Real>(inner(p - from, along) / inner(along, along), 0, 1);
    return from + t * along;
}

// The point of the triangle whose corners are drawn together until each weighs 1e-6 everywhere, nearest to p.
Point nearestOnInset(const Triangle& whole, Point p)
{
    const Real w = 1e-6L;
    const Point sum = whole.a + whole.b + whole.c;
    const auto drawnIn = [&](Point corner) { return (1 - 3 * w) * corner + w * sum; };
    const Triangle t{drawnIn(whole.a), drawnIn(whole.b), drawnIn(whole.c)};
    const Point n = t.normal();
    const Point foot = p - inner(p - t.a, n) * n;
    const auto isInside = [&](Point from, Point to) { return inner(outer(to - from, foot - from), n) >= 0; };
    if (isInside(t.a, t.b) && isInside(t.b, t.c) && isInside(t.c, t.a)) return foot;
    Point best = nearestOnSegment(foot, t.a, t.b);
    for (const Point q : {nearestOnSegment(foot, t.b, t.c), nearestOnSegment(foot, t.c, t.a)})
        if (norm(q - foot) < norm(best - foot)) best = q;
    return best;
}

// All six corners within 2^-20 of the largest coordinate of one plane, the one through the widest three of them.
bool areOneSheet(const Triangle& s, const Triangle& t)
{
    const Point p[6] = {s.a, s.b, s.c, t.a, t.b, t.c};
    const Real tolerance = std::max(s.largestCoordinate(), t.largestCoordinate()) * 0x1p-20L;
    int from = 0, to = 0;
    for (int i = 0; i < 6; ++i)
        for (int j = i; j < 6; ++j)
            if (norm(p[j] - p[i]) > norm(p[to] - p[from])) from = i, to = j;
    const Point axis = p[to] - p[from];
    int side = from;
    for (int i = 0; i < 6; ++i)
        if (norm(outer(axis, p[i] - p[from])) > norm(outer(axis, p[side] - p[from]))) side = i;
    const Point n = outer(axis, p[side] - p[from]);
    if (norm(n) <= 16 * tolerance * norm(axis)) return false;
    for (const Point q : p)
        if (std::fabs(inner(q - p[from], n)) > tolerance * norm(n)) return false;
    return true;
}

// The texel index that OpenGL 4.5 gives (table 8.20).
int wrapped(int i, int size, Wrap wrap)
{
    const auto modulo = [](int a, int n) { return ((a % n) + n) % n; };
    if (wrap == Wrap::Repeat) return modulo(i, size);
    if (wrap == Wrap::ClampToEdge) return std::clamp(i, 0, size - 1);
    const int m = modulo(i, 2 * size);
    return m < size ? m : 2 * size - 1 - m;
}

Real textureAlpha(const Texture& texture, Real u, Real v)
{
    const int width = texture.pixels.width(), height = texture.pixels.height();
    const Real x = u * width - 0.5L, y = v * height - 0.5L;
    const int i = int(std::floor(x)), j = int(std::floor(y));
    const Real a = x - i, b = y - j;
    const auto texel = [&](int di, int dj) {
        return Real(texture.pixels(wrapped(i + di, width, texture.wrapU), wrapped(j + dj, height, texture.wrapV)).a) /
               255;
    };
    return (1 - b) * ((1 - a) * texel(0, 0) + a * texel(1, 0)) + b * ((1 - a) * texel(0, 1) + a * texel(1, 1));
}

} // namespace

struct ReferenceScene::Ray
{
    Point origin, direction; // to the light where it is at a point
    Real first = 0, last = std::numeric_limits<Real>::infinity();
    bool isGrazing = false;
    std::uint32_t own = kNoTriangle;
    Triangle ownCorners;
    Point bareOrigin, bareDirection; // before it was turned up
};

ReferenceScene::ReferenceScene(const LocalTriangles& triangles, std::span<const Material> materials,
                               std::span<const Texture> textures)
    : triangles_(triangles), materials_(materials), textures_(textures), order_(triangles.triangleCount())
{
    std::iota(order_.begin(), order_.end(), 0u);
    Real size = 0;
    for (std::uint32_t t = 0; t < order_.size(); ++t) {
        const Triangle c = triangleOf(triangles_, t);
        const Point m = Real(1) / 3 * (c.a + c.b + c.c);
        centre_.push_back({double(m.x), double(m.y), double(m.z)});
        size = std::max(size, c.largestCoordinate());
    }
    padding_ = 1e-12 * double(size); // far above the rounding of boxes in double
    if (!order_.empty()) build(0, std::uint32_t(order_.size()));
}

std::uint32_t ReferenceScene::build(std::uint32_t first, std::uint32_t count)
{
    const auto index = std::uint32_t(nodes_.size());
    nodes_.emplace_back();
    Node node;
    double lowCentre[3], highCentre[3];
    for (int k = 0; k < 3; ++k) {
        node.low[k] = lowCentre[k] = std::numeric_limits<double>::infinity();
        node.high[k] = highCentre[k] = -std::numeric_limits<double>::infinity();
    }
    const auto component = [](Vec3d p, int k) { return k == 0 ? p.x : k == 1 ? p.y : p.z; };
    for (std::uint32_t i = first; i < first + count; ++i) {
        const Triangle t = triangleOf(triangles_, order_[i]);
        for (int k = 0; k < 3; ++k) {
            node.low[k] = std::min(node.low[k], double(std::min({t.a[k], t.b[k], t.c[k]})) - padding_);
            node.high[k] = std::max(node.high[k], double(std::max({t.a[k], t.b[k], t.c[k]})) + padding_);
            lowCentre[k] = std::min(lowCentre[k], component(centre_[order_[i]], k));
            highCentre[k] = std::max(highCentre[k], component(centre_[order_[i]], k));
        }
    }
    if (count <= 4) {
        node.first = first, node.count = count;
        nodes_[index] = node;
        return index;
    }
    int axis = 0;
    for (int k = 1; k < 3; ++k)
        if (highCentre[k] - lowCentre[k] > highCentre[axis] - lowCentre[axis]) axis = k;
    const auto begin = order_.begin() + first;
    std::nth_element(begin, begin + count / 2, begin + count, [&](std::uint32_t s, std::uint32_t t) {
        return component(centre_[s], axis) < component(centre_[t], axis);
    });
    build(first, count / 2);
    node.second = build(first + count / 2, count - count / 2);
    nodes_[index] = node;
    return index;
}

ReferenceScene::Ray ReferenceScene::rayOf(const ViewSamples& samples, std::size_t i, const Light& light) const
{
    Ray ray;
    ray.own = samples.triangle[i];
    ray.ownCorners = triangleOf(triangles_, ray.own);
    const Point p = real(samples.positionLocal[i]);
    const Real size = std::max(ray.ownCorners.largestCoordinate(), largest(p));
    Point n = ray.ownCorners.normal();
    if (inner(n, real(samples.normal[i])) < 0) n = -1 * n;
    const bool isAtPoint = light.kind != LightKind::Directional;
    const Point towards = isAtPoint ? real(light.positionWorld - samples.originWorld) : -1 * real(light.directionWorld);
    ray.origin = nearestOnInset(ray.ownCorners, p);
    ray.direction = isAtPoint ? towards - ray.origin : towards;
    ray.bareOrigin = ray.origin, ray.bareDirection = ray.direction;

    const Real undecided = std::min<Real>(size * 0x1p-20L / ray.ownCorners.leastHeight(), 0x1p-6L);
    const Real rise = inner(n, ray.direction), distance = norm(ray.direction);
    ray.isGrazing = !(rise > undecided * distance);
    if (ray.isGrazing) {
        ray.origin = ray.origin + (size * 0x1p-20L) * n;
        ray.direction = ray.direction + (undecided * distance - rise) * n;
    } else {
        ray.first = size * 0x1p-48L / rise;
    }
    if (isAtPoint) ray.last = 1 - 1e-13L;
    return ray;
}

bool ReferenceScene::keeps(std::uint32_t triangle, Real u, Real v) const
{
    const Material& material = materials_[triangles_.material[triangle]];
    if (material.alphaMode != AlphaMode::Mask) return true;
    const std::uint32_t* at = triangles_.indices.data() + 3 * std::size_t(triangle);
    const auto blend = [&](Real a, Real b, Real c) { return (1 - u - v) * a + u * b + v * c; };
    Real alpha = material.baseColour.w;
    if (!triangles_.colour.empty())
        alpha *= blend(triangles_.colour[at[0]].w, triangles_.colour[at[1]].w, triangles_.colour[at[2]].w);
    if (material.texture >= 0 && !triangles_.uv.empty()) {
        const Vec2f a = triangles_.uv[at[0]], b = triangles_.uv[at[1]], c = triangles_.uv[at[2]];
        alpha *= textureAlpha(textures_[std::size_t(material.texture)], blend(a.x, b.x, c.x), blend(a.y, b.y, c.y));
    }
    return alpha >= Real(material.alphaCutoff);
}

bool ReferenceScene::blocks(const Ray& ray, std::uint32_t triangle, bool withFlatRule) const
{
    if (triangle == ray.own) return false;
    const Triangle t = triangleOf(triangles_, triangle);
    const Point e1 = t.b - t.a, e2 = t.c - t.a;
    const Point p = outer(ray.direction, e2);
    const Real determinant = inner(e1, p);
    if (determinant == 0) return false;
    const Point s = ray.origin - t.a;
    const Real u = inner(s, p) / determinant;
    if (!(u >= 0 && u <= 1)) return false;
    const Point q = outer(s, e1);
    const Real v = inner(ray.direction, q) / determinant;
    if (!(v >= 0 && u + v <= 1)) return false;
    const Real along = inner(e2, q) / determinant;
    if (!(along > ray.first && along < ray.last)) return false;
    return keeps(triangle, u, v) && !(withFlatRule && areOneSheet(ray.ownCorners, t));
}

std::uint32_t ReferenceScene::firstBlocker(const Ray& ray, bool withFlatRule) const
{
    if (nodes_.empty()) return kNoTriangle;
    std::vector<std::uint32_t> open{0};
    while (!open.empty()) {
        const std::uint32_t index = open.back();
        const Node& node = nodes_[index];
        open.pop_back();
        Real enter = 0, leave = ray.last;
        for (int k = 0; k < 3; ++k) {
            const Real o = ray.origin[k], d = ray.direction[k];
            if (d == 0) {
                if (o < Real(node.low[k]) || o > Real(node.high[k])) leave = -1;
                continue;
            }
            const Real t0 = (Real(node.low[k]) - o) / d, t1 = (Real(node.high[k]) - o) / d;
            enter = std::max(enter, std::min(t0, t1));
            leave = std::min(leave, std::max(t0, t1));
        }
        if (enter > leave) continue;
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
            if (blocks(ray, order_[i], withFlatRule)) return order_[i];
        if (node.count == 0) open.insert(open.end(), {index + 1, node.second});
    }
    return kNoTriangle;
}

ReferenceAnswer ReferenceScene::visibility(const ViewSamples& samples, std::size_t i, const Light& light) const
{
    Ray ray = rayOf(samples, i, light);
    ReferenceAnswer answer;
    answer.isGrazing = ray.isGrazing;
    answer.blocker = firstBlocker(ray, true);
    answer.isLit = answer.blocker == kNoTriangle;
    ray.origin = ray.bareOrigin, ray.direction = ray.bareDirection;
    answer.isLitByBareGeometry = answer.isLit && firstBlocker(ray, false) == kNoTriangle;
    return answer;
}

double ReferenceScene::nearestEdge(const ViewSamples& samples, std::size_t i, const Light& light) const
{
    const Ray ray = rayOf(samples, i, light);
    Real nearest = std::numeric_limits<Real>::infinity();
    const auto take = [&](Point from, Point to) {
        // The common perpendicular of two lines, if it meets both between their ends.
        const Point e = to - from, n = outer(ray.direction, e), s = from - ray.origin;
        const Real squared = inner(n, n);
        if (squared == 0) return;
        const Real onEdge = inner(outer(s, ray.direction), n) / squared, onRay = inner(outer(s, e), n) / squared;
        if (onEdge < 0 || onEdge > 1 || onRay <= ray.first || onRay >= ray.last) return;
        nearest = std::min(nearest, std::fabs(inner(s, n)) / std::sqrt(squared) / (onRay * norm(ray.direction)));
    };
    for (std::uint32_t t = 0; t < order_.size(); ++t) {
        if (t == ray.own) continue;
        const Triangle c = triangleOf(triangles_, t);
        take(c.a, c.b), take(c.b, c.c), take(c.c, c.a);
    }
    return double(nearest);
}

} // namespace lixel::test
