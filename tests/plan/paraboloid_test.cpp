// SPDX-License-Identifier: MIT
// Maps on paraboloids: the fit, its light image, and what lookups make of it.
#include "lixel/plan/light_image.h"
#include "lixel/plan/partition/dual_paraboloid.h"
#include "plan/ordinary_setups.h"
#include "plan/receivers.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lixel {
namespace {

using test::forEachCase;
using test::planOf;
using test::RandomSetup;
using test::Rng;

RandomSetup anyLampSetup(Rng& rng)
{
    RandomSetup setup = test::anySetup(rng);
    setup.light.kind = rng.chance(0.7) ? LightKind::Point : LightKind::Spot;
    return setup;
}

Vec3d anyPoint(const RandomSetup& setup, Rng& rng)
{
    const Box& box = setup.boxesWorld[std::size_t(rng.integer(0, int(setup.boxesWorld.size()) - 1))];
    return Vec3d{rng.uniform(box.min.x, box.max.x), rng.uniform(box.min.y, box.max.y),
                 rng.uniform(box.min.z, box.max.z)} -
           setup.originWorld;
}

// Brabec et al. 2002, equation 2: the place is where the ray leaves a paraboloid that gathers the half sphere into one direction.
TEST(Paraboloid, RaysAndPlacesAreInverseInDoubleAndInTheTextOfShaders)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const Vec3d ray = rng.onSphere();
        if (ray.z < -0.9) return;
        const Vec2d place = onParaboloid(ray);
        EXPECT_LT(length(paraboloidRay(place) - ray), 1e-13);
        EXPECT_NEAR(place.x, ray.x / (1 + ray.z), 1e-13);
        EXPECT_EQ(length(place) <= 1, ray.z >= 0);
        const shared::vec3 q{float(ray.x), float(ray.y), float(ray.z)};
        const shared::vec2 at = shared::lxOnParaboloid(q);
        EXPECT_NEAR(at.x, place.x, 1e-5);
        EXPECT_NEAR(at.y, place.y, 1e-5);
        EXPECT_LT(shared::length(shared::lxParaboloidRay(at) - q), 1e-6f);
    });
}

TEST(DualParaboloid, EveryDirectionBelongsToOneHalf)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const RandomSetup setup = anyLampSetup(rng);
        const CellsResult cells = splitDualParaboloid(test::inputOf(setup));
        ASSERT_TRUE(cells);
        ASSERT_EQ(cells->size(), 2u);
        for (int i = 0; i < 10; ++i) {
            const Vec3d p = setup.light.positionWorld - setup.originWorld + setup.radius * rng.onSphere();
            int serving = 0;
            for (const Cell& cell : *cells) serving += cell.servesLocal[0].signedDistance(p) >= 0;
            EXPECT_EQ(serving, 1);
        }
    });
}

TEST(DualParaboloid, ASpotHasOneAndADirectionalLightIsRefusedByName)
{
    forEachCase(test::kCases, [](Rng& rng) {
        RandomSetup setup = test::anySetup(rng);
        const FramePlan plan = planOf(setup, "dual-paraboloid+uniform");
        if (setup.light.kind == LightKind::Directional) {
            EXPECT_EQ(plan.lights[0].refused, FitFailure::NoPlaceOfLight);
        } else if (setup.light.kind == LightKind::Spot && !plan.lights[0].refused) {
            EXPECT_EQ(plan.lights[0].regions.size(), 1u);
        }
    });
}

TEST(Paraboloid, TheRayThroughAPointsLixelMeetsThePointAndTravelsAsLightDoes)
{
    int met = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        const RandomSetup setup = anyLampSetup(rng);
        const FramePlan plan = planOf(setup, "dual-paraboloid");
        for (const PlannedRegion& region : plan.lights[0].regions) {
            const LightImage image(region.projection(), region.rectangle);
            const Vec3d p = anyPoint(setup, rng);
            const auto lixel = image.lixelAt(p);
            if (!lixel) continue;
            const auto ray = image.rayThrough({lixel->x, lixel->y});
            ASSERT_TRUE(ray);
            const Vec3d lightLocal = setup.light.positionWorld - setup.originWorld;
            EXPECT_LT(length(ray->originLocal - lightLocal), 1e-12 * (1 + length(lightLocal)));
            EXPECT_LT(length(cross(ray->directionLocal, normalized(p - lightLocal))), 1e-9);
            EXPECT_GT(dot(ray->directionLocal, p - lightLocal), 0);
            ++met;
        }
    });
    EXPECT_GT(met, test::scaled(test::kCases) / 4);
}

