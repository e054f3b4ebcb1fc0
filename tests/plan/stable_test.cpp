// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/stable.h"

#include "lixel/plan/shadow_plan.h"
#include "plan/host_cameras.h"
#include "plan/ordinary_setups.h"
#include "plan/receivers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lixel {
namespace {

using test::forEachCase;
using test::ordinarySetup;
using test::planOf;
using test::RandomSetup;
using test::Rng;

View viewFrom(Vec3d eye, double yaw, double pitch, double fovy = 1)
{
    const Vec3d forward{std::cos(pitch) * std::cos(yaw), std::sin(pitch), std::cos(pitch) * std::sin(yaw)};
    return perspectiveView(eye, eye + forward, {0, 1, 0}, fovy, 0.1, 20, 640, 480);
}

// Shifted by up to half a pixel.
View jittered(View view, Rng& rng)
{
    const double shift[] = {rng.uniform(-1, 1) / view.width, rng.uniform(-1, 1) / view.height};
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 4; ++column)
            view.clipFromAnchored.m[row][column] += shift[row] * view.clipFromAnchored.m[3][column];
    return view;
}

// The lixel of a point fixed in the world, as a frame's map has it.
Vec2d lixelOf(const FramePlan& plan, std::size_t region, Vec3d pointWorld)
{
    const PlannedRegion& r = plan.lights[0].regions[region];
    const Vec3d ndc = project(r.lightClipFromLocal, pointWorld - plan.originWorld);
    return {r.rectangle.x0 + (0.5 + 0.5 * ndc.x) * r.rectangle.width(),
            r.rectangle.y0 + (0.5 + 0.5 * ndc.y) * r.rectangle.height()};
}

class Crawl : public testing::TestWithParam<const char*>
{
};

TEST_P(Crawl, MovingTurningAndJitteringTheCameraMovesTheMapByWholeLixels)
{
    int tried = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        RandomSetup setup = ordinarySetup(rng);
        const Vec3d eye = setup.view.anchorWorld;
        const double fovy = rng.uniform(0.3, 1.6);
        setup.view = viewFrom(eye, rng.uniform(0, 6), rng.uniform(-0.3, 0.3), fovy);
        const FramePlan first = planOf(setup, GetParam());
        const Vec3d moved = eye + rng.inBox(0.02 * setup.radius);
        const Vec3d there{moved.x, eye.y, moved.z};
        setup.view = jittered(viewFrom(there, rng.uniform(0, 6), rng.uniform(-0.3, 0.3), fovy), rng);
        setup.originWorld = {std::round(moved.x), 0, std::round(moved.z)};
        const FramePlan second = planOf(setup, GetParam());
        const bool hasCascades =
            std::string_view(GetParam()).starts_with("pssm") && setup.light.kind == LightKind::Directional;
        const std::size_t regions = hasCascades ? 3 : 1;
        // Cascades that see nothing have no region; which of them are left is not told.
        if (first.lights[0].regions.size() != regions || second.lights[0].regions.size() != regions) return;
        ++tried;
        for (std::size_t i = 0; i < regions; ++i) {
            for (int k = 0; k < 3; ++k) {
                const Vec3d p = eye + rng.inBox(5);
                const Vec2d by = lixelOf(second, i, p) - lixelOf(first, i, p);
                const double rounding = 1e-5 + 1e-12 * length(lixelOf(first, i, p));
                EXPECT_NEAR(by.x, std::round(by.x), rounding);
                EXPECT_NEAR(by.y, std::round(by.y), rounding);
            }
        }
    });
    EXPECT_GT(tried, test::scaled(test::kCases) / 4);
}

INSTANTIATE_TEST_SUITE_P(Techniques, Crawl,
                         testing::Values("focused(stable)", "pssm(3,stable)+allocation=share", "uniform"));

// Any place, turn, roll and format, off-centre and jittered. The far corners of oblique views may lie beyond infinity.
TEST(HeldView, HoldsEveryViewThatItStandsFor)
{
    int tried = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        const test::Camera camera = test::anyCamera(rng, test::kLenses[rng.integer(0, 2)], false, rng.inBox(10), 10);
        const View view = test::lixelView(camera);
        const auto held = heldView(view, rng.logUniform(1e-3, 5));
        if (!held) {
            EXPECT_GT(std::max({-camera.left, camera.right, -camera.bottom, camera.top}), std::tan(1.1));
            return;
        }
        ++tried;
        const auto worldFromClip = inverse(clipFromWorld(view));
        ASSERT_TRUE(worldFromClip);
        for (int i = 0; i < 8; ++i) {
            const Vec4d corner = *worldFromClip * Vec4d{i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0, 1};
            const Vec4d c = clipFromWorld(*held) * point(xyz(corner) / corner.w);
            EXPECT_GT(c.w, 0);
            EXPECT_LE(std::max(std::abs(c.x), std::abs(c.y)), c.w * (1 + 1e-9));
            EXPECT_GE(c.z, -c.w);
        }
    });
    EXPECT_GT(tried, test::scaled(test::kCases) / 2);
}

