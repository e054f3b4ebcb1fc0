// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/lixel_energy.h"

#include "plan/appendix_twin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

namespace lixel {
namespace {

using namespace test;

// The energies from their definitions, with the paper's derivatives for lights at a point.
TEST(LixelEnergy, IsTheMeanOfWhatTheMetricSaysOfEachSample)
{
    forEachCase(kCases, [&](Rng& rng) {
        const EdgeScene s = anyEdgeScene(rng);
        const PlaneWarp map = anyMap(rng, s.rays);
        double weights = 0;
        std::array<double, 4> sums{};
        for (std::size_t i = 0; i < s.samples.size(); ++i) {
            const NeedSample& sample = s.samples[i];
            const Inverse m =
                s.frame.isPerspective ? Appendix(s, sample, map).inverseJacobian() : inverseBy(s.rays, i, map);
            const double determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
            double squares = 0;
            for (const auto& row : m) squares += row[0] * row[0] + row[1] * row[1];
            weights += sample.weight;
            sums[0] += sample.weight * squares;
            // Of the singular values, the roots of s^4 - |m|^2 s^2 + det^2, the larger one.
            sums[1] += sample.weight *
                       std::sqrt(0.5 * (squares +
                                        std::sqrt(std::max(0.0, squares * squares - 4 * determinant * determinant))));
            sums[2] += sample.weight * std::abs(determinant);
            // Across the edge a step of u j is as wide as it is along the edge's normal.
            const auto width = [&](Vec2d n) {
                return std::abs(n.x * m[0][0] + n.y * m[1][0]) + std::abs(n.x * m[0][1] + n.y * m[1][1]);
            };
            if (dot(sample.across, sample.across) > 0) {
                sums[3] += sample.weight * width(sample.across);
                continue;
            }
            // Edges on the surface at 0, 45, 90 and 135 degrees to a tangent, each as wide as the surface is foreshortened.
            const Mat4d pixels = pixelsFrom(s);
            const Vec3d t1 = anyPerpendicular(sample.normal), t2 = cross(sample.normal, t1);
            const Vec4d clip = pixels * point(sample.pointLocal);
            const auto onPicture = [&](Vec3d t) {
                const Vec4d d = pixels * direction(t);
                return Vec2d{(d.x - d.w * clip.x / clip.w) / clip.w, (d.y - d.w * clip.y / clip.w) / clip.w};
            };
            const Vec2d p1 = onPicture(t1), p2 = onPicture(t2);
            const double size = std::sqrt(0.5 * (dot(p1, p1) + dot(p2, p2)));
            for (int k = 0; k < 4; ++k) {
                const double angle = k * 0.7853981633974483;
                const Vec2d alongEdge = -std::sin(angle) * p1 + std::cos(angle) * p2; // on the picture
                sums[3] += 0.25 * sample.weight * width((1 / size) * Vec2d{alongEdge.y, -alongEdge.x});
            }
        }
        for (std::size_t metric = 0; metric < 4; ++metric) {
            const double expected = sums[metric] / weights;
            EXPECT_NEAR(lixelEnergy(kAllMetrics[metric], s.rays, map), expected, 1e-7 * expected)
                << nameOf(kAllMetrics[metric]);
        }
    });
}

TEST(LixelEnergy, IsInfiniteWhereASampleIsNotBeforeTheMap)
{
    forEachCase(kCases, [&](Rng& rng) {
        const EdgeScene s = anyEdgeScene(rng);
        PlaneWarp map = anyMap(rng, s.rays);
        const std::size_t i = std::size_t(rng.integer(0, int(s.rays.size()) - 1));
        const Vec3d r{s.rays.ray[0][i], s.rays.ray[1][i], s.rays.ray[2][i]};
        map.w = map.w - (rng.uniform(1, 2) * dot(map.w, r) / dot(r, r)) * r;
        for (const LixelMetric metric : kAllMetrics) {
            EXPECT_EQ(lixelEnergy(metric, s.rays, map), INFINITY);
            EXPECT_EQ(lixelEnergyChange(metric, s.rays, map).energy, INFINITY);
        }
    });
}

// ---- closed forms

double squaresOf(const SquaresForm& form, const PlaneWarp& map)
{
    const DualBasis dual = dualBasis(map);
    const auto q = form.at(map.w);
    const auto of = [&q](Vec3d b) {
        return q[0] * b.x * b.x + q[3] * b.y * b.y + q[5] * b.z * b.z +
               2 * (q[1] * b.x * b.y + q[2] * b.x * b.z + q[4] * b.y * b.z);
    };
    return of(dual.b1) + of(dual.b2);
}

TEST(LixelEnergy, OfTheSquaresIsOneFormOfAllMaps)
{
    forEachCase(kCases, [&](Rng& rng) {
        const EdgeScene s = anyEdgeScene(rng, 400);
        const SquaresForm form = SquaresForm::ofL2(s.rays);
        for (int i = 0; i < 3; ++i) {
            const PlaneWarp map = anyMap(rng, s.rays);
            const double expected = lixelEnergy(LixelMetric::L2, s.rays, map);
            EXPECT_NEAR(squaresOf(form, map), expected, 1e-12 * expected);
        }
    });
}

TEST(LixelEnergy, OfAreasIsOneFormOfAllMaps)
{
    forEachCase(kCases, [&](Rng& rng) {
        const EdgeScene s = anyEdgeScene(rng, 400);
        const CubesForm form(s.rays);
        for (int i = 0; i < 3; ++i) {
            const PlaneWarp map = anyMap(rng, s.rays);
            const double expected = lixelEnergy(LixelMetric::Area, s.rays, map);
            // Areas of long and thin lixels, as differences of products, are rounded by as much as these.
            const double rounded = expected + lixelEnergy(LixelMetric::L2, s.rays, map);
            EXPECT_NEAR(form.at(map.w) / std::abs(dot(map.x, cross(map.y, map.w))), expected, 1e-12 * rounded);
        }
    });
}

// At its own map the form divides squares by their roots: for Lloyd's m, the root of all four derivatives' squares, which is m where
// lixels are lines and sqrt(2) m where they are round; for the width |a| + |b| of two sides, (a^2 + b^2) / (|a| + |b|), which is the
// width where one is along the edge and half of it where both are alike.
TEST(SquaresForm, NearIsWithinItsBoundsOfTheMetric)
{
    forEachCase(kCases, [&](Rng& rng) {
        const EdgeScene s = anyEdgeScene(rng);
        const PlaneWarp map = anyMap(rng, s.rays);
        std::vector<double> room;
        const auto near = [&](LixelMetric metric) {
            return squaresOf(SquaresForm::near(metric, s.rays, map, room), map);
        };
        const double m = lixelEnergy(LixelMetric::Lloyd, s.rays, map),
                     width = lixelEnergy(LixelMetric::Width, s.rays, map);
        EXPECT_GE(near(LixelMetric::Lloyd), m * (1 - 1e-12));
        EXPECT_LE(near(LixelMetric::Lloyd), std::sqrt(2) * m * (1 + 1e-12));
        EXPECT_LE(near(LixelMetric::Width), width * (1 + 1e-12));
        EXPECT_GE(near(LixelMetric::Width), 0.5 * width * (1 - 1e-12));
        std::vector<double> bad;
        badnesses(s.rays, map, bad);
        double roots = 0;
        for (std::size_t i = 0; i < bad.size(); ++i) roots += s.rays.weight[i] * std::sqrt(bad[i]);
        EXPECT_NEAR(near(LixelMetric::Lloyd), roots, 1e-10 * roots);
    });
}

// ---- laws

// A map of n lixels each way: lengths go with 1 / n, squares and areas with 1 / n^2, and the rows' common scale says nothing.
TEST(LixelEnergy, FallsWithTheLixelsOfTheMap)
{
    forEachCase(kCases, [&](Rng& rng) {
        const EdgeScene s = anyEdgeScene(rng);
        const PlaneWarp map = anyMap(rng, s.rays);
        const double n = rng.logUniform(1e-3, 1e3), c = rng.logUniform(1e-3, 1e3);
        const PlaneWarp finer{n * map.x, n * map.y, map.w}, scaled{c * map.x, c * map.y, c * map.w};
        for (const LixelMetric metric : kAllMetrics) {
            const double energy = lixelEnergy(metric, s.rays, map);
            const int power = metric == LixelMetric::L2 || metric == LixelMetric::Area ? 2 : 1;
            EXPECT_NEAR(lixelEnergy(metric, s.rays, finer) * std::pow(n, power), energy, 1e-11 * energy);
            EXPECT_NEAR(lixelEnergy(metric, s.rays, scaled), energy, 1e-11 * energy);
            // So h does not change along w, the rows moving with it (Euler).
            const EnergyChange change = lixelEnergyChange(metric, s.rays, map);
            EXPECT_NEAR(dot(change.withW, map.w), power * energy,
                        1e-9 * (energy + length(change.withW) * length(map.w)));
        }
    });
}

TEST(LixelEnergy, KnowsNoOrderOfSamplesAndNoScaleOfWeights)
{
    forEachCase(kCases, [&](Rng& rng) {
        EdgeScene s = anyEdgeScene(rng);
        const PlaneWarp map = anyMap(rng, s.rays);
        std::array<double, 4> before{};
        for (std::size_t i = 0; i < 4; ++i) before[i] = lixelEnergy(kAllMetrics[i], s.rays, map);
        for (std::size_t i = s.samples.size(); i > 1; --i)
            std::swap(s.samples[i - 1], s.samples[std::size_t(rng.integer(0, int(i) - 1))]);
        for (NeedSample& sample : s.samples) sample.weight *= 1e5;
        s.rays.assign(s.view, s.originWorld, s.frame.framedFromLocal, s.samples);
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_NEAR(lixelEnergy(kAllMetrics[i], s.rays, map), before[i], 1e-12 * before[i]);
    });
}

// The light plane may be turned, mirrored or seen along another axis: rays and rows change, lixels do not.
TEST(LixelEnergy, IsTheSameInEveryFrameOfTheLight)
{
    forEachCase(kCases, [&](Rng& rng) {
        EdgeScene s = anyEdgeScene(rng);
        const PlaneWarp map = anyMap(rng, s.rays);
        // Another frame's rays are A r; rows on them are those on r, times A's inverse. All rays stay before it.
        const PlaneWarp a = anyMap(rng, s.rays);
        const DualBasis columns = dualBasis(a);
        const auto there = [&](Vec3d row) {
            return Vec3d{dot(row, columns.b1), dot(row, columns.b2), dot(row, columns.a)};
        };
        const PlaneWarp mapThere{there(map.x), there(map.y), there(map.w)};
        Mat4d framed = s.frame.framedFromLocal;
        const auto row = [&](Vec3d r) {
            return r.x * s.frame.framedFromLocal.row(0) + r.y * s.frame.framedFromLocal.row(1) +
                   r.z * s.frame.framedFromLocal.row(3);
        };
        framed.setRow(0, row(a.x)), framed.setRow(1, row(a.y)), framed.setRow(3, row(a.w));
        EdgeRays rays;
        rays.assign(s.view, s.originWorld, framed, s.samples);
        ASSERT_EQ(rays.size(), s.rays.size());
        for (const LixelMetric metric : kAllMetrics) {
            const double energy = lixelEnergy(metric, s.rays, map);
            EXPECT_NEAR(lixelEnergy(metric, rays, mapThere), energy, 1e-9 * energy) << nameOf(metric);
        }
    });
}

TEST(LixelEnergy, IsTheSameFarFromTheWorldsOrigin)
{
    forEachCase(kCases, [&](Rng& rng) {
        const std::uint64_t seed = rng.bits();
        Rng here(seed), there(seed);
        const EdgeScene near = anyEdgeScene(here), far = anyEdgeScene(there, 40, {1e5, -2e5, 1e5});
        const PlaneWarp map = anyMap(here, near.rays);
        if (near.samples.size() != far.samples.size()) return; // a normal was next to edge-on
        for (const LixelMetric metric : kAllMetrics) {
            const double energy = lixelEnergy(metric, near.rays, map);
            EXPECT_NEAR(lixelEnergy(metric, far.rays, map), energy, 1e-6 * energy) << nameOf(metric);
        }
    });
}

} // namespace
} // namespace lixel
