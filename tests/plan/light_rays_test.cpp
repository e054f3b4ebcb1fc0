// SPDX-License-Identifier: MIT
// Sets of light rays against brute force over directions: what is taken away, what is left, and what a map is cut to.
#include "lixel/plan/light_rays.h"

#include "lixel/plan/fit/focused.h"
#include "lixel/plan/fit/visible_body.h"
#include "plan/planed_setups.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lixel {
namespace {

using test::forEachCase;
using test::kCases;
using test::RandomSetup;
using test::Rng;

bool isIn(const RayPolygon& polygon, Vec3d ray, double room)
{
    if (polygon.size() < 3) return false;
    Vec3d middle;
    for (const Vec3d& corner : polygon) middle = middle + corner;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d side = normalized(cross(polygon[i], polygon[(i + 1) % polygon.size()]));
        const double inside = dot(side, middle) < 0 ? -dot(side, ray) : dot(side, ray);
        if (inside < -room * length(ray)) return false;
    }
    return true;
}

int countIn(std::span<const RayPolygon> rays, Vec3d ray, double room)
{
    return int(std::count_if(rays.begin(), rays.end(), [&](const RayPolygon& p) { return isIn(p, ray, room); }));
}

RayPolygon anyPolygon(Rng& rng)
{
    const Vec3d axis = rng.onSphere(), u = anyPerpendicular(axis), v = cross(axis, u);
    const double size = rng.logUniform(1e-2, 3);
    const int corners = rng.integer(3, 12);
    RayPolygon out;
    for (int i = 0; i < corners; ++i) {
        const double angle = 6.283185307179586 * (i + 0.5) / corners;
        const double scale = rng.logUniform(0.1, 10); // rays of any length
        out.push_back(scale * (axis + size * std::cos(angle) * u + size * std::sin(angle) * v));
    }
    return out;
}

Vec3d anyRayIn(const RayPolygon& polygon, Rng& rng)
{
    Vec3d ray;
    for (const Vec3d& corner : polygon) ray = ray + rng.uniform(0, 1) * normalized(corner);
    return normalized(ray);
}

bool areAllInside(std::span<const Vec3d> insides, Vec3d ray, double room)
{
    return std::all_of(insides.begin(), insides.end(),
                       [&](Vec3d n) { return dot(n, ray) >= room * length(n) * length(ray); });
}

TEST(LightRays, WhatIsLeftIsWhatNoRegionHolds)
{
    std::size_t left = 0, taken = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        const RayPolygon whole = anyPolygon(rng);
        std::vector<RayPolygon> rays{whole}, room;
        if (rng.chance(0.2)) { // the whole sphere
            rays.clear();
            for (const double x : {1.0, -1.0})
                for (const double y : {1.0, -1.0})
                    for (const double z : {1.0, -1.0}) rays.push_back({Vec3d{x, 0, 0}, Vec3d{0, y, 0}, Vec3d{0, 0, z}});
        }
        const std::vector<RayPolygon> before = rays;
        std::vector<std::vector<Vec3d>> regions(std::size_t(rng.integer(1, 4)));
        for (auto& region : regions) {
            const Vec3d in = anyRayIn(whole, rng);
            for (int i = rng.integer(1, 6); i > 0; --i) {
                const Vec3d n = rng.onSphere() + rng.uniform(-0.2, 0.6) * in;
                region.push_back(rng.logUniform(1e-3, 1e3) * n);
            }
            subtract(rays, region, room);
        }
        for (int i = 0; i < 50; ++i) {
            const Vec3d ray = rng.chance(0.3)
                                  ? rng.onSphere()
                                  : anyRayIn(before[std::size_t(rng.integer(0, int(before.size()) - 1))], rng);
            // Rays next to a border may go either way.
            const auto isTaken = [&](double margin) {
                return std::any_of(regions.begin(), regions.end(),
                                   [&](const auto& region) { return areAllInside(region, ray, margin); });
            };
            if (isTaken(-1e-9) != isTaken(1e-9) || countIn(before, ray, 1e-9) != countIn(before, ray, -1e-9)) continue;
            const bool isLeft = countIn(before, ray, 0) > 0 && !isTaken(0);
            EXPECT_EQ(countIn(rays, ray, 1e-9) > 0, isLeft);
            EXPECT_LE(countIn(rays, ray, -1e-9), 1) << "pieces overlap";
            ++(isLeft ? left : taken);
        }
    });
    EXPECT_GT(left, std::size_t(test::scaled(10000)));
    EXPECT_GT(taken, std::size_t(test::scaled(10000)));
}

