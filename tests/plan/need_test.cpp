// SPDX-License-Identifier: MIT
#include "lixel/plan/need.h"

#include "lixel/plan/allocate.h"
#include "lixel/plan/fit/focused.h"
#include "plan/random_setups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace lixel {
namespace {

using test::forEachCase;
using test::RandomSetup;
using test::Rng;

// How far a point of the surface that is one step along the map's x or y is away in the picture, across an edge: by small steps.
TEST(Need, IsWhatSmallStepsOnTheSurfaceShow)
{
    int tried = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        const RandomSetup setup = test::anySetup(rng);
        const FitResult fit = fitFocused(test::inputOf(setup));
        if (!fit) return;
        const Box& box = setup.boxesWorld[0];
        const Vec3d p = box.centre() - setup.originWorld, n = rng.onSphere();
        const Mat4d clip = clipFromLocal(setup.view, setup.originWorld);
        const double w = (clip * point(p)).w, lightW = (fit->lightClipFromLocal * point(p)).w;
        if (!(w > 1e-2 * setup.radius) || !(lightW > 0)) return;
        const Vec3d toLight = towardsLight(setup.light, setup.originWorld, p),
                    toEye = normalized(towardsEye(setup.view, setup.originWorld, p));
        if (std::abs(dot(n, toLight)) < 0.1 || std::abs(dot(n, toEye)) < 0.1) return;
        const Need need = NeedPredictor(setup.view, setup.originWorld).of(*fit, {p, n, 1});

        // The surface's steps in the picture and in the map, by differences about the point.
        const double h = 1e-5 * std::min(w, setup.radius);
        const Vec3d t1 = anyPerpendicular(n), t2 = cross(n, t1);
        const auto slope = [&](const auto& image, Vec3d t) {
            return (0.5 / h) * (image(p + h * t) - image(p - h * t));
        };
        const auto picture = [&](Vec3d q) {
            const Vec3d pixel = pixelFromLocal(setup.view, setup.originWorld, q);
            return Vec2d{pixel.x, pixel.y};
        };
        const auto map = [&](Vec3d q) {
            const Vec3d ndc = project(fit->lightClipFromLocal, q);
            return Vec2d{0.5 * ndc.x, 0.5 * ndc.y}; // of a map of one lixel
        };
        const Vec2d p1 = slope(picture, t1), p2 = slope(picture, t2), m1 = slope(map, t1), m2 = slope(map, t2);
        const double perArea = 1 / cross(m1, m2);
        const double x = length(Vec2d{m2.y * perArea, -m1.y * perArea}),
                     y = length(Vec2d{-m2.x * perArea, m1.x * perArea});
        const double across = std::abs(cross(p1, p2)) / std::sqrt(0.5 * (dot(p1, p1) + dot(p2, p2)));
        const double most = 8 * std::hypot(setup.view.width, setup.view.height);
        if (!(across * std::max(x, y) < 0.9 * most)) return; // capped
        const double precision = 1e-3 + 1e-9 * lightW / h;   // differences of far lights have few digits
        if (precision > 0.05) return;
        ++tried;
        EXPECT_NEAR(need.alongX / (across * x), 1, precision);
        EXPECT_NEAR(need.alongY / (across * y), 1, precision);
    });
    EXPECT_GT(tried, test::scaled(200));
}

double errorOf(std::span<const LixelRectangle> pieces, std::span<const Need> needs, std::span<const bool> turned)
{
    double sum = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const double w = pieces[i].width(), h = pieces[i].height();
        sum += turned[i] ? needs[i].within(h, w) : needs[i].within(w, h);
    }
    return sum;
}

TEST(Need, CutsByNeedFillTheWholeAndPredictNoMoreErrorThanEvenCuts)
{
    double worst = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        const auto n = std::size_t(rng.integer(1, 8));
        const LixelRectangle whole{0, 0, rng.integer(64, 1024), rng.integer(64, 1024), 0};
        std::vector<Need> needs(n);
        std::vector<double> shares(n), even(n, 1.0 / double(n));
        for (std::size_t i = 0; i < n; ++i) {
            needs[i] = {rng.logUniform(1e-2, 1e2), rng.logUniform(1e-2, 1e2)};
            shares[i] = needs[i].best();
        }
        sharesByNeed(shares);
        std::vector<LixelRectangle> pieces(n), evenPieces(n);
        bool turned[8] = {}, evenTurned[8] = {};
        ASSERT_TRUE(cutRectangleByNeed(whole, shares, needs, pieces, {turned, n}));
        ASSERT_TRUE(cutRectangle(whole, even, evenPieces));
        std::int64_t area = 0;
        for (std::size_t i = 0; i < n; ++i) {
            area += std::int64_t(pieces[i].width()) * pieces[i].height();
            for (std::size_t k = 0; k < i; ++k)
                EXPECT_TRUE(pieces[i].x0 >= pieces[k].x1 || pieces[k].x0 >= pieces[i].x1 ||
                            pieces[i].y0 >= pieces[k].y1 || pieces[k].y0 >= pieces[i].y1);
        }
        EXPECT_EQ(area, std::int64_t(whole.width()) * whole.height());
        const double error = errorOf(pieces, needs, {turned, n}), ofEven = errorOf(evenPieces, needs, {evenTurned, n});
        worst = std::max(worst, error / ofEven);
        EXPECT_LE(error, ofEven * 1.0001);
    });
    std::printf("at worst %.3f of even cuts\n", worst);
}

TEST(Need, GuardBandsKeepPiecesFromBecomingThin)
{
    const std::vector<Need> needs{{1, 1}, {1e-4, 1e-1}};
    std::vector<double> shares{needs[0].best(), needs[1].best()};
    sharesByNeed(shares);
    std::vector<LixelRectangle> pieces(2);
    bool turned[2] = {};
    ASSERT_TRUE(cutRectangleByNeed({0, 0, 512, 512, 0}, shares, needs, pieces, turned, 2));
    EXPECT_GE(std::min(pieces[1].width(), pieces[1].height()), 8);
}

} // namespace
} // namespace lixel
