// SPDX-License-Identifier: MIT
// The maps that plane-optimal fits give: what they hold, how they lie on the picture, and what is refused.
#include "lixel/plan/fit/plane_optimal.h"

#include "lixel/plan/fit/visible_body.h"
#include "lixel/plan/light_image.h"
#include "plan/plane_setups.h"
#include "plan/receivers.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <string>

namespace lixel {
namespace {

using test::anyPixel;
using test::anyPlaneSetup;
using test::forEachCase;
using test::inputOf;
using test::lightLocal;
using test::PlaneSetup;
using test::pointSeenAt;
using test::Rng;
using test::rowOf;

// Where the light ray through a point meets the plane, as the viewer sees it; nothing outside the picture.
std::optional<Vec2d> pixelAlongLight(const PlaneSetup& setup, Vec3d pointLocal)
{
    Vec4d pi = rowOf(setup.planeLocal);
    const Vec4d l = lightLocal(setup);
    if (dot(pi, l) < 0) pi = -1.0 * pi;
    const Vec4d inPlane = dot(pi, l) * point(pointLocal) - dot(pi, point(pointLocal)) * l;
    const Vec4d clip = clipFromLocal(setup.view, setup.originWorld) * inPlane;
    if (!(clip.w > 0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w)) return std::nullopt;
    return Vec2d{(0.5 + 0.5 * clip.x / clip.w) * setup.view.width, (0.5 + 0.5 * clip.y / clip.w) * setup.view.height};
}

bool isReached(const PlaneSetup& setup, Vec3d pointLocal)
{
    return isLightFacing(setup.light, setup.originWorld, pointLocal,
                         towardsLight(setup.light, setup.originWorld, pointLocal));
}

// How flat light and eye stand over the plane.
double flattest(const PlaneSetup& setup)
{
    return std::min({1.0, std::abs(test::sineAbove(setup, lightLocal(setup))),
                     std::abs(test::sineAbove(setup, eyeLocal(setup.view, setup.originWorld)))});
}

// A point of a box, often of a face, an edge or a corner of it.
Vec3d anyPointOf(const Box& box, Rng& rng)
{
    const auto between = [&rng](double low, double high) {
        return rng.chance(0.3) ? (rng.chance(0.5) ? low : high) : rng.uniform(low, high);
    };
    return {between(box.min.x, box.max.x), between(box.min.y, box.max.y), between(box.min.z, box.max.z)};
}

// Every receiver that is seen, reached and has its place in the picture is in the map, before its far side; what may shadow it is in
// the same place and no farther. The receivers are exact: rounding of floats is what the guard band and the least size are for.
void expectCovers(const PlaneSetup& setup, const Fit& fit, Rng& rng, int& narrowed)
{
    const double rounding = 1e-9 / flattest(setup); // of the way to the plane
    const double touch = fit.pixels ? 4e-6 : 0;     // whole pixels: a millionth into one counts as not at all
    for (int i = 0; i < 100; ++i) {
        const std::size_t box = std::size_t(rng.integer(0, int(setup.boxesWorld.size()) - 1));
        const Vec3d p = anyPointOf(setup.boxesWorld[box], rng) - setup.originWorld;
        if (!test::isInView(setup, p) || test::isNextToLight(setup, p) || !isReached(setup, p)) continue;
        if (!pixelAlongLight(setup, p)) continue;
        if (fit.narrowedToLocal && fit.narrowedToLocal->signedDistance(p) < 0) {
            ++narrowed;
            continue;
        }
        const Vec4d c = fit.lightClipFromLocal * point(p);
        ASSERT_GT(c.w, 0);
        EXPECT_LE(std::abs(c.x / c.w) - 1, rounding + touch);
        EXPECT_LE(std::abs(c.y / c.w) - 1, rounding + touch);
        EXPECT_LE(c.z / c.w - 1, rounding);
        const Vec3d caster = p + rng.uniform(0, 0.5) * setup.radius * towardsLight(setup.light, setup.originWorld, p);
        const Vec4d q = fit.lightClipFromLocal * point(caster);
        if (q.w > 1e-6 * c.w) {
            EXPECT_NEAR(q.x / q.w, c.x / c.w, 1e-5 * c.w / q.w / flattest(setup));
            EXPECT_NEAR(q.y / q.w, c.y / c.w, 1e-5 * c.w / q.w / flattest(setup));
            EXPECT_LE(q.z / q.w, c.z / c.w + rounding);
        }
    }
}

class PlaneOptimalMap : public testing::TestWithParam<bool>
{
};

TEST_P(PlaneOptimalMap, HoldsEveryReceiverWithItsPlaceInThePictureOrIsRefusedByName)
{
    std::map<std::string, int> refusals;
    int narrowed = 0, held = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        const PlaneSetup setup = anyPlaneSetup(rng);
        const FitResult fit = fitPlaneOptimal(inputOf(setup, Twist(rng.integer(0, 1)), GetParam()), {});
        if (!fit) {
            ++refusals[std::string(nameOf(fit.error()))];
            return;
        }
        ++held;
        ASSERT_TRUE(isFinite(fit->lightClipFromLocal));
        expectCovers(setup, *fit, rng, narrowed);
    });
    std::printf("%d maps, %d receivers left to the next region", held, narrowed);
    for (const auto& [reason, count] : refusals) std::printf(", %s %d", reason.c_str(), count);
    std::printf("\n");
    EXPECT_GT(held, test::scaled(400));
}

