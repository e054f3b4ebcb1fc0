// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/lixel_energy.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lixel {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// Reading structures of arrays: compilers turn loops over these into vector code.
struct Columns
{
    const double *x, *y, *z;

    explicit Columns(const EdgeRays::Vectors& v) : x(v[0].data()), y(v[1].data()), z(v[2].data()) {}
    double along(Vec3d a, std::size_t i) const { return a.x * x[i] + a.y * y[i] + a.z * z[i]; }
    Vec3d at(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

bool areBefore(const EdgeRays::Vectors& rays, Vec3d w)
{
    const Columns r(rays);
    const std::size_t count = rays[0].size();
    // Counted in doubles: Clang has no vector code for the minimum where values may be NaN, nor GCC for mixed widths.
    double behind = 0;
#pragma omp simd reduction(+ : behind)
    for (std::size_t i = 0; i < count; ++i) behind += r.along(w, i) > 0 ? 0.0 : 1.0;
    return behind == 0;
}

// The inverse Jacobian of a sample: pixels a lixel, rows are pixel x and y.
struct Inverse
{
    double m11, m12, m21, m22;

    double squares() const { return m11 * m11 + m12 * m12 + m21 * m21 + m22 * m22; }
    double determinant() const { return m11 * m22 - m12 * m21; }

    // The sum and the difference of the singular values, one or the other: a similarity's length, and a mirrored one's.
    double alike() const { return std::sqrt((m11 + m22) * (m11 + m22) + (m21 - m12) * (m21 - m12)); }
    double mirrored() const { return std::sqrt((m11 - m22) * (m11 - m22) + (m21 + m12) * (m21 + m12)); }
    double longestAxis() const { return 0.5 * (alike() + mirrored()); }
};

// Calls `value` for the inverse of every sample, and adds up what it gives, weighted.
template <typename Value>
double meanOfInverses(const EdgeRays& rays, const PlaneWarp& map, const Value& value)
{
    const DualBasis dual = dualBasis(map);
    const Columns r(rays.ray), k1(rays.first), k2(rays.second);
    const double* weight = rays.weight.data();
    const std::size_t count = rays.size();
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (std::size_t i = 0; i < count; ++i) {
        const double w = r.along(map.w, i);
        const Inverse inverse{w * k1.along(dual.b1, i), w * k1.along(dual.b2, i), w * k2.along(dual.b1, i),
                              w * k2.along(dual.b2, i)};
        sum += weight[i] * value(inverse);
    }
    return sum;
}

double meanWidth(const EdgeRays& rays, const PlaneWarp& map)
{
    const DualBasis dual = dualBasis(map);
    const Columns r(rays.edgeRay), k(rays.across);
    const double* weight = rays.edgeWeight.data();
    const std::size_t count = rays.edgeWeight.size();
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (std::size_t i = 0; i < count; ++i)
        sum += weight[i] * r.along(map.w, i) * (std::abs(k.along(dual.b1, i)) + std::abs(k.along(dual.b2, i)));
    return sum;
}

// The change of (w.r)(k.b) with w, where b moves with w too: (k.b) r - (w.r)(k.a) b.
Vec3d changeOf(Vec3d r, double w, Vec3d k, Vec3d b, Vec3d a) { return dot(k, b) * r - (w * dot(k, a)) * b; }

// What a metric makes of one inverse, and how that changes with each of its four entries.
struct Slope
{
    double value = 0;
    Inverse by{};
};

Slope slopeOf(LixelMetric metric, const Inverse& m)
{
    if (metric == LixelMetric::L2) return {m.squares(), {2 * m.m11, 2 * m.m12, 2 * m.m21, 2 * m.m22}};
    const double determinant = m.determinant(), sign = determinant < 0 ? -1 : 1;
    if (metric == LixelMetric::Area)
        return {std::abs(determinant), {sign * m.m22, -sign * m.m21, -sign * m.m12, sign * m.m11}};
    // Where one of the two vanishes, lixels are round in the picture and the longest axis has no derivative of it; the other's stays.
    const double alike = m.alike(), mirrored = m.mirrored();
    const double a = alike > 0 ? 0.5 / alike : 0, b = mirrored > 0 ? 0.5 / mirrored : 0;
    return {0.5 * (alike + mirrored),
            {a * (m.m11 + m.m22) + b * (m.m11 - m.m22), a * (m.m12 - m.m21) + b * (m.m12 + m.m21),
             a * (m.m21 - m.m12) + b * (m.m21 + m.m12), a * (m.m22 + m.m11) + b * (m.m22 - m.m11)}};
}

EnergyChange widthChange(const EdgeRays& rays, const PlaneWarp& map)
{
    const DualBasis dual = dualBasis(map);
    const Columns r(rays.edgeRay), k(rays.across);
    EnergyChange out;
    for (std::size_t i = 0; i < rays.edgeWeight.size(); ++i) {
        const Vec3d ray = r.at(i), across = k.at(i);
        const double w = dot(map.w, ray);
        for (const Vec3d& b : {dual.b1, dual.b2}) {
            const double width = w * dot(across, b);
            out.energy += rays.edgeWeight[i] * std::abs(width);
            out.withW = out.withW +
                        (width < 0 ? -rays.edgeWeight[i] : rays.edgeWeight[i]) * changeOf(ray, w, across, b, dual.a);
        }
    }
    return out;
}

// Products of a vector's components, each pair once, xx, xy, xz, yy, yz, zz; those of different ones count twice in squares.
constexpr std::array<int, 6> kFirstOf{0, 0, 0, 1, 1, 2}, kSecondOf{0, 1, 2, 1, 2, 2};
constexpr std::array<double, 6> kTimes{1, 2, 2, 1, 2, 1};

} // namespace

std::string_view nameOf(LixelMetric metric)
{
    switch (metric) {
    case LixelMetric::L2: return "l2";
    case LixelMetric::Lloyd: return "lloyd";
    case LixelMetric::Area: return "area";
    case LixelMetric::Width: return "width";
    }
    return "";
}

DualBasis dualBasis(const PlaneWarp& map)
{
    const Vec3d yw = cross(map.y, map.w), wx = cross(map.w, map.x), xy = cross(map.x, map.y);
    const double perDeterminant = 1 / dot(map.x, yw);
    return {perDeterminant * yw, perDeterminant * wx, perDeterminant * xy};
}

double lixelEnergy(LixelMetric metric, const EdgeRays& rays, const PlaneWarp& map)
{
    if (!areBefore(rays.ray, map.w)) return kInfinite;
    switch (metric) {
    case LixelMetric::L2: return meanOfInverses(rays, map, [](const Inverse& m) { return m.squares(); });
    case LixelMetric::Area:
        return meanOfInverses(rays, map, [](const Inverse& m) { return std::abs(m.determinant()); });
    case LixelMetric::Lloyd: return meanOfInverses(rays, map, [](const Inverse& m) { return m.longestAxis(); });
    case LixelMetric::Width: return meanWidth(rays, map);
    }
    return kInfinite;
}

EnergyChange lixelEnergyChange(LixelMetric metric, const EdgeRays& rays, const PlaneWarp& map)
{
    if (!areBefore(rays.ray, map.w)) return {kInfinite, {}};
    if (metric == LixelMetric::Width) return widthChange(rays, map);
    const DualBasis dual = dualBasis(map);
    const Columns r(rays.ray), first(rays.first), second(rays.second);
    EnergyChange out;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Vec3d ray = r.at(i), k1 = first.at(i), k2 = second.at(i);
        const double w = dot(map.w, ray);
        const Slope slope =
            slopeOf(metric, {w * dot(k1, dual.b1), w * dot(k1, dual.b2), w * dot(k2, dual.b1), w * dot(k2, dual.b2)});
        out.energy += rays.weight[i] * slope.value;
        out.withW = out.withW + rays.weight[i] * (slope.by.m11 * changeOf(ray, w, k1, dual.b1, dual.a) +
                                                  slope.by.m12 * changeOf(ray, w, k1, dual.b2, dual.a) +
                                                  slope.by.m21 * changeOf(ray, w, k2, dual.b1, dual.a) +
                                                  slope.by.m22 * changeOf(ray, w, k2, dual.b2, dual.a));
    }
    return out;
}