TEST(LightRays, OfPointsAllRoundTheLightAreTheWholeSphereElseOnePolygonAroundAll)
{
    int whole = 0, one = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        const RandomSetup setup = test::anySetup(rng);
        FitInput input = test::inputOf(setup);
        const RaySpace space(setup.light, setup.originWorld);
        std::vector<Vec3d> points;
        const Vec3d light = setup.light.positionWorld - setup.originWorld;
        const bool isAround = rng.chance(0.3);
        for (int i = rng.integer(1, 60); i > 0; --i)
            points.push_back(isAround ? light + setup.radius * rng.uniform(0.1, 1) * rng.onSphere()
                                      : setup.radius * rng.inBox(1));
        std::vector<RayPolygon> rays;
        raysThrough(input, space, points, rays);
        ++(rays.size() == 1 ? one : whole);
        EXPECT_TRUE(rays.size() == 1 || rays.size() == 8);
        for (const Vec3d& p : points) {
            const Vec3d ray = space.through(p);
            EXPECT_GT(countIn(rays, ray, 1e-7), 0);
        }
    });
    EXPECT_GT(whole, test::scaled(100));
    EXPECT_GT(one, test::scaled(1000));
}

// How many of one fit's square the other's has room for, both images of one light and with the same w: areas go with one over the
// determinant of rows x, y and w, of parallel light with that of x and y across the light.
double areaWithin(const Fit& fit, const Fit& square)
{
    const auto determinant = [](const Mat4d& clip) {
        const Vec3d across = cross(xyz(clip.row(0)), xyz(clip.row(1))), w = xyz(clip.row(3));
        return length(w) > 0 ? std::abs(dot(across, w)) : length(across);
    };
    return determinant(square.lightClipFromLocal) / determinant(fit.lightClipFromLocal);
}

TEST(LightRays, AMapCutToSomeRaysHoldsThemAllAndNeverGrows)
{
    int smaller = 0, missed = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        RandomSetup setup = test::anySetup(rng);
        FitInput input = test::inputOf(setup);
        const FitResult fit = fitFocused(input);
        if (!fit) return;
        const RaySpace space(setup.light, setup.originWorld);
        std::vector<Vec3d> visible;
        findVisiblePoints(input, visible);
        std::vector<RayPolygon> rays, room;
        raysThrough(input, space, visible, rays);
        const Vec3d through = visible[std::size_t(rng.integer(0, int(visible.size()) - 1))];
        for (int i = rng.integer(1, 3); i > 0; --i) {
            const Vec3d along = towardsLight(setup.light, setup.originWorld, through);
            const Plane cut = planeThrough(through, normalized(cross(along, rng.onSphere())));
            const std::vector<Vec3d> insides{space.insideOf(cut)};
            subtract(rays, insides, room);
        }
        const auto cropped = croppedTo(*fit, space, rays, visible, input.scratch.plane);
        if (!cropped) {
            ++missed;
            return;
        }
        const double area = areaWithin(*cropped, *fit);
        EXPECT_LE(area, 1 + 1e-9);
        smaller += area < 0.9;
        for (const RayPolygon& polygon : rays)
            for (int i = 0; i < 5; ++i) {
                const Vec3d ray = rng.chance(0.5) ? anyRayIn(polygon, rng)
                                                  : polygon[std::size_t(rng.integer(0, int(polygon.size()) - 1))];
                const Vec4d q = fit->lightClipFromLocal * space.imageOf(ray),
                            c = cropped->lightClipFromLocal * space.imageOf(ray);
                if (!(q.w > 0) || std::max(std::abs(q.x), std::abs(q.y)) > (1 - 1e-6) * q.w)
                    continue; // no place in the fit itself
                EXPECT_LE(std::max(std::abs(c.x), std::abs(c.y)), (1 + 1e-6) * c.w);
            }
    });
    std::printf("%d smaller, %d missed\n", smaller, missed);
    EXPECT_GT(smaller, test::scaled(100));
}

// A floor and a wall that meet, with boxes on the floor: all visible points are gathered, the rays that come to the floor or the wall
// within the picture are taken out one by one, and the map of the rest is just around the others.
RandomSetup roomSetup(Rng& rng)
{
    RandomSetup setup;
    setup.radius = 10;
    setup.boxesWorld = {{{-10, -1, -10}, {10, 0, 10}}, {{-10, 0, -11}, {10, 8, -10}}};
    for (int i = rng.integer(0, 5); i > 0; --i) {
        const Vec3d at{rng.uniform(-6, 6), 0, rng.uniform(-6, 6)};
        setup.boxesWorld.push_back({at, at + Vec3d{1, rng.uniform(0.5, 3), 1}});
    }
    const Vec3d eye{rng.uniform(-5, 5), rng.uniform(1, 6), rng.uniform(2, 12)};
    setup.view = perspectiveView(eye, {rng.uniform(-4, 4), rng.uniform(0, 4), -8}, {0, 1, 0}, rng.uniform(0.4, 1.2),
                                 0.1, 100, 640, 480);
    setup.light.kind = LightKind(rng.integer(0, 2));
    setup.light.directionWorld = normalized({rng.uniform(-1, 1), -1, rng.uniform(-1.2, -0.2)});
    setup.light.positionWorld = -rng.logUniform(15, 1e7) * setup.light.directionWorld;
    setup.light.coneAngle = 2.5;
    setup.originWorld = {std::round(eye.x), std::round(eye.y), std::round(eye.z)};
    return setup;
}