// Planes in the faces and through the corners of boxes, through the light, through the eye, across the line of sight.
Plane awkwardPlane(const PlaneSetup& setup, Rng& rng)
{
    constexpr Vec3d kAxes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    const Box box = translated(setup.boxesWorld[0], -setup.originWorld);
    const Vec4d l = lightLocal(setup), eye = eyeLocal(setup.view, setup.originWorld);
    const Vec3d forward = normalized(xyz(setup.view.clipFromAnchored.row(3)));
    const Vec3d normals[] = {kAxes[rng.integer(0, 5)],
                             kAxes[rng.integer(0, 5)],
                             forward,
                             rng.onSphere(),
                             normalized(cross(forward, rng.onSphere())),
                             normalized(xyz(l)),
                             normalized(cross(xyz(l), rng.onSphere()))};
    const Vec3d places[] = {box.centre(),
                            box.corners()[std::size_t(rng.integer(0, 7))],
                            box.min,
                            eye.w > 0 ? xyz(eye) : box.max,
                            l.w > 0 ? (1 / l.w) * xyz(l) : box.max,
                            setup.radius * rng.inBox(1)};
    Vec3d n = normals[rng.integer(0, 6)];
    if (!(length(n) > 0.5)) n = {0, 1, 0};
    const double aside = rng.chance(0.5) ? 0 : setup.radius * rng.logUniform(1e-12, 1);
    return planeThrough(places[rng.integer(0, 5)] + aside * n, n);
}

TEST_P(PlaneOptimalMap, OfAwkwardSetupsIsFiniteAndHoldsItsReceiversOrIsRefusedByName)
{
    int narrowed = 0, held = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        PlaneSetup setup;
        static_cast<test::RandomSetup&>(setup) = test::awkwardSetup(rng);
        setup.planeLocal = awkwardPlane(setup, rng);
        FitInput input = inputOf(setup, Twist(rng.integer(0, 2)), GetParam());
        const Vec4d l = lightLocal(setup);
        if (l.w > 0) input.plane->throughLineLocal = planeThrough((1 / l.w) * xyz(l), rng.onSphere());
        const FitResult fit = fitPlaneOptimal(input, {});
        if (!fit) return;
        ++held;
        ASSERT_TRUE(isFinite(fit->lightClipFromLocal));
        if (GetParam()) {
            EXPECT_GT(fit->pixels->width(), 0);
            EXPECT_GT(fit->pixels->height(), 0);
        }
        expectCovers(setup, *fit, rng, narrowed);
    });
    std::printf("%d maps\n", held);
    EXPECT_GT(held, test::scaled(200));
}

INSTANTIATE_TEST_SUITE_P(Modes, PlaneOptimalMap, testing::Bool(),
                         [](const auto& mode) { return mode.param ? "OfWholePixels" : "OfAnySize"; });

TEST(PlaneOptimal, AtALixelAPixelLixelCentresArePixelCentres)
{
    int seen = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        const PlaneSetup setup = anyPlaneSetup(rng);
        const FitResult fit = fitPlaneOptimal(inputOf(setup, Twist::Tight, true), {});
        if (!fit) return;
        const PixelRectangle& r = *fit->pixels;
        EXPECT_GE(r.x0, 0);
        EXPECT_GE(r.y0, 0);
        EXPECT_LE(r.x1, setup.view.width);
        EXPECT_LE(r.y1, setup.view.height);
        const LightImage image(fit->lightClipFromLocal, {0, 0, r.width(), r.height(), 0});
        for (int i = 0; i < 10; ++i) {
            const Vec2d pixel{rng.integer(r.x0, r.x1 - 1) + 0.5, rng.integer(r.y0, r.y1 - 1) + 0.5};
            const auto p = pointSeenAt(setup, pixel);
            if (!p) continue;
            const auto lixel = image.lixelAt(*p);
            ASSERT_TRUE(lixel);
            ++seen;
            const double allowed = std::max(1e-8, 1e-12 * setup.view.width / (flattest(setup) * flattest(setup)));
            EXPECT_NEAR(lixel->x + r.x0, pixel.x, allowed);
            EXPECT_NEAR(lixel->y + r.y0, pixel.y, allowed);
        }
    });
    EXPECT_GT(seen, test::scaled(1000));
}

