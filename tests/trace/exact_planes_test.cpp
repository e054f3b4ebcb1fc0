// SPDX-License-Identifier: MIT
// A lixel for every pixel, seen through the CPU executor: on planes whose lixels are their pixels shadows are exact.
#include "lixel/plan/technique.h"
#include "lixel/trace/exact_visibility.h"
#include "lixel/trace/plane_probe.h"
#include "lixel/trace/trace_executor.h"
#include "lixel/trace/trace_view_samples.h"
#include "trace/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace lixel {
namespace {

using namespace lixel::test;

constexpr int kSide = 128; // of the picture, pixels

// A body that stands on a floor, a wall behind them, and a table, turned and moved as a whole.
struct Room
{
    explicit Room(Rng& rng)
        : roomToWorld(translation(rng.inBox(rng.chance(0.5) ? 100 : 0)) * anyRotation(rng)),
          originWorld(xyz(roomToWorld * point({0, 0.5, 1}))),
          casters(triangles(placed(roomToWorld, furnished(rng)), originWorld)),
          scene(casters, {}, {})
    {
        const auto at = [&](Vec3d p) { return xyz(roomToWorld * point(p)); };
        const auto along = [&](Vec3d d) { return xyz(roomToWorld * direction(d)); };
        planes = {
            NamedPlane{"floor", at({0, 0, 0}), along({0, 1, 0}), {}},
            NamedPlane{"wall", at({0, 0, -1.5}), along({0, 0, 1}), {}},
            NamedPlane{"table",
                       at({-0.9, 0.4, 0}),
                       along({0, 1, 0}),
                       {at({-1.2, 0.4, -0.5}), at({-1.2, 0.4, 0.3}), at({-0.6, 0.4, 0.3}), at({-0.6, 0.4, -0.5})}}};
        for (const Vec3f& p : casters.positionLocal) extent.include(toDouble(p) + originWorld);
        const Vec3d eye = at({rng.uniform(-1, 1), rng.uniform(0.3, 2), rng.uniform(1.5, 3)});
        view = perspectiveView(eye, at({rng.uniform(-0.5, 0.5), 0.2, -0.4}), along({0, 1, 0}), 0.9, 0.05, 50, kSide,
                               kSide);
        const Vec3d from{rng.uniform(-2, 2), rng.uniform(0.6, 3), rng.uniform(-1, 3)};
        light.kind = LightKind(rng.integer(0, 2));
        light.positionWorld = at(from);
        light.directionWorld = along(normalized(-from));
        light.coneAngle = 1.2;
    }

    static Shape furnished(Rng& rng)
    {
        Shape room = joined(gridPlane(5, 3), box({-3, -0.2, -1.7}, {3, 2, -1.5}));
        room = joined(room, box({-1.2, 0.37, -0.5}, {-0.6, 0.4, 0.3}));
        room = joined(room, box({-1.15, -0.01, -0.45}, {-1.1, 0.39, -0.4}));
        room = joined(room, placed(translation({-0.9, 0.5, -0.1}), sphere(24, 12, 0.1001)));
        const double radius = rng.uniform(0.1, 0.3);
        room = joined(room, placed(translation({rng.uniform(-0.4, 0.4), radius - 1e-4, -0.3}), sphere(32, 16, radius)));
        return joined(room, box({0.5, -0.001, -0.8}, {0.8, rng.uniform(0.1, 0.8), -0.5}, 2));
    }

    FramePlan plan(const ViewSamples& samples, LixelSize lixels) const
    {
        const auto technique =
            parseTechnique("planes(table,floor,wall)+plane-optimal+else(cube)+allocation=exact").value();
        PlanInput input{view, {&light, 1}, {&extent, 1}, originWorld, std::get<MapTechnique>(technique), lixels};
        input.planes = planes;
        input.seen = &samples;
        input.seenIsAll = true;
        return planShadows(input);
    }

