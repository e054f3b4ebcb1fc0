// SPDX-License-Identifier: MIT
#include "peers/axis_problem.h"

#include "support/dual.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lixel::bench {
namespace {

using test::Dual;
using test::DualVec3;

DualVec3 operator*(const Dual& s, const DualVec3& v) { return {s * v.x, s * v.y, s * v.z}; }
DualVec3 operator-(const DualVec3& a, const DualVec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Dual dot(const DualVec3& a, const DualVec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
DualVec3 cross(const DualVec3& a, const DualVec3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
DualVec3 unit(const DualVec3& v) { return (1.0 / sqrt(dot(v, v))) * v; }

// The basis vectors b1 and b2 of the rectangle along a side of the hull, and how they change with w.
std::array<DualVec3, 2> stepsOf(std::span<const Vec3d> corners, std::size_t side, Vec3d axis)
{
    const DualVec3 w = test::variables(axis);
    const auto imageOf = [&](Vec3d r) {
        const Dual perW = 1.0 / test::dot(w, r);
        return DualVec3{r.x * perW, r.y * perW, r.z * perW};
    };
    DualVec3 along = unit({w.y, 0.0 - w.x, 0});
    if (side < corners.size()) along = unit(imageOf(corners[(side + 1) % corners.size()]) - imageOf(corners[side]));
    const DualVec3 across = unit(cross(w, along));
    const auto extent = [&](const DualVec3& way) {
        Dual low(INFINITY), high(-INFINITY);
        for (const Vec3d& r : corners) {
            const Dual at = dot(way, imageOf(r));
            if (at.value < low.value) low = at;
            if (at.value > high.value) high = at;
        }
        return high - low;
    };
    return {extent(along) * along, extent(across) * across};
}

Vec3d at(const EdgeRays::Vectors& v, std::size_t i) { return {v[0][i], v[1][i], v[2][i]}; }

// One pass for the squares of all rectangles of an axis: xx, xy, xz, yy, yz, zz.
std::array<double, 6> squaresAt(const EdgeRays& rays, Vec3d w)
{
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
    const double *rx = rays.ray[0].data(), *ry = rays.ray[1].data(), *rz = rays.ray[2].data();
    const double *px = rays.first[0].data(), *py = rays.first[1].data(), *pz = rays.first[2].data();
    const double *qx = rays.second[0].data(), *qy = rays.second[1].data(), *qz = rays.second[2].data();
    const double* weight = rays.weight.data();
    const std::size_t count = rays.size();
#pragma omp simd reduction(+ : xx, xy, xz, yy, yz, zz)
    for (std::size_t i = 0; i < count; ++i) {
        const double wr = w.x * rx[i] + w.y * ry[i] + w.z * rz[i], c = weight[i] * wr * wr;
        xx += c * (px[i] * px[i] + qx[i] * qx[i]), xy += c * (px[i] * py[i] + qx[i] * qy[i]);
        xz += c * (px[i] * pz[i] + qx[i] * qz[i]), yy += c * (py[i] * py[i] + qy[i] * qy[i]);
        yz += c * (py[i] * pz[i] + qy[i] * qz[i]), zz += c * (pz[i] * pz[i] + qz[i] * qz[i]);
    }
    return {xx, xy, xz, yy, yz, zz};
}

Vec3d times(const std::array<double, 6>& q, Vec3d b)
{
    return {q[0] * b.x + q[1] * b.y + q[2] * b.z, q[1] * b.x + q[3] * b.y + q[4] * b.z,
            q[2] * b.x + q[4] * b.y + q[5] * b.z};
}

} // namespace

void AxisProblem::start() { start_ = std::chrono::steady_clock::now(); }

std::size_t AxisProblem::bestSide(const HullMaps& hull, double& energy) const
{
    std::size_t best = 0;
    energy = INFINITY;
    const bool isL2 = question_.metric == LixelMetric::L2;
    const auto q = isL2 ? squaresAt(question_.rays, hull.axis()) : std::array<double, 6>{};
    for (std::size_t i = 0; i < hull.sideCount(); ++i) {
        const HullMaps::Sides sides = hull.sides(i);
        const HullMaps::Steps steps = hull.steps(sides, false);
        const double of =
            isL2 ? lixel::dot(steps.alongX, times(q, steps.alongX)) + lixel::dot(steps.alongY, times(q, steps.alongY))
                 : lixelEnergy(question_.metric, question_.rays, hull.rows(sides, false));
        if (of < energy) energy = of, best = i;
    }
    return best;
}

AxisProblem::Slopes AxisProblem::slopesOf(Vec3d w, const HullMaps::Steps& steps) const
{
    const EdgeRays& rays = question_.rays;
    Slopes out;
    if (question_.metric == LixelMetric::L2) {
        const auto q = squaresAt(rays, w);
        out.withB1 = 2 * times(q, steps.alongX), out.withB2 = 2 * times(q, steps.alongY);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const Vec3d r = at(rays.ray, i), k1 = at(rays.first, i), k2 = at(rays.second, i);
            double squares = 0;
            for (const Vec3d& b : {steps.alongX, steps.alongY})
                squares += lixel::dot(k1, b) * lixel::dot(k1, b) + lixel::dot(k2, b) * lixel::dot(k2, b);
            out.withW = out.withW + (2 * rays.weight[i] * lixel::dot(w, r) * squares) * r;
        }
        return out;
    }
    for (std::size_t i = 0; i < rays.edgeWeight.size(); ++i) {
        const Vec3d r = at(rays.edgeRay, i), k = at(rays.across, i);
        const double weight = rays.edgeWeight[i], wr = lixel::dot(w, r);
        const double x = lixel::dot(k, steps.alongX), y = lixel::dot(k, steps.alongY);
        out.withW = out.withW + (weight * (std::abs(x) + std::abs(y))) * r;
        out.withB1 = out.withB1 + std::copysign(weight * wr, x) * k;
        out.withB2 = out.withB2 + std::copysign(weight * wr, y) * k;
    }
    return out;
}

double AxisProblem::energy(Vec2d axis, Vec2d* slope)
{
    ++evaluations_;
    if (slope) *slope = {};
    HullMaps hull(question_.corners, 1, room_);
    const Vec3d w{axis.x, axis.y, 1};
    if (!std::isfinite(axis.x + axis.y) || !hull.lookAlong(w)) return kInfeasible;
    double energy = 0;
    const std::size_t side = bestSide(hull, energy);
    if (slope) {
        const Slopes slopes = slopesOf(hull.axis(), hull.steps(hull.sides(side), false));
        const auto steps = stepsOf(question_.corners, side, hull.axis());
        const auto through = [](Vec3d by, const DualVec3& b) { return by.x * b.x.by + by.y * b.y.by + by.z * b.z.by; };
        // The energy does not know w's length.
        const Vec3d total =
            (slopes.withW + through(slopes.withB1, steps[0]) + through(slopes.withB2, steps[1])) / length(w);
        *slope = {total.x, total.y};
    }
    note(energy);
    return energy;
}

void AxisProblem::note(double energy)
{
    least_ = std::min(least_, energy);
    if (secondsToTarget_ < 0 && energy <= target_) secondsToTarget_ = secondsSince(start_);
}

std::optional<AxisProblem::Basis> AxisProblem::basisAt(Vec2d axis)
{
    ++evaluations_;
    HullMaps hull(question_.corners, 1, room_);
    const Vec3d w{axis.x, axis.y, 1};
    if (!std::isfinite(axis.x + axis.y) || !hull.lookAlong(w)) return std::nullopt;
    double energy = 0;
    const std::size_t side = bestSide(hull, energy);
    const HullMaps::Steps at = hull.steps(hull.sides(side), false);
    const auto steps = stepsOf(question_.corners, side, hull.axis());
    Basis out{hull.axis(), at.alongX, at.alongY, {}, {}, {}};
    const double perLength = 1 / length(w);
    const auto component = [](const Vec3d& by, std::size_t i) { return i == 0 ? by.x : by.y; };
    for (std::size_t i = 0; i < 2; ++i) {
        const auto change = [&](const DualVec3& b) {
            return perLength * Vec3d{component(b.x.by, i), component(b.y.by, i), component(b.z.by, i)};
        };
        out.wBy[i] = perLength * (i == 0 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0});
        out.b1By[i] = change(steps[0]), out.b2By[i] = change(steps[1]);
    }
    return out;
}

} // namespace lixel::bench