// Pixels that the corners of the map's square are at, by the rays of light through them.
std::array<Vec2d, 4> cornersInPixels(const PlaneSetup& setup, const Fit& fit, const LightFrame& frame)
{
    // The rows x, y of the fit are pixels about a centre, over half sizes: undone, they say where ndc = (+-1, +-1) is.
    std::array<Vec2d, 4> corners;
    const LightImage image(fit.lightClipFromLocal, {0, 0, 2, 2, 0});
    for (int i = 0; i < 4; ++i) {
        const auto ray = image.rayThrough({i == 0 || i == 3 ? 0.0 : 2.0, i < 2 ? 0.0 : 2.0});
        const double along =
            -setup.planeLocal.signedDistance(ray->originLocal) / dot(setup.planeLocal.normal, ray->directionLocal);
        corners[std::size_t(i)] = onLightPlane(frame, ray->originLocal + along * ray->directionLocal);
    }
    return corners;
}

double area(const std::array<Vec2d, 4>& c) { return 0.5 * std::abs(cross(c[2] - c[0], c[3] - c[1])); }

TEST(PlaneOptimal, ATightTwistHasNoLargerMapThanNone)
{
    int smaller = 0, tried = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        const PlaneSetup setup = anyPlaneSetup(rng);
        if (flattest(setup) < 0.05) return; // the least sizes that floats resolve decide there
        const FitResult none = fitPlaneOptimal(inputOf(setup, Twist::None, false), {});
        const FitResult tight = fitPlaneOptimal(inputOf(setup, Twist::Tight, false), {});
        ASSERT_EQ(none.hasValue(), tight.hasValue());
        if (!none) return;
        const auto frame = planeOptimalFrame(setup.view, setup.light, setup.originWorld, setup.planeLocal,
                                             setup.sceneLocal().diagonal());
        const double before = area(cornersInPixels(setup, *none, *frame));
        const double after = area(cornersInPixels(setup, *tight, *frame));
        if (before < 1000) return; // and there
        ++tried;
        EXPECT_LE(after, before * (1 + 1e-3));
        smaller += after < 0.99 * before;
    });
    std::printf("%d of %d smaller\n", smaller, tried);
    EXPECT_GT(smaller, tried / 4);
}

// A line of the plane as the plane through it and the light.
Plane throughLight(const PlaneSetup& setup, Vec3d a, Vec3d b)
{
    const Vec4d l = lightLocal(setup);
    const Vec3d normal = normalized(cross(b - a, xyz(l) - l.w * a));
    return planeThrough(a, normal);
}

TEST(PlaneOptimal, ATwistToALineMakesItHorizontalOrVerticalInTheMap)
{
    int tried = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        const PlaneSetup setup = anyPlaneSetup(rng);
        if (flattest(setup) < 1e-3) return;
        const auto a = pointSeenAt(setup, anyPixel(setup.view, rng), 10),
                   b = pointSeenAt(setup, anyPixel(setup.view, rng), 10);
        if (!a || !b || !(length(*a - *b) > 1e-2 * setup.radius)) return;
        FitInput input = inputOf(setup, Twist::Line, false);
        input.plane->throughLineLocal = throughLight(setup, *a, *b);
        const FitResult fit = fitPlaneOptimal(input, {});
        if (!fit) return;
        ++tried;
        const Vec3d first = project(fit->lightClipFromLocal, *a), second = project(fit->lightClipFromLocal, *b);
        const double dx = std::abs(first.x - second.x), dy = std::abs(first.y - second.y);
        EXPECT_LT(std::min(dx, dy),
                  1e-6 * (1 + std::abs(first.x) + std::abs(first.y) + std::max(dx, dy)) / flattest(setup));
    });
    EXPECT_GT(tried, test::scaled(200));
}

