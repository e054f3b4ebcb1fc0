// SPDX-License-Identifier: MIT
#include "lixel/base/convex.h"

#include "lixel/base/view.h"
#include "support/random_cases.h"

#include <gtest/gtest.h>

#include <vector>

namespace lixel {
namespace {

using test::forEachCase;
using test::Rng;

Box anyBox(Rng& rng)
{
    Box box;
    const Vec3d centre = rng.inBox(5);
    const Vec3d half{rng.logUniform(0.01, 10), rng.logUniform(0.01, 10), rng.logUniform(0.01, 10)};
    box.include(centre - half);
    box.include(centre + half);
    return box;
}

Plane anyPlaneNear(const Box& box, Rng& rng)
{
    const Vec3d through{rng.uniform(box.min.x, box.max.x), rng.uniform(box.min.y, box.max.y),
                        rng.uniform(box.min.z, box.max.z)};
    return planeThrough(through, rng.onSphere());
}

// Signed volume over all faces, from the origin: exact for closed bodies with outward faces.
double volume(const ConvexBody& body)
{
    double sum = 0;
    for (const auto& face : body.faces)
        for (std::size_t i = 2; i < face.size(); ++i) sum += dot(face[0], cross(face[i - 1], face[i])) / 6;
    return sum;
}

TEST(ConvexBody, TheTwoSidesOfACutHaveTheVolumeOfTheWhole)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const Box box = anyBox(rng);
        ConvexBody body = bodyOf(box);
        for (int i = rng.integer(0, 4); i > 0; --i) clip(body, anyPlaneNear(box, rng));
        const Plane plane = anyPlaneNear(box, rng);
        ConvexBody one = body, other = body;
        clip(one, plane);
        clip(other, {-plane.normal, -plane.offset});
        const double whole = volume(bodyOf(box));
        EXPECT_NEAR(volume(one) + volume(other), volume(body), 1e-9 * whole);
    });
}

TEST(ConvexBody, NoCornerIsCutOffOrLeftOver)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const Box box = anyBox(rng);
        const Plane plane = anyPlaneNear(box, rng);
        ConvexBody body = bodyOf(box);
        clip(body, plane);
        std::vector<Vec3d> points;
        for (const auto& face : body.faces) points.insert(points.end(), face.begin(), face.end());
        for (const Vec3d& p : points) EXPECT_GE(plane.signedDistance(p), -1e-12 * (1 + box.diagonal()));
        for (const Vec3d& corner : box.corners()) {
            if (plane.signedDistance(corner) < 0) continue;
            bool found = false;
            for (const Vec3d& p : points) found |= p == corner;
            EXPECT_TRUE(found);
        }
    });
}

TEST(ConvexBody, AHalfSpaceThatHoldsAllChangesNothingAndOneThatHoldsNothingEmptiesIt)
{
    ConvexBody body = bodyOf({{-1, -1, -1}, {1, 1, 1}});
    clip(body, planeThrough({0, -2, 0}, {0, 1, 0}));
    EXPECT_EQ(body.faces.size(), 6u);
    clip(body, planeThrough({0, 2, 0}, {0, 1, 0}));
    EXPECT_TRUE(body.isEmpty());
}

TEST(ClipPlanes, HoldExactlyThePointsInsideTheClipVolume)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const Vec3d eye = rng.inBox(10);
        const double near = rng.logUniform(1e-3, 1);
        const bool infinite = rng.chance(0.3), orthographic = !infinite && rng.chance(0.3);
        const double far = infinite ? INFINITY : near * rng.logUniform(2, 1e4);
        const Vec3d target = eye + rng.onSphere(), up = rng.onSphere();
        const View view = orthographic ? orthographicView(eye, target, up, rng.logUniform(0.1, 10), near, far, 640, 480)
                                       : perspectiveView(eye, target, up, rng.uniform(0.1, 2.5), near, far, 640, 480);
        const auto planes = clipPlanes(clipFromWorld(view));
        EXPECT_EQ(planes.size(), infinite ? 5u : 6u);
        for (int i = 0; i < 20; ++i) {
            const Vec3d p = eye + rng.logUniform(1e-3, 100) * rng.onSphere();
            const Vec4d c = clipFromWorld(view) * point(p);
            const double slack = 1e-9 * std::abs(c.w);
            bool inside = true, clearly = true;
            for (const double value : {c.x, c.y, c.z})
                inside &= std::abs(value) <= c.w, clearly &= std::abs(std::abs(value) - std::abs(c.w)) > slack;
            bool insidePlanes = true;
            for (const Plane& plane : planes) insidePlanes &= plane.signedDistance(p) >= 0;
            if (clearly) {
                EXPECT_EQ(inside, insidePlanes);
            }
        }
    });
}

} // namespace
} // namespace lixel