TEST(HeldView, IsLittleWiderThanTheViewAndNotNearer)
{
    const View view = viewFrom({10, 1.7, 3}, 1.0, 0.1);
    const auto held = heldView(view, 0.5);
    ASSERT_TRUE(held);
    const auto clipFromHeld = inverse(held->clipFromAnchored);
    ASSERT_TRUE(clipFromHeld);
    const Vec4d corner = *clipFromHeld * Vec4d{1, 1, -1, 1};
    const Mat4d eyeFromAnchored = eyeFromWorldRotation(xyz(held->clipFromAnchored.row(3)), {0, 1, 0});
    const Vec3d seen = xyz(eyeFromAnchored * point(xyz(corner) / corner.w));
    const double aspect = 640.0 / 480;
    EXPECT_NEAR(std::atan(seen.y / -seen.z), 0.5, 0.12);
    EXPECT_NEAR(std::atan(seen.x / -seen.z), std::atan(aspect * std::tan(0.5)), 0.12);
    EXPECT_GT(-seen.z, 0.2); // the cell's half diagonal is 0.43, and the eye behind it
}

double largestDifference(const View& a, const View& b)
{
    const Mat4d one = clipFromWorld(a), two = clipFromWorld(b);
    double most = 0;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            most = std::max(most, std::abs(one.m[row][column] - two.m[row][column]));
    return most;
}

// The camera turned by so much about any axis.
Mat4d turnedBy(double angle, Rng& rng, const Mat4d& eyeFromWorld)
{
    const Vec3d axis = angle * rng.onSphere(), forward = -xyz(eyeFromWorld.row(2)), up = xyz(eyeFromWorld.row(1));
    return eyeFromWorldRotation(forward + cross(axis, forward), up + cross(axis, up));
}

// A camera as programs have them: level or pitched by a few degrees, along an axis of the world or half-way between two, y or z up,
// or straight down; openings and near sides of round numbers; it stands anywhere.
test::Camera usualCamera(Rng& rng)
{
    test::Camera camera;
    const auto eighth = [&] { return rng.integer(-4, 4) * std::numbers::pi / 4; };
    const bool isZUp = rng.chance(0.5), isDown = rng.chance(0.2);
    const double yaw = eighth(), pitch = isDown ? -std::numbers::pi / 2 : rng.integer(-1, 1) * rng.uniform(0.02, 0.03);
    const Vec3d level{std::sin(yaw), 0, std::cos(yaw)}, y{0, 1, 0};
    const Vec3d forward = std::cos(pitch) * level + std::sin(pitch) * y, up = isDown ? level : y;
    const auto inWorld = [&](Vec3d v) { return isZUp ? Vec3d{v.z, v.x, v.y} : v; };
    camera.eyeWorld = rng.inBox(10);
    camera.rotation = eyeFromWorldRotation(inWorld(forward), inWorld(up));
    camera.width = rng.integer(64, 2048), camera.height = rng.integer(64, 1024);
    camera.top = std::tan(rng.integer(20, 120) / 256.0); // half of the opening
    camera.bottom = -camera.top;
    camera.right = camera.top * camera.width / camera.height;
    camera.left = -camera.right;
    camera.near = rng.chance(0.5) ? std::exp2(rng.integer(-10, 1)) : std::pow(10, rng.integer(-3, 0));
    camera.far = rng.chance(0.5) ? INFINITY : 1000;
    return camera;
}

// The same with noise in all that it is made of, and shifted by up to half a pixel.
test::Camera perturbed(test::Camera camera, Rng& rng, double noise)
{
    camera.eyeWorld = camera.eyeWorld + rng.inBox(noise);
    camera.rotation = turnedBy(noise, rng, camera.rotation);
    for (double* x : {&camera.left, &camera.right, &camera.bottom, &camera.top, &camera.near})
        *x *= 1 + rng.uniform(-noise, noise);
    camera.jitterNdc = {rng.uniform(-1, 1) / camera.width, rng.uniform(-1, 1) / camera.height};
    return camera;
}

