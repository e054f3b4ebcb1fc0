// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/stable.h"

#include "lixel/plan/shadow_plan.h"
#include "plan/host_cameras.h"
#include "plan/ordinary_setups.h"
#include "plan/receivers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lixel {
namespace {

using test::forEachCase;
using test::ordinarySetup;
using test::planOf;
using test::RandomSetup;
using test::Rng;

View viewFrom(Vec3d eye, double yaw, double pitch)
{
    const Vec3d forward{std::cos(pitch) * std::cos(yaw), std::sin(pitch), std::cos(pitch) * std::sin(yaw)};
    return perspectiveView(eye, eye + forward, {0, 1, 0}, 1, 0.1, 20, 640, 480);
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

TEST_P(Crawl, MovingAndTurningTheCameraMovesTheMapByWholeLixels)
{
    int tried = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        RandomSetup setup = ordinarySetup(rng);
        const Vec3d eye = setup.view.anchorWorld;
        setup.view = viewFrom(eye, rng.uniform(0, 6), rng.uniform(-0.3, 0.3));
        const FramePlan first = planOf(setup, GetParam());
        const Vec3d moved = eye + rng.inBox(0.02 * setup.radius);
        setup.view = viewFrom({moved.x, eye.y, moved.z}, rng.uniform(0, 6), rng.uniform(-0.3, 0.3));
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
                EXPECT_NEAR(by.x, std::round(by.x), 1e-5);
                EXPECT_NEAR(by.y, std::round(by.y), 1e-5);
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

TEST(HeldView, DoesNotChangeWithinAStep)
{
    const auto one = heldView(viewFrom({10.001, 1.7, 3.002}, 1.0, 0.1), 0.5),
               two = heldView(viewFrom({10.1, 1.71, 3.05}, 1.002, 0.101), 0.5);
    ASSERT_TRUE(one && two);
    EXPECT_EQ(clipFromWorld(*one), clipFromWorld(*two));
}

} // namespace
} // namespace lixel
