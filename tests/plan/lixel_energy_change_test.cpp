// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/lixel_energy.h"

#include "plan/appendix_twin.h"
#include "support/dual.h"

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

// The appendix' gradient formula, sample by sample.
TEST(LixelEnergyChange, IsTheAppendixGradientForLightsAtAPoint)
{
    forEachCase(kCases, [&](Rng& rng) {
        const EdgeScene s = anyEdgeScene(rng);
        if (!s.frame.isPerspective) return;
        const PlaneWarp map = anyMap(rng, s.rays);
        double weights = 0;
        Vec3d expected;
        for (const NeedSample& sample : s.samples) {
            weights += sample.weight;
            expected = expected + sample.weight * Appendix(s, sample, map).gradientOfBadness();
        }
        expected = expected / weights;
        const EnergyChange change = lixelEnergyChange(LixelMetric::L2, s.rays, map);
        EXPECT_LT(length(change.withW - expected), 1e-7 * length(expected));
    });
}

// Energies once more, from rays and how they move a pixel, in numbers of any kind: Jacobians forwards, then inverted.
class EnergyTwin
{
public:
    explicit EnergyTwin(const EdgeScene& s)
    {
        const Mat4d back = inverse(pixelsFrom(s)).value();
        for (const NeedSample& sample : s.samples) {
            const Vec3d at = project(pixelsFrom(s), sample.pointLocal);
            const std::array<double, 4> plane{sample.normal.x, sample.normal.y, sample.normal.z,
                                              -dot(sample.normal, sample.pointLocal)};
            std::array<double, 4> onScreen{};
            for (std::size_t j = 0; j < 4; ++j)
                for (std::size_t k = 0; k < 4; ++k) onScreen[j] += plane[k] * back.m[k][j];
            Ray ray{sample, rayOf(s, point(sample.pointLocal)), {}};
            const double perW = 1 / (back * Vec4d{at.x, at.y, at.z, 1}).w;
            for (std::size_t j = 0; j < 2; ++j) {
                const Vec4d d = back * Vec4d{j == 0 ? 1.0 : 0, j == 1 ? 1.0 : 0, -onScreen[j] / onScreen[2], 0};
                const Vec3d moved = perW * (xyz(d) - d.w * sample.pointLocal);
                ray.aPixel[j] = rayOf(s, direction(moved));
            }
            rays_.push_back(ray);
        }
    }

    template <typename Number, typename Vector>
    Number energy(LixelMetric metric, const PlaneWarp& map, const Vector& w) const
    {
        using std::abs, std::sqrt;
        Number sum = 0;
        double weights = 0;
        for (const Ray& ray : rays_) {
            weights += ray.sample.weight;
            Number m[2][2];
            const Number wr = dot(w, ray.r);
            for (std::size_t i = 0; i < 2; ++i)
                for (std::size_t j = 0; j < 2; ++j) {
                    const Vec3d row = i == 0 ? map.x : map.y;
                    m[i][j] = (wr * dot(row, ray.aPixel[j]) - dot(row, ray.r) * dot(w, ray.aPixel[j])) / (wr * wr);
                }
            const Number det = m[0][0] * m[1][1] - m[0][1] * m[1][0];
            const Number i11 = m[1][1] / det, i12 = 0.0 - m[0][1] / det, i21 = 0.0 - m[1][0] / det, i22 = m[0][0] / det;
            const Number squares = i11 * i11 + i12 * i12 + i21 * i21 + i22 * i22, area = i11 * i22 - i12 * i21;
            Number value = squares;
            if (metric == LixelMetric::Area) value = abs(area);
            if (metric == LixelMetric::Lloyd)
                value = sqrt(0.5 * (squares + sqrt(squares * squares - 4.0 * area * area)));
            if (metric == LixelMetric::Width) {
                const Vec2d n = ray.sample.across;
                value = abs(n.x * i11 + n.y * i21) + abs(n.x * i12 + n.y * i22);
            }
            sum = sum + ray.sample.weight * value;
        }
        return sum / weights;
    }

private:
    struct Ray
    {
        NeedSample sample;
        Vec3d r;
        std::array<Vec3d, 2> aPixel{};
    };
    static Vec3d rayOf(const EdgeScene& s, Vec4d p)
    {
        const Vec4d r = s.frame.framedFromLocal * p;
        return {r.x, r.y, r.w};
    }
    std::vector<Ray> rays_;
};

