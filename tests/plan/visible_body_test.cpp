// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/visible_body.h"

#include "lixel/base/convex.h"
#include "support/random_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace lixel {
namespace {

using test::forEachCase;
using test::Rng;

double farthestAlong(Vec3d towards, const std::vector<Vec3d>& points)
{
    double farthest = -std::numeric_limits<double>::infinity();
    for (const Vec3d& p : points) farthest = std::max(farthest, dot(towards, p));
    return farthest;
}

// Corners by incidence of planes against faces cut one by one: both span the same body.
TEST(ClippedBox, HasTheCornersOfTheBodyThatFacesGive)
{
    forEachCase(test::kCases, [](Rng& rng) {
        Box box;
        box.include(rng.inBox(1));
        box.include(rng.chance(0.1) ? Vec3d{rng.uniform(-1, 1), box.min.y, rng.uniform(-1, 1)} : rng.inBox(1));
        std::vector<Plane> planes;
        for (int i = rng.integer(0, 14); i > 0; --i) {
            const Vec3d through = rng.chance(0.2) ? box.corners()[std::size_t(rng.integer(0, 7))] : rng.inBox(1);
            planes.push_back(planeThrough(through - 0.3 * rng.onSphere(), rng.onSphere()));
        }
        std::vector<Vec3d> points, expected;
        appendClippedBox(box, planes, points);
        ConvexBody body = bodyOf(box);
        for (const Plane& plane : planes) clip(body, plane);
        for (const auto& face : body.faces) expected.insert(expected.end(), face.begin(), face.end());
        if (points.empty() || expected.empty()) { // one way nothing, the other way next to nothing
            const std::vector<Vec3d>& left = points.empty() ? expected : points;
            double thickness = left.empty() ? 0 : box.max.y - box.min.y;
            for (const Plane& plane : planes)
                if (!left.empty())
                    thickness =
                        std::min(thickness, farthestAlong(plane.normal, left) + farthestAlong(-plane.normal, left));
            EXPECT_LT(thickness, 1e-9);
            return;
        }
        for (int i = 0; i < 30; ++i) {
            const Vec3d towards = rng.onSphere();
            EXPECT_NEAR(farthestAlong(towards, points), farthestAlong(towards, expected), 1e-9);
        }
    });
}

// As at a light: sides of its cone, of a cube's face and of a region meet there, and rounding decides what they leave of each other.
TEST(ClippedBox, OfManyPlanesThroughOnePointIsWhatEveryPlaneKeeps)
{
    forEachCase(10 * test::kCases, [](Rng& rng) {
        Box box;
        box.include(rng.inBox(1));
        box.include(rng.inBox(1));
        const Vec3d axis = rng.onSphere();
        const Vec3d apex = rng.chance(0.3) ? box.corners()[std::size_t(rng.integer(0, 7))]
                                           : Vec3d{rng.uniform(box.min.x, box.max.x), rng.uniform(box.min.y, box.max.y),
                                                   rng.uniform(box.min.z, box.max.z)};
        const double opening = rng.uniform(0.05, 1);
        std::vector<Plane> planes;
        for (int i = rng.integer(8, 26); i > 0; --i)
            planes.push_back(planeThrough(apex, normalized(opening * axis + rng.onSphere())));
        std::vector<Vec3d> points;
        appendClippedBox(box, planes, points);
        for (const Vec3d& p : points)
            for (const Plane& plane : planes) EXPECT_GT(plane.signedDistance(p), -1e-9);
        if (!points.empty()) { // none of them cuts off the apex, of which alone rounding may leave nothing
            EXPECT_GT(farthestAlong(axis, points), dot(axis, apex) - 1e-12);
        }
    });
}

TEST(ClippedBox, HoldsThePointsOfTheBoxThatEveryPlaneKeeps)
{
    forEachCase(test::kCases, [](Rng& rng) {
        Box box;
        box.include(rng.inBox(1));
        box.include(rng.inBox(1));
        std::vector<Plane> planes;
        for (int i = rng.integer(0, 10); i > 0; --i) planes.push_back(planeThrough(rng.inBox(1), rng.onSphere()));
        std::vector<Vec3d> points;
        appendClippedBox(box, planes, points);
        for (int i = 0; i < 20; ++i) {
            const Vec3d p{rng.uniform(box.min.x, box.max.x), rng.uniform(box.min.y, box.max.y),
                          rng.uniform(box.min.z, box.max.z)};
            if (std::any_of(planes.begin(), planes.end(),
                            [&](const Plane& plane) { return plane.signedDistance(p) < 0; }))
                continue;
            const Vec3d towards = rng.onSphere();
            EXPECT_GE(farthestAlong(towards, points), dot(towards, p) - 1e-12);
        }
    });
}

} // namespace
} // namespace lixel
