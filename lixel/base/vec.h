// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

// Plain vectors. Points carry their space in their name (`eyeWorld`, `pointLocal`), not in their type.
namespace lixel {

struct Vec2d
{
    double x = 0, y = 0;
    friend constexpr bool operator==(const Vec2d&, const Vec2d&) = default;
};

struct Vec3d
{
    double x = 0, y = 0, z = 0;
    friend constexpr bool operator==(const Vec3d&, const Vec3d&) = default;
};

struct Vec4d
{
    double x = 0, y = 0, z = 0, w = 0;
    friend constexpr bool operator==(const Vec4d&, const Vec4d&) = default;
};

struct Vec2f
{
    float x = 0, y = 0;
    friend constexpr bool operator==(const Vec2f&, const Vec2f&) = default;
};

struct Vec3f
{
    float x = 0, y = 0, z = 0;
    friend constexpr bool operator==(const Vec3f&, const Vec3f&) = default;
};

struct Vec4f
{
    float x = 0, y = 0, z = 0, w = 0;
    friend constexpr bool operator==(const Vec4f&, const Vec4f&) = default;
};

constexpr Vec2d operator+(Vec2d a, Vec2d b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec2d operator-(Vec2d a, Vec2d b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec2d operator*(double s, Vec2d a) { return {s * a.x, s * a.y}; }
constexpr Vec2d operator*(Vec2d a, double s) { return s * a; }
constexpr double dot(Vec2d a, Vec2d b) { return a.x * b.x + a.y * b.y; }
constexpr double cross(Vec2d a, Vec2d b) { return a.x * b.y - a.y * b.x; }
inline double length(Vec2d a) { return std::hypot(a.x, a.y); }

constexpr Vec3d operator+(Vec3d a, Vec3d b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3d operator-(Vec3d a, Vec3d b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3d operator-(Vec3d a) { return {-a.x, -a.y, -a.z}; }
constexpr Vec3d operator*(double s, Vec3d a) { return {s * a.x, s * a.y, s * a.z}; }
constexpr Vec3d operator*(Vec3d a, double s) { return s * a; }
constexpr Vec3d operator/(Vec3d a, double s) { return {a.x / s, a.y / s, a.z / s}; }
constexpr double dot(Vec3d a, Vec3d b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3d cross(Vec3d a, Vec3d b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vec3d a) { return std::sqrt(dot(a, a)); }
inline double squaredDistance(Vec3d a, Vec3d b) { return dot(a - b, a - b); }

// The unit vector along `a`; the zero vector where `a` has no direction.
inline Vec3d normalized(Vec3d a)
{
    const double l = length(a);
    return l > 0 ? a / l : Vec3d{};
}

// Some unit vector at right angles to the unit vector `a`.
inline Vec3d anyPerpendicular(Vec3d a)
{
    const Vec3d other = std::abs(a.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    return normalized(cross(a, other));
}

constexpr Vec4d operator+(Vec4d a, Vec4d b) { return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w}; }
constexpr Vec4d operator-(Vec4d a, Vec4d b) { return {a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w}; }
constexpr Vec4d operator*(double s, Vec4d a) { return {s * a.x, s * a.y, s * a.z, s * a.w}; }
constexpr double dot(Vec4d a, Vec4d b) { return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w; }
constexpr Vec3d xyz(Vec4d a) { return {a.x, a.y, a.z}; }

constexpr Vec2f toFloat(Vec2d a) { return {float(a.x), float(a.y)}; }
constexpr Vec3f toFloat(Vec3d a) { return {float(a.x), float(a.y), float(a.z)}; }
constexpr Vec2d toDouble(Vec2f a) { return {a.x, a.y}; }
constexpr Vec3d toDouble(Vec3f a) { return {a.x, a.y, a.z}; }

inline bool isFinite(Vec3d a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

} // namespace lixel
