// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/vec.h"

#include <cmath>

// Automatic differentiation, forwards: a number and its derivatives with three variables.
namespace lixel::test {

struct Dual
{
    double value = 0;
    Vec3d by{};

    Dual() = default;
    Dual(double v) : value(v) {}
    Dual(double v, Vec3d d) : value(v), by(d) {}
};

inline Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, a.by + b.by}; }
inline Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, a.by - b.by}; }
inline Dual operator*(const Dual& a, const Dual& b) { return {a.value * b.value, b.value * a.by + a.value * b.by}; }
inline Dual operator/(const Dual& a, const Dual& b)
{
    const double q = a.value / b.value;
    return {q, (a.by - q * b.by) / b.value};
}
inline Dual sqrt(const Dual& a)
{
    const double root = std::sqrt(a.value);
    return {root, a.by / (2 * root)};
}
inline Dual abs(const Dual& a) { return a.value < 0 ? Dual{-a.value, -a.by} : a; }

// A vector's components, the variables.
struct DualVec3
{
    Dual x, y, z;
};
inline DualVec3 variables(Vec3d v) { return {{v.x, {1, 0, 0}}, {v.y, {0, 1, 0}}, {v.z, {0, 0, 1}}}; }
inline Dual dot(const DualVec3& a, Vec3d b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

} // namespace lixel::test
