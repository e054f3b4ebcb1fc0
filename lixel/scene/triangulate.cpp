// SPDX-License-Identifier: MIT
#include "lixel/scene/triangulate.h"

#include <cmath>
#include <numeric>

namespace lixel {
namespace {

constexpr std::size_t kMostCorners = 512; // clipping is cubic at worst

// Newell's normal: twice the area, on the side from which the polygon runs counter-clockwise.
Vec3d areaNormal(std::span<const Vec3d> corners)
{
    Vec3d normal;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        normal = normal + cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    return normal;
}

// The polygon along the largest axis of its normal, counter-clockwise.
std::vector<Vec2d> flattened(std::span<const Vec3d> corners, Vec3d normal)
{
    const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
    std::vector<Vec2d> flat;
    for (const Vec3d& p : corners) {
        if (x >= y && x >= z) flat.push_back(normal.x > 0 ? Vec2d{p.y, p.z} : Vec2d{p.z, p.y});
        else if (y >= z) flat.push_back(normal.y > 0 ? Vec2d{p.z, p.x} : Vec2d{p.x, p.z});
        else flat.push_back(normal.z > 0 ? Vec2d{p.x, p.y} : Vec2d{p.y, p.x});
    }
    return flat;
}

double turn(Vec2d a, Vec2d b, Vec2d c) { return cross(b - a, c - b); }

bool isEar(const std::vector<Vec2d>& flat, const std::vector<std::uint32_t>& left, std::size_t at)
{
    const std::size_t n = left.size(), before = (at + n - 1) % n, after = (at + 1) % n;
    const Vec2d a = flat[left[before]], b = flat[left[at]], c = flat[left[after]];
    if (!(turn(a, b, c) > 0)) return false;
    for (std::size_t i = 0; i < n; ++i) {
        if (i == before || i == at || i == after) continue;
        const Vec2d p = flat[left[i]];
        if (p == a || p == b || p == c) continue; // a seam runs twice through one point
        if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
    }
    return true;
}

void fan(const std::vector<std::uint32_t>& left, std::vector<std::uint32_t>& triangles)
{
    for (std::size_t i = 1; i + 1 < left.size(); ++i)
        triangles.insert(triangles.end(), {left[0], left[i], left[i + 1]});
}

} // namespace

void triangulatePolygon(std::span<const Vec3d> corners, std::vector<std::uint32_t>& triangles)
{
    std::vector<std::uint32_t> left(corners.size());
    std::iota(left.begin(), left.end(), 0u);
    if (corners.size() <= 3 || corners.size() > kMostCorners) return fan(left, triangles);

    const std::vector<Vec2d> flat = flattened(corners, areaNormal(corners));
    std::size_t at = 1, failures = 0;
    while (left.size() > 3 && failures < left.size()) {
        const std::size_t n = left.size();
        at %= n;
        if (!isEar(flat, left, at)) {
            ++at, ++failures;
            continue;
        }
        triangles.insert(triangles.end(), {left[(at + n - 1) % n], left[at], left[(at + 1) % n]});
        left.erase(left.begin() + std::ptrdiff_t(at));
        failures = 0;
    }
    fan(left, triangles);
}

} // namespace lixel