void badnesses(const EdgeRays& rays, const PlaneWarp& map, std::vector<double>& out)
{
    const DualBasis dual = dualBasis(map);
    const Columns r(rays.ray), k1(rays.first), k2(rays.second);
    out.resize(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const double w = r.along(map.w, i);
        out[i] = w > 0 ? Inverse{w * k1.along(dual.b1, i), w * k1.along(dual.b2, i), w * k2.along(dual.b1, i),
                                 w * k2.along(dual.b2, i)}
                             .squares()
                       : kInfinite;
    }
}

void SquaresForm::add(const EdgeRays::Vectors& ray, const EdgeRays::Vectors& k, std::span<const double> weight)
{
    // Some samples at a time, so that what is made of them stays near.
    constexpr std::size_t kAtATime = 128;
    std::array<std::array<double, kAtATime>, 6> rr, kk;
    for (std::size_t begin = 0; begin < weight.size(); begin += kAtATime) {
        const std::size_t count = std::min(kAtATime, weight.size() - begin);
        for (std::size_t m = 0; m < 6; ++m) {
            const double *ra = ray[std::size_t(kFirstOf[m])].data() + begin,
                         *rb = ray[std::size_t(kSecondOf[m])].data() + begin, *v = weight.data() + begin;
            const double *ka = k[std::size_t(kFirstOf[m])].data() + begin,
                         *kb = k[std::size_t(kSecondOf[m])].data() + begin;
#pragma omp simd
            for (std::size_t i = 0; i < count; ++i) {
                rr[m][i] = v[i] * ra[i] * rb[i];
                kk[m][i] = ka[i] * kb[i];
            }
        }
        for (std::size_t m = 0; m < 6; ++m)
            for (std::size_t n = 0; n < 6; ++n) {
                double sum = 0;
#pragma omp simd reduction(+ : sum)
                for (std::size_t i = 0; i < count; ++i) sum += rr[m][i] * kk[n][i];
                sums_[m][n] += sum;
            }
    }
}