TEST(Paraboloid, DerivativesAreFiniteDifferences)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const RandomSetup setup = anyLampSetup(rng);
        const FramePlan plan = planOf(setup, "dual-paraboloid");
        if (plan.lights[0].refused) return;
        const LightProjection projection = plan.lights[0].regions[0].projection();
        const Vec3d p = anyPoint(setup, rng), tangent = rng.onSphere();
        const double away = length(p - (setup.light.positionWorld - setup.originWorld)), step = 1e-5 * away;
        const auto after = projection.ndcAt(p + step * tangent), before = projection.ndcAt(p - step * tangent);
        if (!after || !before || length(*after) > 100) return;
        const Vec3d predicted = 2 * step * projection.ndcAlong(p, tangent);
        const double rounding = 1e-12 * (1 + length(setup.originWorld) / away) / projection.paraboloid->halfSize.x;
        EXPECT_LT(length(predicted - (*after - *before)), 1e-6 * length(predicted) + rounding * 100 + 1e-10);
    });
}

// What lookups compare with is the receiver's plane on the ray of the tap, which on a paraboloid is no linear function of lixels.
TEST(Paraboloid, TheDepthOfAPlaneAtATapIsThatOfTheRayThroughIt)
{
    int compared = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        RandomSetup setup = test::ordinarySetup(rng);
        setup.light.kind = LightKind::Point;
        const FramePlan plan = planOf(setup, "dual-paraboloid");
        if (plan.lights[0].refused) return;
        const Vec3d p = toDouble(toFloat(anyPoint(setup, rng)));
        const Vec3d normal = normalized(rng.onSphere() + 2.0 * towardsLight(setup.light, setup.originWorld, p));
        shared::LxReceiver receiver{};
        const PlannedRegion* region = test::serving(plan, toFloat(p), toFloat(normal), receiver);
        if (!region) return;
        const LightImage image(region->projection(), region->rectangle, &region->warp);
        const auto knots = [&](int i) { return plan.warpTable[std::size_t(i)]; };
        const Vec2d tap{receiver.lixel.x + rng.uniform(-20, 20), receiver.lixel.y + rng.uniform(-20, 20)};
        const auto ray = image.rayThrough(tap);
        const double along = dot(normal, ray->directionLocal);
        if (along > -0.05) return; // grazing
        const Vec3d met = ray->originLocal + dot(normal, p - ray->originLocal) / along * ray->directionLocal;
        const auto ndc = region->projection().ndcAt(met);
        ASSERT_TRUE(ndc);
        const float depth = shared::lxPlaneDepth(receiver, {float(tap.x), float(tap.y)}, knots);
        EXPECT_NEAR(depth, 0.5 - 0.5 * ndc->z, 2e-4 * std::abs(0.5 - 0.5 * ndc->z) + 4 * receiver.slack + 1e-6);
        ++compared;
    });
    EXPECT_GT(compared, test::scaled(test::kCases) / 4);
}

TEST(Paraboloid, MapsWithoutAWarpHaveTheIdentity)
{
    Rng rng(7);
    RandomSetup setup = test::ordinarySetup(rng);
    setup.light.kind = LightKind::Point;
    for (const char* technique : {"dual-paraboloid+uniform", "dual-paraboloid(raster=vertices)+uniform"}) {
        const FramePlan plan = planOf(setup, technique);
        ASSERT_FALSE(plan.lights[0].refused);
        for (const PlannedRegion& region : plan.lights[0].regions) {
            EXPECT_FALSE(region.warp.isIdentity());
            const Vec2d ndc{rng.uniform(-1, 1), rng.uniform(-1, 1)};
            const LixelRectangle& r = region.rectangle;
            const shared::vec2 lixel{float(r.x0 + (0.5 + 0.5 * ndc.x) * r.width()),
                                     float(r.y0 + (0.5 + 0.5 * ndc.y) * r.height())};
            const shared::vec2 at = shared::lxWarpedLixel(tableRow(region.warp), lixel, knotsOf(region.warp)).at;
            EXPECT_NEAR(at.x, lixel.x, 1e-4);
            EXPECT_NEAR(at.y, lixel.y, 1e-4);
        }
    }
}

} // namespace
} // namespace lixel
