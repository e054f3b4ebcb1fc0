// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/minimal_frustum.h"

#include "lixel/base/convex.h"
#include "lixel/plan/fit/focused.h"
#include "lixel/plan/fit/visible_body.h"
#include "plan/ordinary_setups.h"

#include <gtest/gtest.h>

#include <limits>

namespace lixel {
namespace {

using test::forEachCase;
using test::inputOf;
using test::ordinarySetup;
using test::RandomSetup;
using test::Rng;

// Distances from the light, or along its direction.
double depthOf(const RandomSetup& setup, const Fit& fit, Vec3d pointLocal)
{
    if (setup.light.kind == LightKind::Directional) return dot(setup.light.directionWorld, pointLocal);
    return dot(fit.lightClipFromLocal.row(3), point(pointLocal));
}

// Where the middle of the map has this NDC depth.
double depthAt(const RandomSetup& setup, const Fit& fit, double ndcZ)
{
    const Mat4d localFromClip = inverse(fit.lightClipFromLocal).value();
    const Vec4d p = localFromClip * Vec4d{0, 0, ndcZ, 1};
    return depthOf(setup, fit, (1 / p.w) * xyz(p));
}

// The least depth of what the boxes have within the map's sides, moved outwards by `slack`, and before `farDepth`: every box as a
// body cut face by face.
double nearestCasterWithin(const RandomSetup& setup, const Fit& fit, double farDepth, double slack)
{
    const Mat4d& clip_ = fit.lightClipFromLocal;
    const Vec4d x = clip_.row(0), y = clip_.row(1), w = clip_.row(3);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Box& boxWorld : setup.boxesWorld) {
        ConvexBody body = bodyOf(translated(boxWorld, -setup.originWorld));
        for (const Vec4d& side : {w + x, w - x, w + y, w - y}) {
            const double size = length(xyz(side));
            clip(body, {(1 / size) * xyz(side), side.w / size + slack});
        }
        for (const auto& face : body.faces)
            for (const Vec3d& p : face) nearest = std::min(nearest, depthOf(setup, fit, p));
    }
    return std::min(nearest, farDepth);
}

// What rounding of floats has as room: little of the depths between near and far and of the scene, but depths that are all but one
// get a span.
double roomOf(const RandomSetup& setup, double span)
{
    return 1e-5 * span + 1e-5 * setup.radius + std::max(0.0, 2e-3 * setup.radius - span);
}

TEST(MinimalFrustum, ItsNearSideTouchesTheNearestCasterThatMattersAndItsFarSideTheFarthestReceiver)
{
    int tried = 0, nearerInFocused = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        const RandomSetup setup = ordinarySetup(rng);
        const FitInput input = inputOf(setup);
        const FitResult fit = fitMinimalFrustum(input);
        if (!fit) return;
        ++tried;
        std::vector<Vec3d> visible;
        findVisiblePoints(input, visible);
        double farthest = -std::numeric_limits<double>::infinity();
        for (const Vec3d& p : visible) farthest = std::max(farthest, depthOf(setup, *fit, p));

        // A caster that only touches a side may count or not.
        const double slack = 1e-6 * setup.radius;
        const bool isParallel = setup.light.kind == LightKind::Directional;
        const double least =
            isParallel ? -std::numeric_limits<double>::infinity() : 1e-4 * farthest; // others are clamped
        const double inside = std::max(least, nearestCasterWithin(setup, *fit, farthest, -slack)),
                     touching = std::max(least, nearestCasterWithin(setup, *fit, farthest, slack));
        const double near = depthAt(setup, *fit, -1), far = depthAt(setup, *fit, 1),
                     room = roomOf(setup, farthest - inside);
        EXPECT_LE(near, inside + 1e-9 * setup.radius);
        EXPECT_GE(near, touching - room);
        EXPECT_GE(far, farthest - 1e-9 * setup.radius);
        EXPECT_LE(far, farthest + room);
        const FitResult focused = fitFocused(input);
        ASSERT_TRUE(focused);
        nearerInFocused += depthAt(setup, *focused, -1) < near - room;
    });
    EXPECT_GT(tried, test::scaled(test::kCases) / 2);
    EXPECT_GT(nearerInFocused, tried / 4); // else it would say nothing that focused does not
}

TEST(MinimalFrustum, AcrossTheLightIsFocused)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const RandomSetup setup = ordinarySetup(rng);
        const FitResult fit = fitMinimalFrustum(inputOf(setup)), focused = fitFocused(inputOf(setup));
        ASSERT_EQ(fit.hasValue(), focused.hasValue());
        if (!fit) return;
        for (const int row : {0, 1, 3})
            EXPECT_EQ(fit->lightClipFromLocal.row(row), focused->lightClipFromLocal.row(row));
    });
}

} // namespace
} // namespace lixel
