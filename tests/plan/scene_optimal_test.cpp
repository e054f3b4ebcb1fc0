// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/scene_optimal.h"

#include "lixel/plan/fit/desired_view.h"
#include "lixel/plan/fit/lispsm.h"
#include "lixel/plan/fit/psm.h"
#include "lixel/plan/fit/tsm.h"
#include "plan/awkward_setups.h"
#include "plan/edge_scenes.h"
#include "plan/receivers.h"
#include "plan/search_cases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lixel {
namespace {

using namespace test;

SceneOptimalFit anyChoice(Rng& rng)
{
    SceneOptimalFit choice;
    choice.metric = kAllMetrics[rng.integer(0, 3)];
    choice.search = rng.chance(0.5) ? MapSearchKind::Wide : MapSearchKind::Descent;
    choice.hasShear = rng.chance(0.5);
    return choice;
}

// How far the farthest sample is from the middle of the map, whose square ends at 1; infinite behind the light or beyond the far side.
double farthestIn(const Fit& fit, std::span<const Vec3d> pointsLocal)
{
    double farthest = 0;
    for (const Vec3d& p : pointsLocal) {
        const Vec4d c = fit.lightClipFromLocal * point(p);
        if (!(c.w > 0)) return INFINITY;
        if (!(c.z <= c.w)) return INFINITY;
        farthest = std::max({farthest, std::abs(c.x / c.w), std::abs(c.y / c.w)});
    }
    return farthest;
}

double energyOf(const SearchCase& c, LixelMetric metric, const Fit& fit, double aspect)
{
    PlaneWarp rows = planeWarpOf(c.frame, fit.lightClipFromLocal).value();
    rows.x = std::sqrt(aspect) * rows.x, rows.y = (1 / std::sqrt(aspect)) * rows.y;
    return lixelEnergy(metric, c.rays, rows);
}

TEST(SceneOptimal, RowsOfAMatrixAreItsMapOfTheLightPlane)
{
    forEachCase(kCases, [](Rng& rng) {
        const EdgeScene s = anyEdgeScene(rng);
        const PlaneWarp map = anyMap(rng, s.rays);
        const Mat4d& framed = s.frame.framedFromLocal;
        const auto row = [&](Vec3d r) { return r.x * framed.row(0) + r.y * framed.row(1) + r.z * framed.row(3); };
        const Mat4d clip = Mat4d::fromRows(2.0 * row(map.x), 2.0 * row(map.y), framed.row(2), row(map.w));
        const PlaneWarp rows = planeWarpOf(s.frame, clip).value();
        EXPECT_LT(length(rows.x - map.x), 1e-9 * length(map.x));
        EXPECT_LT(length(rows.y - map.y), 1e-9 * length(map.y));
        EXPECT_LT(length(rows.w - map.w), 1e-9 * length(map.w));
    });
}

TEST(SceneOptimal, IsNeverWorseByItsMetricThanTheCheapFits)
{
    int tried = 0;
    forEachCase(kCases, [&](Rng& rng) {
        SearchCase c;
        if (!c.make(rng, 48, 36)) return;
        FitInput input = c.input();
        input.seenIsAll = true; // no slack, which others do not have
        input.mapAspect = rng.chance(0.5) ? 1 : rng.logUniform(0.3, 3);
        for (const LixelMetric metric : kAllMetrics) {
            SceneOptimalFit choice;
            choice.metric = metric, choice.hasShear = rng.chance(0.5);
            const double best = energyOf(c, metric, fitSceneOptimal(input, choice).value(), input.mapAspect);
            for (const FitResult& other : {fitDesiredView(input, true), fitLispsm(input),
                                           fitPsm(input, PsmShift::Casters), fitTsm(input, std::nullopt)}) {
                if (!other) continue;
                EXPECT_LE(best, energyOf(c, metric, *other, input.mapAspect) * (1 + 1e-5)) << nameOf(metric);
                ++tried;
            }
        }
    });
    EXPECT_GT(tried, 200);
}

TEST(SceneOptimal, HoldsEveryViewSample)
{
    forEachCase(kCases, [](Rng& rng) {
        SearchCase c;
        if (!c.make(rng, 48, 36)) return;
        FitInput input = c.input();
        input.mapAspect = rng.chance(0.5) ? 1 : rng.logUniform(0.3, 3);
        const SceneOptimalFit choice = anyChoice(rng);
        const FitResult fit = fitSceneOptimal(input, choice);
        ASSERT_TRUE(fit);
        EXPECT_LE(farthestIn(*fit, c.picture.facingLocal), 1);
        // Slack widens it, where not all receivers are known. Other fits hold more than samples.
        if (choice.search == MapSearchKind::Descent) {
            EXPECT_LE(farthestIn(*fit, c.picture.facingLocal), 1.0001 / (1 + choice.slack));
        }
    });
}

TEST(SceneOptimal, NeedsNoEdgesForARectangleOfLeastArea)
{
    forEachCase(kCases, [](Rng& rng) {
        SearchCase c;
        if (!c.make(rng, 48, 36)) return;
        FitInput input = c.input();
        input.edges = {};
        input.seenIsAll = true;
        const FitResult fit = fitSceneOptimal(input, anyChoice(rng)), rectangle = fitDesiredView(input, true);
        ASSERT_TRUE(fit && rectangle);
        const PlaneWarp a = planeWarpOf(c.frame, fit->lightClipFromLocal).value(),
                        b = planeWarpOf(c.frame, rectangle->lightClipFromLocal).value();
        const auto area = [](const PlaneWarp& rows) {
            return std::pow(length(rows.w), 3) / std::abs(dot(rows.x, cross(rows.y, rows.w)));
        };
        // Both have room around them for what floats round, of the long side: so much of the short one.
        const double sides = length(b.x) / length(b.y), rounding = 0x1p-24 * std::max(sides, 1 / sides);
        EXPECT_NEAR(area(a), area(b), (1e-5 + rounding) * area(b));
    });
}

// Lights far away: rays from a point become parallel, and so does what is best for them.
TEST(SceneOptimal, IsTheSameForParallelLightAsForALightFarAway)
{
    forEachCase(kCases, [](Rng& rng) {
        SearchCase sun;
        if (!sun.make(rng, 36, 27) || sun.setup.light.kind != LightKind::Directional) return;
        SearchCase lamp;
        lamp.setup = sun.setup;
        lamp.setup.light.kind = LightKind::Point;
        lamp.setup.light.range = INFINITY;
        lamp.setup.light.positionWorld =
            lamp.setup.originWorld - 1e6 * lamp.setup.radius * sun.setup.light.directionWorld;
        ASSERT_TRUE(lamp.frameIt());
        for (const LixelMetric metric : kAllMetrics) {
            SceneOptimalFit choice;
            choice.metric = metric;
            const double ofSun = energyOf(sun, metric, fitSceneOptimal(sun.input(), choice).value(), 1);
            const double ofLamp = energyOf(lamp, metric, fitSceneOptimal(lamp.input(), choice).value(), 1);
            EXPECT_NEAR(ofSun, ofLamp, 0.02 * ofSun) << nameOf(metric);
        }
    });
}

// Samples of any number of dimensions, at any place: in line, in one point, on planes edge-on to the light or the eye, without a
// direction of the edge or with one.
TEST(SceneOptimal, AnyReceiversHaveAFiniteMapThatHoldsThemOrARefusal)
{
    int refused = 0, made = 0;
    forEachCase(kCases, [&](Rng& rng) {
        const RandomSetup setup = rng.chance(0.5) ? awkwardSetup(rng) : anySetup(rng);
        const ViewSamples seen = anySamples(setup, rng);
        std::vector<Vec3d> points;
        for (const Vec3f& p : seen.positionLocal) points.push_back(toDouble(p));
        if (points.empty()) return;
        const Vec3d first = points.front(), last = points.back();
        switch (rng.integer(0, 4)) {
        case 0: points.assign(1, first); break;
        case 1: points.assign(3000, first); break;
        case 2: // in line
            for (std::size_t i = 0; i < points.size(); ++i)
                points[i] = first + (double(i) / double(points.size())) * (last - first);
            break;
        default: break;
        }
        std::vector<NeedSample> edges;
        for (const Vec3d& p : points) {
            const Vec3d toLight = towardsLight(setup.light, setup.originWorld, p),
                        toEye = normalized(towardsEye(setup.view, setup.originWorld, p));
            Vec3d n = rng.onSphere();
            if (rng.chance(0.3)) n = normalized(cross(rng.chance(0.5) ? toLight : toEye, n));
            if (!(dot(n, n) > 0.5)) n = {0, 1, 0};
            const double angle = rng.uniform(0, 6);
            edges.push_back(
                {p, n, rng.uniform(0, 1), rng.chance(0.5) ? Vec2d{} : Vec2d{std::cos(angle), std::sin(angle)}});
        }
        FitInput input = inputOf(setup);
        input.hasViewSamples = true;
        input.seenLocal = points;
        input.edges = edges;
        input.mapAspect = rng.logUniform(0.1, 10);
        const FitResult fit = fitSceneOptimal(input, anyChoice(rng));
        if (!fit) {
            EXPECT_EQ(fit.error(), FitFailure::ExtentNotInHemisphere);
            ++refused;
            return;
        }
        ++made;
        EXPECT_TRUE(isFinite(fit->lightClipFromLocal));
        // Positions are rounded to floats, some out of what other fits hold; all have room for a tenth of a lixel.
        EXPECT_LE(farthestIn(*fit, points), 1 + kUnroomed);
    });
    std::printf("%d made, %d refused\n", made, refused);
    EXPECT_GT(made, 0);
}

} // namespace
} // namespace lixel
