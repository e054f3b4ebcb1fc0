// SPDX-License-Identifier: MIT
#include "lixel/plan/clip_convention.h"
#include "lixel/plan/footprint.h"
#include "lixel/plan/shadow_plan.h"
#include "plan/random_setups.h"

#include <gtest/gtest.h>

namespace lixel {
namespace {

using test::anySetup;
using test::forEachCase;
using test::RandomSetup;
using test::Rng;

FramePlan planOf(const RandomSetup& setup, int width, int height, MapTechnique technique = {})
{
    return planShadows(
        {setup.view, std::span(&setup.light, 1), setup.boxesWorld, setup.originWorld, technique, {width, height}});
}

Vec3d anyPointInScene(const RandomSetup& setup, Rng& rng)
{
    const Box& box = setup.boxesWorld[std::size_t(rng.integer(0, int(setup.boxesWorld.size()) - 1))];
    return Vec3d{rng.uniform(box.min.x, box.max.x), rng.uniform(box.min.y, box.max.y),
                 rng.uniform(box.min.z, box.max.z)} -
           setup.originWorld;
}

TEST(LightImage, TheRayThroughAPointsLixelMeetsThePointAndTravelsAsLightDoes)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const RandomSetup setup = anySetup(rng);
        const FramePlan plan = planOf(setup, rng.integer(8, 1024), rng.integer(8, 1024));
        if (plan.lights[0].refused) return;
        const PlannedRegion& region = plan.lights[0].regions[0];
        const LightImage image(region.lightClipFromLocal, region.rectangle);
        for (int i = 0; i < 10; ++i) {
            const Vec3d p = anyPointInScene(setup, rng);
            const auto lixel = image.lixelAt(p);
            if (!lixel) continue;
            const auto ray = image.rayThrough({lixel->x, lixel->y});
            ASSERT_TRUE(ray);
            const Vec3d travel = normalized(ray->directionLocal);
            const double scale = length(p) + length(ray->originLocal);
            EXPECT_LT(length(cross(travel, p - ray->originLocal)), 1e-6 * scale);
            EXPECT_LT(dot(travel, towardsLight(setup.light, setup.originWorld, p)), -0.999);
        }
    });
}

TEST(Footprint, IsTheFiniteDifferenceOfLixelsOverPixels)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const RandomSetup setup = anySetup(rng);
        const FramePlan plan = planOf(setup, 512, 256);
        if (plan.lights[0].refused) return;
        const LightImage image(plan.lights[0].regions[0].lightClipFromLocal, plan.lights[0].regions[0].rectangle);
        const Vec3d p = anyPointInScene(setup, rng), normal = rng.onSphere();
        const auto f = footprint(setup.view, setup.originWorld, image, p, normal);
        if (!f) return;

        // Walk a little along the plane and compare the linear prediction with what both images really do.
        const auto lixelAt = [&](Vec3d q) { return image.lixelAt(q); };
        const auto pixelAt = [&](Vec3d q) { return pixelFromLocal(setup.view, setup.originWorld, q); };
        const double step =
            1e-5 * setup.radius * std::min(1.0, length(towardsEye(setup.view, setup.originWorld, p)) / setup.radius);
        const Vec3d t = anyPerpendicular(normal),
                    along = normalized(rng.uniform(-1, 1) * t + rng.uniform(-1, 1) * cross(normal, t));
        const auto l0 = lixelAt(p - step * along), l1 = lixelAt(p + step * along);
        if (!l0 || !l1) return;
        const Vec3d pixels = pixelAt(p + step * along) - pixelAt(p - step * along);
        const Vec2d lixels{l1->x - l0->x, l1->y - l0->y};
        const Vec2d predicted{f->lixelFromPixel[0][0] * pixels.x + f->lixelFromPixel[0][1] * pixels.y,
                              f->lixelFromPixel[1][0] * pixels.x + f->lixelFromPixel[1][1] * pixels.y};
        // Edge-on planes amplify rounding by the size of the Jacobian.
        const double jacobian = std::abs(f->lixelFromPixel[0][0]) + std::abs(f->lixelFromPixel[0][1]) +
                                std::abs(f->lixelFromPixel[1][0]) + std::abs(f->lixelFromPixel[1][1]);
        EXPECT_LT(length(predicted - lixels),
                  1e-4 * length(lixels) + 1e-4 * jacobian * std::hypot(pixels.x, pixels.y) + 1e-9);
        EXPECT_NEAR(l1->z - l0->z, dot(f->depthPerLixel, lixels),
                    1e-4 * length(f->depthPerLixel) * length(lixels) + 1e-9);
    });
}

TEST(Footprint, UnderALightAtTheEyeEveryLixelIsAsAPixel)
{
    // A perspective light image from the eye, of the view's own matrix: the identity, whatever the surface.
    const View view = perspectiveView({1, 2, 3}, {4, 2, 1}, {0, 1, 0}, 1, 0.1, 100, 640, 480);
    const LightImage image(clipFromLocal(view, {}), {0, 0, 640, 480, 0});
    forEachCase(test::kCases, [&](Rng& rng) {
        const auto f = footprint(view, {}, image, Vec3d{4, 2, 1} + rng.inBox(0.5), rng.onSphere());
        ASSERT_TRUE(f);
        EXPECT_NEAR(f->lixelFromPixel[0][0], 1, 1e-6);
        EXPECT_NEAR(f->lixelFromPixel[0][1], 0, 1e-6);
        EXPECT_NEAR(f->pixelsPerLixel, 1, 1e-6);
        EXPECT_NEAR(f->lixelsPerPixel, 1, 1e-6);
    });
}