TEST(LightRays, TheFallbackOfFloorAndWallIsTheLeastRectangleAroundAllOtherVisibleRays)
{
    int none = 0, some = 0, tight = 0;
    forEachCase(kCases, [&](Rng& rng) {
        const RandomSetup setup = roomSetup(rng);
        const std::vector<NamedPlane> planes{{"floor", {0, 0, 0}, {0, 1, 0}, {}}, {"wall", {0, 0, -10}, {0, 0, 1}, {}}};
        PlanInput planInput{setup.view,
                            {&setup.light, 1},
                            setup.boxesWorld,
                            setup.originWorld,
                            std::get<MapTechnique>(*parseTechnique("planes(floor,wall)")),
                            {512, 512}};
        planInput.planes = planes;
        const FramePlan plan = planShadows(planInput);
        ASSERT_FALSE(plan.lights[0].refused);
        const auto& regions = plan.lights[0].regions;
        const bool hasFallback = regions.back().plane < 0;
        if (regions.size() != (hasFallback ? 3u : 2u)) return; // a plane is left out

        // Brute force: many rays through the hull of what is visible, and which of them neither plane's picture has.
        FitInput input = test::inputOf(setup);
        std::vector<Vec3d> visible;
        findVisiblePoints(input, visible);
        const auto frameOf = [&](const NamedPlane& p) {
            return *planeOptimalFrame(setup.view, setup.light, setup.originWorld,
                                      planeThrough(p.pointWorld - setup.originWorld, p.normalWorld),
                                      setup.sceneLocal().diagonal());
        };
        const LightFrame floor = frameOf(planes[0]), wall = frameOf(planes[1]);
        const auto isInPicture = [&](const LightFrame& frame, Vec3d p) {
            const Vec4d q = frame.framedFromLocal * point(p);
            const double room = 1e-6 * setup.view.width * q.w; // corners of what is visible lie on its border
            return q.x >= -room && q.x <= setup.view.width * q.w + room && q.y >= -room &&
                   q.y <= setup.view.height * q.w + room;
        };
        const Vec4d l = setup.light.kind == LightKind::Directional
                            ? direction(-setup.light.directionWorld)
                            : point(setup.light.positionWorld - setup.originWorld);
        const auto along = [&](const NamedPlane& plane, Vec3d p) { // 0 at the plane, per distance of the light above it
            return dot(plane.normalWorld, p + setup.originWorld - plane.pointWorld) /
                   (dot(plane.normalWorld, xyz(l)) +
                    l.w * dot(plane.normalWorld, setup.originWorld - plane.pointWorld));
        };
        bool isAnyLeft = false;
        Vec2d low{1, 1}, high{-1, -1};
        for (int i = 0; i < 4000; ++i) {
            Vec3d p;
            double sum = 0;
            for (int k = rng.integer(0, 2); k < 3; ++k) {
                const double share = rng.uniform(0, 1);
                p = p + share * visible[std::size_t(rng.integer(0, int(visible.size()) - 1))];
                sum += share;
            }
            p = (1 / sum) * p;
            // The ray comes to the floor first where the floor's height along it is the lesser.
            const bool isFloorFirst = along(planes[0], p) < along(planes[1], p);
            if (isInPicture(isFloorFirst ? floor : wall, p)) continue;
            isAnyLeft = true;
            if (!hasFallback) break;
            const Vec4d c = regions.back().lightClipFromLocal * point(p);
            EXPECT_LE(std::abs(c.x), c.w * 1.0001);
            EXPECT_LE(std::abs(c.y), c.w * 1.0001);
            low = {std::min(low.x, c.x / c.w), std::min(low.y, c.y / c.w)};
            high = {std::max(high.x, c.x / c.w), std::max(high.y, c.y / c.w)};
        }
        if (!hasFallback) {
            EXPECT_FALSE(isAnyLeft);
            ++none;
            return;
        }
        ++some;
        if (!isAnyLeft) return; // too little for random rays
        tight += high.x - low.x > 1.8 && high.y - low.y > 1.8;
    });
    std::printf("%d without a fallback, %d with one, %d of them filled by random rays\n", none, some, tight);
    EXPECT_GT(some, test::scaled(100));
    EXPECT_GT(tight, some / 2);
}

} // namespace
} // namespace lixel