    Mat4d roomToWorld;
    Vec3d originWorld;
    LocalTriangles casters;
    TraceScene scene;
    std::array<NamedPlane, 3> planes;
    Box extent;
    View view;
    Light light;
};

bool isOn(const NamedPlane& plane, const ViewSamples& samples, std::size_t i)
{
    const Vec3d p = toDouble(samples.positionLocal[i]) + samples.originWorld - plane.pointWorld;
    return std::abs(dot(plane.normalWorld, p)) < 1e-6 && dot(plane.normalWorld, toDouble(samples.normal[i])) > 1 - 1e-6;
}

// A sample on a caster's edge but for the rounding of its position: 1e-4 lixel to one side it is lit, to the other it is not.
bool isOnEdge(const Room& room, const FramePlan& plan, std::size_t region, const ViewSamples& samples, std::size_t i)
{
    const PlaneProbe probe = probeOnPlane(room.scene, plan, 0, region, room.light, samples, i, 1e-4);
    return std::ranges::count(probe.exactBeside, probe.exactBeside.front()) < std::ssize(probe.exactBeside);
}

TEST(ExactPlanes, ShadowsOnThemAreExactAndTheirOwnMapsServeThem)
{
    std::size_t counted = 0, shadowed = 0, onEdge = 0;
    forEachCase(40, [&](Rng& rng) {
        std::size_t wrong = 0;
        const Room room(rng);
        const ViewSamples samples = traceViewSamples(room.scene, room.view);
        const FramePlan plan = room.plan(samples, {512, 512});
        ASSERT_FALSE(plan.lights[0].refused);
        const std::vector<float> exact = exactVisibility(room.scene, samples, room.light);
        const Visibility visibility = runTraced(room.scene, plan, samples).front();
        const std::vector<PlannedRegion>& regions = plan.lights[0].regions;
        for (std::size_t r = 0; r < regions.size(); ++r) {
            if (regions[r].plane < 0) continue;
            const LightImage image(regions[r].lightClipFromLocal, regions[r].rectangle);
            for (std::size_t i = 0; i < samples.size(); ++i) {
                const Vec3d p = toDouble(samples.positionLocal[i]);
                if (!isOn(room.planes[std::size_t(regions[r].plane)], samples, i) ||
                    !isLightFacing(room.light, room.originWorld, p, toDouble(samples.normal[i])))
                    continue;
                const auto lixel = image.lixelAt(p);
                ASSERT_TRUE(lixel);
                EXPECT_NEAR(lixel->x, std::floor(lixel->x) + 0.5, 0.01);
                EXPECT_NEAR(lixel->y, std::floor(lixel->y) + 0.5, 0.01);
                ++counted;
                shadowed += exact[i] < 0.5f;
                if (exact[i] == visibility.value[i]) continue;
                if (isOnEdge(room, plan, r, samples, i)) ++onEdge;
                else ++wrong;
            }
        }
        EXPECT_EQ(wrong, 0u);
    });
    std::printf("%zu samples, %zu in shadow, %zu wrong on a caster's edge\n", counted, shadowed, onEdge);
    EXPECT_LE(onEdge, 1 + counted / 1'000'000);
    EXPECT_GT(counted, 100000u);
    EXPECT_GT(shadowed, 5000u);
}

TEST(ExactPlanes, AProbeALixelAsideSaysWhatTheNextPixelDoes)
{
    std::size_t edges = 0, quiet = 0;
    forEachCase(10, [&](Rng& rng) {
        const Room room(rng);
        const ViewSamples samples = traceViewSamples(room.scene, room.view);
        const FramePlan plan = room.plan(samples, {512, 512});
        const std::vector<float> exact = exactVisibility(room.scene, samples, room.light);
        for (std::size_t r = 0; r < plan.lights[0].regions.size(); ++r) {
            if (plan.lights[0].regions[r].plane != 0) continue;
            for (std::size_t i = 0; i + 1 < samples.size(); i += 3) {
                if (!isOn(room.planes[0], samples, i) || !isOn(room.planes[0], samples, i + 1)) continue;
                if (samples.pixel[i + 1].x != samples.pixel[i].x + 1) continue;
                if (samples.triangle[i + 1] != samples.triangle[i]) continue; // rays start on their own triangle
                const Vec3d p = toDouble(samples.positionLocal[i]), n = toDouble(samples.normal[i]);
                if (!isLightFacing(room.light, room.originWorld, p, n)) continue;
                const PlaneProbe probe = probeOnPlane(room.scene, plan, 0, r, room.light, samples, i, 1);
                ASSERT_EQ(probe.exactBeside.size(), 4u);
                EXPECT_EQ(probe.exactBeside[0], exact[i + 1]); // a lixel to the right is a pixel to the right
                edges += exact[i] != exact[i + 1];
                quiet += exact[i] == exact[i + 1];
            }
        }
    });
    EXPECT_GT(edges, 20u);
    EXPECT_GT(quiet, 2000u);
}

TEST(ExactPlanes, ThePlanesTakeWhatTheyNeedTheOthersTheRestAndNeverMoreThanTheBudget)
{
    int refused = 0, planned = 0;
    forEachCase(kCases, [&](Rng& rng) {
        const Room room(rng);
        const ViewSamples samples = traceViewSamples(room.scene, room.view);
        const LixelSize budget{rng.integer(40, 400), rng.integer(40, 400)};
        const FramePlan plan = room.plan(samples, budget);
        const FramePlan generous = room.plan(samples, {2000, 2000});
        std::int64_t needed = 0;
        for (const PlannedRegion& region : generous.lights[0].regions) {
            const std::int64_t lixels = std::int64_t(region.rectangle.width()) * region.rectangle.height();
            needed += region.pixels ? lixels : 1;
        }
        const std::int64_t most = std::int64_t(budget.width) * budget.height;
        if (needed > most) {
            EXPECT_EQ(plan.lights[0].refused, FitFailure::TooFewLixels);
            ++refused;
            return;
        }
        ASSERT_FALSE(plan.lights[0].refused);
        ++planned;
        EXPECT_LE(plan.lixelsOf(0), most);
        for (std::size_t i = 0; i < plan.lights[0].regions.size(); ++i) {
            const PlannedRegion &a = plan.lights[0].regions[i], &b = generous.lights[0].regions[i];
            ASSERT_EQ(a.pixels, b.pixels);
            if (!a.pixels) continue;
            EXPECT_EQ(a.rectangle.width(), b.rectangle.width());
            EXPECT_EQ(a.rectangle.height(), b.rectangle.height());
        }
    });
    EXPECT_GT(refused, 5);
    EXPECT_GT(planned, 5);
}

} // namespace
} // namespace lixel