TEST(Place, KeepsTheLookupsReachInsideTheRectangleAndTurnsTheLongerSideAlongIt)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const RandomSetup setup = anySetup(rng);
        MapTechnique technique;
        const int side = rng.integer(1, 5);
        technique.kernel = PcfKernel{side * side};
        const int width = rng.integer(16, 600), height = rng.integer(16, 600);
        const FramePlan plan = planOf(setup, width, height, technique);
        if (plan.lights[0].refused) return;
        const LightImage image(plan.lights[0].regions[0].lightClipFromLocal, plan.lights[0].regions[0].rectangle);
        const Mat4d view = clipFromLocal(setup.view, setup.originWorld);
        for (int i = 0; i < 20; ++i) {
            const Vec3d p = anyPointInScene(setup, rng);
            const Vec4d c = view * point(p);
            const bool seen = c.w > 0 && std::abs(c.x) <= c.w && std::abs(c.y) <= c.w && std::abs(c.z) <= c.w;
            if (!seen ||
                !isLightFacing(setup.light, setup.originWorld, p, towardsLight(setup.light, setup.originWorld, p)))
                continue;
            const auto lixel = image.lixelAt(p);
            ASSERT_TRUE(lixel);
            const double reach = plan.lookup.reach * (1 - 1e-9);
            EXPECT_GE(lixel->x, reach);
            EXPECT_GE(lixel->y, reach);
            EXPECT_LE(lixel->x, width - reach);
            EXPECT_LE(lixel->y, height - reach);
        }
    });
}

TEST(PlanTables, SayInFloatWhatThePlanSaysInDouble)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const RandomSetup setup = anySetup(rng);
        const FramePlan plan = planOf(setup, 300, 200);
        if (plan.lights[0].refused) return;
        const Mat4d reversed = toHost(plan.lights[0].regions[0].lightClipFromLocal, kExecutorConvention);
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 4; ++column) {
                const shared::vec4& c = plan.regionTable[0].lightClipFromLocal[column];
                EXPECT_EQ((row == 0 ? c.x : row == 1 ? c.y : row == 2 ? c.z : c.w), float(reversed.m[row][column]));
            }
        EXPECT_EQ(plan.lightTable[0].regions.y, 1);
    });
}

TEST(PlanShadows, ARecycledPlanIsTheSamePlan)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const RandomSetup setup = anySetup(rng);
        FramePlan used = planOf(anySetup(rng), 64, 64);
        const PlanInput input{setup.view, std::span(&setup.light, 1), setup.boxesWorld, setup.originWorld, {},
                              {128, 64}};
        FitScratch scratch;
        const FramePlan fresh = planShadows(input), again = planShadows(input, scratch, std::move(used));
        ASSERT_EQ(fresh.lights[0].regions.size(), again.lights[0].regions.size());
        for (std::size_t i = 0; i < fresh.lights[0].regions.size(); ++i)
            EXPECT_EQ(fresh.lights[0].regions[i].lightClipFromLocal, again.lights[0].regions[i].lightClipFromLocal);
        EXPECT_EQ(fresh.regionTable.size(), again.regionTable.size());
        EXPECT_EQ(fresh.layers, again.layers);
    });
}

TEST(ClipConvention, FromHostIsTheInverseOfToHostAndDepthsAreTheHosts)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const RandomSetup setup = anySetup(rng);
        const Mat4d clip = clipFromLocal(setup.view, setup.originWorld);
        for (const ClipDepth depth : {ClipDepth::MinusOneToOne, ClipDepth::ZeroToOne, ClipDepth::OneToZero})
            for (const bool yDown : {false, true}) {
                const ClipConvention host{depth, yDown};
                const Mat4d there = toHost(clip, host), back = fromHost(there, host);
                for (int i = 0; i < 4; ++i)
                    for (int j = 0; j < 4; ++j)
                        EXPECT_NEAR(back.m[i][j], clip.m[i][j],
                                    1e-12 * (std::abs(clip.m[2][j]) + std::abs(clip.m[3][j]) + std::abs(clip.m[i][j])));
                const Vec3d p = anyPointInScene(setup, rng), ours = project(clip, p), hosts = project(there, p);
                const double wanted = depth == ClipDepth::MinusOneToOne ? ours.z
                                      : depth == ClipDepth::ZeroToOne   ? 0.5 + 0.5 * ours.z
                                                                        : 0.5 - 0.5 * ours.z;
                EXPECT_NEAR(hosts.z, wanted, 1e-9 * (1 + std::abs(ours.z)));
                EXPECT_NEAR(hosts.y, yDown ? -ours.y : ours.y, 1e-9 * (1 + std::abs(ours.y)));
            }
    });
}

} // namespace
} // namespace lixel
