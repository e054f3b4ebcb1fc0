// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/edge_rays.h"

#include "lixel/plan/footprint.h"
#include "plan/appendix_twin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

namespace lixel {
namespace {

using namespace test;

// Where the sample's surface is seen in a pixel, and where that is on the light plane: a step on the picture.
std::optional<Vec3d> rayAtPixel(const EdgeScene& s, const NeedSample& sample, Vec2d step)
{
    const Mat4d pixels = pixelsFrom(s), back = inverse(pixels).value();
    const Vec3d at = project(pixels, sample.pointLocal);
    const Vec4d front = back * Vec4d{at.x + step.x, at.y + step.y, -1, 1},
                far = back * Vec4d{at.x + step.x, at.y + step.y, 0.5, 1};
    const Vec3d a = xyz(front) / front.w, b = xyz(far) / far.w;
    const double along = dot(sample.normal, b - a);
    const double t = dot(sample.normal, sample.pointLocal - a) / along;
    const Vec4d r = s.frame.framedFromLocal * point(a + t * (b - a));
    return Vec3d{r.x, r.y, r.w};
}

Vec2d mapped(const PlaneWarp& map, Vec3d r) { return {dot(map.x, r) / dot(map.w, r), dot(map.y, r) / dot(map.w, r)}; }

TEST(EdgeRays, HaveTheDerivativesOfTheAppendixForLightsAtAPoint)
{
    int tried = 0;
    forEachCase(kCases, [&](Rng& rng) {
        const EdgeScene s = anyEdgeScene(rng);
        if (!s.frame.isPerspective) return;
        ASSERT_EQ(s.rays.size(), s.samples.size());
        const PlaneWarp map = anyMap(rng, s.rays);
        for (std::size_t i = 0; i < s.samples.size(); ++i)
            EXPECT_LT(farthest(inverseBy(s.rays, i, map), Appendix(s, s.samples[i], map).inverseJacobian()), 1e-8);
        ++tried;
    });
    EXPECT_GT(tried, 0);
}

// Parallel light: lixels are a planar map of two linear functions of place, along the surface.
TEST(EdgeRays, HaveTheDerivativesOfPlanarMapsForParallelLight)
{
    forEachCase(kCases, [&](Rng& rng) {
        const EdgeScene s = anyEdgeScene(rng);
        if (s.frame.isPerspective) return;
        ASSERT_EQ(s.rays.size(), s.samples.size());
        const PlaneWarp map = anyMap(rng, s.rays);
        const Mat4d pixels = pixelsFrom(s);
        const Vec4d across = s.frame.framedFromLocal.row(0), up = s.frame.framedFromLocal.row(1);
        for (std::size_t i = 0; i < s.samples.size(); ++i) {
            const Vec3d p = s.samples[i].pointLocal, n = s.samples[i].normal;
            const Vec3d tangent[] = {anyPerpendicular(n), cross(n, anyPerpendicular(n))};
            const Vec4d clip = pixels * point(p);
            const double S = dot(across, point(p)), T = dot(up, point(p));
            const double x = dot(map.x, {S, T, 1}), y = dot(map.y, {S, T, 1}), w = dot(map.w, {S, T, 1});
            // Along each tangent: the quotient rule for pixels and for lixels.
            std::array<std::array<double, 2>, 2> pixel{}, lixel{};
            for (std::size_t t = 0; t < 2; ++t) {
                const Vec4d d = pixels * direction(tangent[t]);
                pixel[0][t] = (d.x * clip.w - clip.x * d.w) / (clip.w * clip.w);
                pixel[1][t] = (d.y * clip.w - clip.y * d.w) / (clip.w * clip.w);
                const double dS = dot(xyz(across), tangent[t]), dT = dot(xyz(up), tangent[t]);
                const double dw = map.w.x * dS + map.w.y * dT;
                lixel[0][t] = ((map.x.x * dS + map.x.y * dT) * w - x * dw) / (w * w);
                lixel[1][t] = ((map.y.x * dS + map.y.y * dT) * w - y * dw) / (w * w);
            }
            const Inverse back = inverseOf(lixel);
            Inverse expected{};
            for (std::size_t r = 0; r < 2; ++r)
                for (std::size_t c = 0; c < 2; ++c)
                    expected[r][c] = pixel[r][0] * back[0][c] + pixel[r][1] * back[1][c];
            EXPECT_LT(farthest(inverseBy(s.rays, i, map), expected), 1e-8);
        }
    });
}

TEST(EdgeRays, HaveTheDerivativesThatSmallStepsInThePictureShow)
{
    forEachCase(kCases, [&](Rng& rng) {
        const EdgeScene s = anyEdgeScene(rng, 10);
        const PlaneWarp map = anyMap(rng, s.rays);
        for (std::size_t i = 0; i < s.samples.size(); ++i) {
            constexpr double h = 1e-3; // pixels
            std::array<std::array<double, 2>, 2> jacobian{};
            for (std::size_t j = 0; j < 2; ++j) {
                const Vec2d step = j == 0 ? Vec2d{h, 0} : Vec2d{0, h};
                const Vec2d change = (0.5 / h) * (mapped(map, *rayAtPixel(s, s.samples[i], step)) -
                                                  mapped(map, *rayAtPixel(s, s.samples[i], -1.0 * step)));
                jacobian[0][j] = change.x, jacobian[1][j] = change.y;
            }
            EXPECT_LT(farthest(inverseBy(s.rays, i, map), inverseOf(jacobian)), 1e-4);
        }
    });
}

// The light clip matrix whose lixels are those of a map of one: of its square, whose side is 2.
Mat4d clipOf(const EdgeScene& s, const PlaneWarp& map)
{
    const Mat4d& framed = s.frame.framedFromLocal;
    const auto row = [&](Vec3d r) { return r.x * framed.row(0) + r.y * framed.row(1) + r.z * framed.row(3); };
    return Mat4d::fromRows(2.0 * row(map.x), 2.0 * row(map.y), framed.row(2), row(map.w));
}

TEST(EdgeRays, AreTheFootprintsInverse)
{
    forEachCase(kCases, [&](Rng& rng) {
        const EdgeScene s = anyEdgeScene(rng);
        PlaneWarp map = anyMap(rng, s.rays);
        double most = 0; // of the samples' places in the map, which is to hold them all
        for (std::size_t i = 0; i < s.rays.size(); ++i) {
            const Vec2d u = mapped(map, {s.rays.ray[0][i], s.rays.ray[1][i], s.rays.ray[2][i]});
            most = std::max({most, std::abs(u.x), std::abs(u.y)});
        }
        map.x = (0.4 / most) * map.x, map.y = (0.4 / most) * map.y;
        const LightImage image(clipOf(s, map), {0, 0, 1, 1, 0});
        std::vector<double> bad;
        badnesses(s.rays, map, bad);
        for (std::size_t i = 0; i < s.samples.size(); ++i) {
            const auto f = footprint(s.view, s.originWorld, image, s.samples[i].pointLocal, s.samples[i].normal);
            ASSERT_TRUE(f);
            const auto& m = f->lixelFromPixel;
            const Inverse expected = inverseOf({{{m[0][0], m[0][1]}, {m[1][0], m[1][1]}}});
            EXPECT_LT(farthest(inverseBy(s.rays, i, map), expected), 1e-8);
            EXPECT_NEAR(bad[i],
                        std::pow(expected[0][0], 2) + std::pow(expected[0][1], 2) + std::pow(expected[1][0], 2) +
                            std::pow(expected[1][1], 2),
                        1e-7 * bad[i]);
        }
    });
}

TEST(EdgeRays, LeaveOutSurfacesThatAreEdgeOn)
{
    forEachCase(kCases, [&](Rng& rng) {
        EdgeScene s = anyEdgeScene(rng, 10);
        const std::size_t count = s.samples.size();
        const Vec3d p = s.samples[0].pointLocal;
        for (const Vec3d along : {towardsEye(s.view, s.originWorld, p), towardsLight(s.light, s.originWorld, p)})
            s.samples.push_back({p, normalized(cross(along, rng.onSphere()))});
        s.rays.assign(s.view, s.originWorld, s.frame.framedFromLocal, s.samples);
        EXPECT_EQ(s.rays.size(), count);
    });
}

// What some say of all scatters: by more than a tenth in less than one of 10,000 cases, where few samples are most of the sum.
TEST(EdgeRays, SomeOfThemAreAsManyAndStandForAll)
{
    int beyondATenth = 0;
    forEachCase(kCases, [&](Rng& rng) {
        EdgeScene s = anyEdgeScene(rng);
        while (s.samples.size() < 8000)
            s.samples.push_back(s.samples[std::size_t(rng.integer(0, 7)) % s.samples.size()]);
        // Most weigh next to nothing, as those away from shadows do.
        for (std::size_t i = 0; i < s.samples.size(); ++i) {
            s.samples[i].weight = i % 8 == 0 ? rng.uniform(0.5, 1) : 0.002;
            if (i % 3 == 0) s.samples[i].across = {};
        }
        s.rays.assign(s.view, s.originWorld, s.frame.framedFromLocal, s.samples);
        EdgeRays some;
        some.assignSome(s.rays, 2000);
        EXPECT_LE(some.size(), 2000u);
        EXPECT_GT(some.size(), 800u); // no sample that weighs something is taken but as often as it does
        EXPECT_NEAR(std::accumulate(some.weight.begin(), some.weight.end(), 0.0), 1, 1e-12);
        EXPECT_NEAR(std::accumulate(some.edgeWeight.begin(), some.edgeWeight.end(), 0.0), 1, 1e-12);
        const PlaneWarp map = anyMap(rng, s.rays);
        for (const LixelMetric metric : kAllMetrics) {
            const double all = lixelEnergy(metric, s.rays, map), off = std::abs(lixelEnergy(metric, some, map) - all);
            EXPECT_LT(off, 0.2 * all) << nameOf(metric);
            beyondATenth += off > 0.1 * all;
        }
        // All of them: weights are made to sum to one again, and each sum is rounded once a term.
        some.assignSome(s.rays, s.rays.edgeWeight.size());
        const double rounding = 4 * std::numeric_limits<double>::epsilon() * double(s.rays.edgeWeight.size());
        for (const LixelMetric metric : kAllMetrics) {
            const double all = lixelEnergy(metric, s.rays, map);
            EXPECT_NEAR(lixelEnergy(metric, some, map), all, rounding * all) << nameOf(metric);
        }
    });
    EXPECT_LE(beyondATenth, scaled(kCases) / 10000);
}

// Edges of unknown direction are four in a row: taking every fourth, or every eighth, must not take one direction alone.
TEST(EdgeRays, SomeOfThemHaveAllDirections)
{
    Rng rng(5);
    for (const std::size_t count : {320u, 640u, 1280u, 2560u, 5120u}) {
        EdgeScene s = anyEdgeScene(rng, 1);
        s.samples[0].across = {};
        s.samples.resize(count, s.samples[0]);
        s.rays.assign(s.view, s.originWorld, s.frame.framedFromLocal, s.samples);
        EdgeRays some;
        some.assignSome(s.rays, 640);
        const PlaneWarp map = anyMap(rng, s.rays);
        const double all = lixelEnergy(LixelMetric::Width, s.rays, map);
        EXPECT_NEAR(lixelEnergy(LixelMetric::Width, some, map), all, 0.02 * all) << count;
    }
}

} // namespace
} // namespace lixel