SquaresForm SquaresForm::ofL2(const EdgeRays& rays)
{
    SquaresForm form;
    form.add(rays.ray, rays.first, rays.weight);
    form.add(rays.ray, rays.second, rays.weight);
    return form;
}

SquaresForm SquaresForm::near(LixelMetric metric, const EdgeRays& rays, const PlaneWarp& map, std::vector<double>& room)
{
    if (metric != LixelMetric::Lloyd && metric != LixelMetric::Width) return ofL2(rays);
    const DualBasis dual = dualBasis(map);
    SquaresForm form;
    if (metric == LixelMetric::Lloyd) {
        badnesses(rays, map, room);
        for (std::size_t i = 0; i < room.size(); ++i) room[i] = room[i] > 0 ? rays.weight[i] / std::sqrt(room[i]) : 0;
        form.add(rays.ray, rays.first, room);
        form.add(rays.ray, rays.second, room);
        return form;
    }
    const Columns r(rays.edgeRay), k(rays.across);
    room.resize(rays.edgeWeight.size());
    for (std::size_t i = 0; i < room.size(); ++i) {
        const double width = r.along(map.w, i) * (std::abs(k.along(dual.b1, i)) + std::abs(k.along(dual.b2, i)));
        room[i] = width > 0 ? rays.edgeWeight[i] / width : 0;
    }
    form.add(rays.edgeRay, rays.across, room);
    return form;
}

std::array<double, 6> SquaresForm::at(Vec3d w) const
{
    const std::array<double, 3> v{w.x, w.y, w.z};
    std::array<double, 6> out{};
    for (std::size_t m = 0; m < 6; ++m) {
        const double product = kTimes[m] * v[std::size_t(kFirstOf[m])] * v[std::size_t(kSecondOf[m])];
        for (std::size_t n = 0; n < 6; ++n) out[n] += product * sums_[m][n];
    }
    return out;
}

CubesForm::CubesForm(const EdgeRays& rays)
{
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Vec3d r{rays.ray[0][i], rays.ray[1][i], rays.ray[2][i]};
        const Vec3d k1{rays.first[0][i], rays.first[1][i], rays.first[2][i]};
        const Vec3d k2{rays.second[0][i], rays.second[1][i], rays.second[2][i]};
        const double weight = rays.weight[i] * length(cross(k1, k2)) / length(r); // k1 x k2 is r / D
        const std::array<double, 10> products{r.x * r.x * r.x, r.x * r.x * r.y, r.x * r.x * r.z, r.x * r.y * r.y,
                                              r.x * r.y * r.z, r.x * r.z * r.z, r.y * r.y * r.y, r.y * r.y * r.z,
                                              r.y * r.z * r.z, r.z * r.z * r.z};
        for (std::size_t m = 0; m < 10; ++m) sums_[m] += weight * products[m];
    }
}

double CubesForm::at(Vec3d w) const
{
    return sums_[0] * w.x * w.x * w.x + sums_[6] * w.y * w.y * w.y + sums_[9] * w.z * w.z * w.z +
           3 * (w.x * w.x * (sums_[1] * w.y + sums_[2] * w.z) + w.y * w.y * (sums_[3] * w.x + sums_[7] * w.z) +
                w.z * w.z * (sums_[5] * w.x + sums_[8] * w.y)) +
           6 * sums_[4] * w.x * w.y * w.z;
}

} // namespace lixel