TEST(PlaneOptimal, ATwistToALineThatIsNotInThePictureIsLeftOut)
{
    int behind = 0, beside = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        const PlaneSetup setup = anyPlaneSetup(rng);
        if (flattest(setup) < 1e-3) return;
        // A line with `at` nearest to the eye.
        const Vec3d eye = setup.view.anchorWorld - setup.originWorld, normal = setup.planeLocal.normal;
        const Vec3d inPlane = normalized(cross(normal, rng.onSphere()));
        const Vec3d at = eye - setup.planeLocal.signedDistance(eye) * normal +
                         setup.radius * rng.logUniform(1e-2, 10) * cross(normal, inPlane);
        // No part of it that is before the viewer is in the picture, as far as small steps show.
        const Mat4d clip = clipFromLocal(setup.view, setup.originWorld);
        bool isSeen = false, isInImage = false;
        for (int i = -4000; i <= 4000; ++i) {
            const double t = length(at - eye) * std::copysign(std::expm1(std::abs(i) / 200.0), i);
            const Vec4d c = clip * point(at + t * inPlane);
            const bool isIn = std::abs(c.x) <= 1.1 * std::abs(c.w) && std::abs(c.y) <= 1.1 * std::abs(c.w);
            isSeen = isSeen || (isIn && c.w > 0);
            isInImage = isInImage || isIn;
        }
        if (isSeen) return;
        FitInput input = inputOf(setup, Twist::Line, false);
        input.plane->throughLineLocal = throughLight(setup, at, at + setup.radius * inPlane);
        const FitResult fit = fitPlaneOptimal(input, {}),
                        none = fitPlaneOptimal(inputOf(setup, Twist::None, false), {});
        ASSERT_EQ(fit.hasValue(), none.hasValue());
        if (!fit) return;
        ++(isInImage ? behind : beside);
        EXPECT_EQ(fit->lightClipFromLocal, none->lightClipFromLocal);
    });
    std::printf("%d behind the viewer, %d beside the picture\n", behind, beside);
    EXPECT_GT(behind, test::scaled(20));
    EXPECT_GT(beside, test::scaled(20));
}

// A lamp just above a wide floor: what is next to it has no place in one map.
TEST(PlaneOptimal, ReceiversTooNearALampAreNamedAndAllOthersHeld)
{
    int narrowedMaps = 0, narrowed = 0, held = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        PlaneSetup setup;
        setup.radius = 100;
        setup.boxesWorld = {{{-100, -1, -100}, {100, 0, 100}}, {{-1, 0, -1}, {1, 0.01, 1}}};
        setup.planeLocal = {{0, 1, 0}, 0};
        setup.view = perspectiveView({rng.uniform(-5, 5), rng.uniform(2, 10), 20}, {0, 0, 0}, {0, 1, 0}, 1, 0.1,
                                     INFINITY, 512, 512);
        setup.light.kind = rng.chance(0.5) ? LightKind::Point : LightKind::Spot;
        setup.light.positionWorld = {rng.uniform(-1, 1), rng.logUniform(1e-3, 1), rng.uniform(-1, 1)};
        setup.light.directionWorld = {0, -1, 0};
        setup.light.coneAngle = 3;
        const FitResult fit = fitPlaneOptimal(inputOf(setup, Twist::Tight, rng.chance(0.5)), {});
        ASSERT_TRUE(fit);
        ++held;
        narrowedMaps += fit->narrowedToLocal.has_value();
        expectCovers(setup, *fit, rng, narrowed);
        if (!fit->narrowedToLocal) return;
        // Little is lost: where the light is far below or beside what is seen, nothing.
        EXPECT_LT(fit->narrowedToLocal->signedDistance(setup.light.positionWorld), 0);
    });
    std::printf("%d of %d maps narrowed, %d receivers left to the next region\n", narrowedMaps, held, narrowed);
    EXPECT_GT(narrowedMaps, 0);
}

// Figure 5's hardest case: of four rays through the picture's corners only one meets the plane before the viewer.
TEST(PlaneOptimal, OneCornerOfTheViewAloneOnThePlaneHasItsLixels)
{
    int tried = 0;
    forEachCase(10 * test::kCases, [&](Rng& rng) {
        PlaneSetup setup = anyPlaneSetup(rng);
        const double w = setup.view.width, h = setup.view.height;
        int before = 0;
        for (const Vec2d corner : {Vec2d{0, 0}, Vec2d{w, 0}, Vec2d{0, h}, Vec2d{w, h}}) {
            const Vec4d p = test::seenAt(setup, corner);
            before += dot(clipFromLocal(setup.view, setup.originWorld).row(3), p) * p.w > 0;
        }
        if (before != 1 || flattest(setup) < 1e-3) return;
        const FitResult fit = fitPlaneOptimal(inputOf(setup, Twist::None, true), {});
        if (!fit) return;
        const PixelRectangle& r = *fit->pixels;
        const LightImage image(fit->lightClipFromLocal, {0, 0, r.width(), r.height(), 0});
        for (int i = 0; i < 20; ++i) {
            const Vec2d pixel = anyPixel(setup.view, rng);
            const auto p = pointSeenAt(setup, pixel);
            if (!p || pixel.x < r.x0 || pixel.x >= r.x1 || pixel.y < r.y0 || pixel.y >= r.y1) continue;
            ++tried;
            const auto lixel = image.lixelAt(*p);
            ASSERT_TRUE(lixel);
            EXPECT_NEAR(lixel->x + r.x0, pixel.x, 1e-6);
            EXPECT_NEAR(lixel->y + r.y0, pixel.y, 1e-6);
        }
    });
    std::printf("%d points\n", tried);
    EXPECT_GT(tried, test::scaled(100));
}

} // namespace
} // namespace lixel