// Of all samples those where no metric has an edge near: lixels far from round, and no side along the shadow's edge.
void keepSmooth(EdgeScene& s, const PlaneWarp& map)
{
    std::vector<NeedSample> smooth;
    for (std::size_t i = 0; i < s.samples.size(); ++i) {
        const Inverse m = inverseBy(s.rays, i, map);
        const Vec2d n = s.samples[i].across;
        if (!(dot(n, n) > 0)) continue;
        const double a = std::hypot(m[0][0] + m[1][1], m[1][0] - m[0][1]),
                     b = std::hypot(m[0][0] - m[1][1], m[1][0] + m[0][1]);
        const double c = std::abs(n.x * m[0][0] + n.y * m[1][0]), d = std::abs(n.x * m[0][1] + n.y * m[1][1]);
        const double sizeOfFirst = std::hypot(m[0][0], m[1][0]), sizeOfSecond = std::hypot(m[0][1], m[1][1]);
        if (std::min(a, b) < 0.05 * std::max(a, b) || c < 0.05 * sizeOfFirst || d < 0.05 * sizeOfSecond) continue;
        smooth.push_back(s.samples[i]);
    }
    s.samples = smooth;
    s.rays.assign(s.view, s.originWorld, s.frame.framedFromLocal, s.samples);
}

TEST(LixelEnergyChange, IsTheAutomaticDerivative)
{
    double worst = 0;
    forEachCase(kCases, [&](Rng& rng) {
        EdgeScene s = anyEdgeScene(rng);
        const PlaneWarp map = anyMap(rng, s.rays);
        keepSmooth(s, map);
        if (s.samples.empty()) return;
        const EnergyTwin twin(s);
        for (const LixelMetric metric : kAllMetrics) {
            const Dual expected = twin.energy<Dual>(metric, map, variables(map.w));
            const EnergyChange change = lixelEnergyChange(metric, s.rays, map);
            EXPECT_NEAR(change.energy, expected.value, 1e-9 * expected.value) << nameOf(metric);
            EXPECT_NEAR(change.energy, lixelEnergy(metric, s.rays, map), 1e-12 * expected.value) << nameOf(metric);
            const double apart = length(change.withW - expected.by) / length(expected.by);
            EXPECT_LT(apart, 1e-9) << nameOf(metric);
            worst = std::max(worst, apart);
        }
    });
    RecordProperty("worst", std::to_string(worst));
    std::printf("farthest from automatic differentiation: %.2e of the gradient\n", worst);
}

// Central differences of the energies themselves. Of all steps that one whose halves agree best.
TEST(LixelEnergyChange, IsWhatSmallTurnsOfTheAxisShow)
{
    double worst = 0;
    forEachCase(kCases, [&](Rng& rng) {
        EdgeScene s = anyEdgeScene(rng);
        const PlaneWarp map = anyMap(rng, s.rays);
        keepSmooth(s, map);
        if (s.samples.empty()) return;
        for (const LixelMetric metric : kAllMetrics) {
            const auto slopeBy = [&](double h) {
                const auto along = [&](Vec3d step) {
                    PlaneWarp before = map, after = map;
                    before.w = map.w - step, after.w = map.w + step;
                    return (lixelEnergy(metric, s.rays, after) - lixelEnergy(metric, s.rays, before)) / (2 * h);
                };
                return Vec3d{along({h, 0, 0}), along({0, h, 0}), along({0, 0, h})};
            };
            Vec3d best;
            double least = INFINITY;
            for (double h = 1e-3 * length(map.w); h > 1e-7 * length(map.w); h *= 0.5) {
                // Richardson's two.
                const Vec3d coarse = slopeBy(h), fine = slopeBy(0.5 * h);
                const double apart = length(fine - coarse);
                if (apart < least) least = apart, best = (4.0 * fine - coarse) / 3.0;
            }
            const Vec3d slope = lixelEnergyChange(metric, s.rays, map).withW;
            const double apart = length(slope - best) / length(slope);
            EXPECT_LT(apart, 1e-6) << nameOf(metric);
            worst = std::max(worst, apart);
        }
    });
    std::printf("farthest from central differences: %.2e of the gradient\n", worst);
}

} // namespace
} // namespace lixel