TEST(HeldView, StaysAsItIsForUsualCamerasUnderNoiseAndJitter)
{
    int tried = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        const test::Camera camera = usualCamera(rng);
        const double gridStep = rng.logUniform(0.05, 5);
        const auto one = heldView(test::lixelView(camera), gridStep),
                   two = heldView(test::lixelView(perturbed(camera, rng, 1e-9)), gridStep);
        ASSERT_EQ(one.has_value(), two.has_value());
        if (!one) return;
        ++tried;
        EXPECT_LE(largestDifference(*one, *two), 1e-12);
    });
    EXPECT_GT(tried, test::scaled(test::kCases) / 2);
}

// A move by a part p of a step crosses one of three borders with the probability 1.5 p, the mean sum of a unit vector's coordinates. A
// turn about any axis changes pitch by half of it in the mean, yaw and roll by half of it over the cosine of pitch, which is above 0.68.
TEST(HeldView, ChangesNoMoreOftenThanStepsAreCrossed)
{
    constexpr double kPart = 1e-3;
    int moves = 0, turns = 0, tried = 0;
    const int cases = 10 * test::kCases;
    forEachCase(cases, [&](Rng& rng) {
        const test::Camera camera = test::anyCamera(rng, test::Lens::Perspective, false, rng.inBox(10), 10);
        const double gridStep = rng.logUniform(0.05, 5);
        const auto held = heldView(test::lixelView(camera), gridStep);
        if (!held) return;
        ++tried;
        const auto isChanged = [&](const test::Camera& other) {
            const auto now = heldView(test::lixelView(other), gridStep);
            return !now || largestDifference(*held, *now) > 1e-9;
        };
        test::Camera moved = camera, turned = camera;
        moved.eyeWorld = moved.eyeWorld + kPart * gridStep * rng.onSphere();
        turned.rotation = turnedBy(kPart / 14, rng, turned.rotation);
        moves += isChanged(moved), turns += isChanged(turned);
    });
    EXPECT_GT(tried, test::scaled(cases) / 2);
    const double noise = 4 * std::sqrt(2 * kPart * tried); // four standard deviations
    EXPECT_LE(moves, 1.5 * kPart * tried + noise);
    EXPECT_LE(turns, 2 * kPart * tried + noise);
}

TEST(HeldView, DoesNotChangeWithinAStep)
{
    const auto one = heldView(viewFrom({10.001, 1.7, 3.002}, 1.0, 0.1), 0.5),
               two = heldView(viewFrom({10.1, 1.71, 3.05}, 1.002, 0.101), 0.5);
    ASSERT_TRUE(one && two);
    EXPECT_EQ(clipFromWorld(*one), clipFromWorld(*two));
}

TEST(HeldView, OfAPictureOffCentreChangesWithJitterAtMostOnceInSixteenths)
{
    int changes = 0, tried = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        test::Camera camera = test::anyCamera(rng, test::Lens::OffCentre, false, rng.inBox(10), 10);
        camera.width = camera.height = 1024;
        const auto one = heldView(test::lixelView(camera), 0.5);
        camera.jitterNdc = {rng.uniform(-1, 1) / camera.width, rng.uniform(-1, 1) / camera.height};
        const auto two = heldView(test::lixelView(camera), 0.5);
        if (!one || !two) return;
        ++tried;
        changes += largestDifference(*one, *two) > 1e-9;
    });
    EXPECT_GT(tried, test::scaled(test::kCases) / 4);
    EXPECT_LE(changes, tried / 16);
}

// The whole of a plan, of which the held view is a part.
TEST(HeldMap, StaysWhereItIsForUsualCamerasUnderNoiseAndJitter)
{
    int tried = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        RandomSetup setup = ordinarySetup(rng);
        test::Camera camera = usualCamera(rng);
        camera.eyeWorld = setup.view.anchorWorld;
        setup.view = test::lixelView(camera);
        const FramePlan first = planOf(setup, "lispsm(stable)");
        setup.view = test::lixelView(perturbed(camera, rng, 1e-9));
        const FramePlan second = planOf(setup, "lispsm(stable)");
        ASSERT_EQ(first.lights[0].regions.size(), second.lights[0].regions.size());
        if (first.lights[0].regions.empty()) return;
        ++tried;
        for (int k = 0; k < 3; ++k) {
            const Vec3d p = setup.boxesWorld[0].centre() + rng.inBox(5);
            const Vec2d by = lixelOf(second, 0, p) - lixelOf(first, 0, p);
            EXPECT_LT(length(by), 1e-6 * (1 + length(lixelOf(first, 0, p))));
        }
    });
    EXPECT_GT(tried, test::scaled(test::kCases) / 4);
}

} // namespace
} // namespace lixel
