// SPDX-License-Identifier: MIT
#include "lixel/shared/lookup/visibility.h"

#include "lixel/plan/clip_convention.h"
#include "lixel/plan/shadow_plan.h"
#include "plan/lookup_maps.h"
#include "plan/random_setups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace lixel {
namespace {

using test::forEachCase;
using test::litBy;
using test::litByPcf;
using test::Rng;

// A light looking at a plane alone, a map of it with ideal depths, and a place on it.
struct PlaneUnderLight
{
    Mat4d lightClipFromLocal;
    LixelRectangle rectangle;
    shared::ShadowRegion row;
    Plane plane;
    LookupLayout lookup;

    // Reversed depth of the plane at a lixel's centre; 0 where the ray misses it.
    float storedDepth(int x, int y) const
    {
        const LightImage image(lightClipFromLocal, rectangle);
        const auto ray = image.rayThrough({x + 0.5, y + 0.5});
        const double along = dot(plane.normal, ray->directionLocal);
        const double t = -plane.signedDistance(ray->originLocal) / along;
        const Vec4d clip = lightClipFromLocal * point(ray->originLocal + t * ray->directionLocal);
        if (!(clip.w > 0)) return 0;
        return float(std::clamp(0.5 - 0.5 * clip.z / clip.w, 0.0, 1.0));
    }
};

// A box around the plane's piece stands for the scene; slopes up to edge-on.
std::optional<PlaneUnderLight> anyPlaneUnderLight(Rng& rng, const std::string& lookup)
{
    test::RandomSetup setup = test::anySetup(rng);
    setup.boxesWorld.resize(1);
    const auto technique = std::get<MapTechnique>(*parseTechnique(lookup));
    const LixelSize size{rng.integer(8, 2048), rng.integer(8, 2048)};
    const FramePlan plan =
        planShadows({setup.view, std::span(&setup.light, 1), setup.boxesWorld, setup.originWorld, technique, size});
    if (plan.lights[0].refused) return std::nullopt;
    const Box box = setup.sceneLocal();
    const Vec3d through{rng.uniform(box.min.x, box.max.x), rng.uniform(box.min.y, box.max.y),
                        rng.uniform(box.min.z, box.max.z)};
    const Vec3d light = towardsLight(setup.light, setup.originWorld, through);
    const Vec3d normal = normalized(rng.logUniform(1e-4, 1) * light + 0.5 * cross(light, rng.onSphere()));
    if (!(dot(normal, light) > 0)) return std::nullopt;
    return PlaneUnderLight{plan.lights[0].regions[0].lightClipFromLocal, plan.lights[0].regions[0].rectangle,
                           plan.regionTable[0], planeThrough(through, normal), plan.lookup};
}

// Every store with some kernel, every kernel with some store. (Bounds by moments are not among them: they are tested apart.)
const std::vector<std::string> kLookups{"pcf(1)",
                                        "pcf(4)",
                                        "pcf(9)",
                                        "pcf(16)",
                                        "pcf(25)",
                                        "pcf(9,rotated)",
                                        "pcf(16,jittered)",
                                        "bilinear",
                                        "hardware-pcf",
                                        "dual-plane",
                                        "bilinear+dual-plane",
                                        "fast-pcf",
                                        "fast-pcf+pcf(4)",
                                        "depths(2,max)",
                                        "depths(2,min)+pcf(9)",
                                        "depths(3,q=25)+pcf(4,rotated)",
                                        "depths(4)+pcf(16,jittered)",
                                        "depths(4,bits=16)+bilinear",
                                        "depths(5)+dual-plane+pcf(9)",
                                        "depths(8,q=25)+pcf(25)"};

TEST(Lookup, APlaneAloneIsLitAtEverySlopeScaleAndDistance)
{
    int asked = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        const auto scene = anyPlaneUnderLight(rng, kLookups[std::size_t(rng.integer(0, int(kLookups.size()) - 1))]);
        if (!scene) return;
        const LightImage image(scene->lightClipFromLocal, scene->rectangle);
        for (int i = 0; i < 8; ++i) {
            // A receiver of the plane somewhere in the map, rounded to float as view samples are.
            const auto ray =
                image.rayThrough({rng.uniform(3, scene->rectangle.x1 - 3), rng.uniform(3, scene->rectangle.y1 - 3)});
            const double t =
                -scene->plane.signedDistance(ray->originLocal) / dot(scene->plane.normal, ray->directionLocal);
            const Vec3d p = ray->originLocal + t * ray->directionLocal;
            const Vec4d clip = scene->lightClipFromLocal * point(p);
            if (!isFinite(p) || !(clip.w > 0) || std::abs(clip.z) > clip.w) continue;
            const Vec3f local = toFloat(p), normal = toFloat(scene->plane.normal);
            const auto receiver =
                shared::lxReceive(scene->row, {local.x, local.y, local.z}, {normal.x, normal.y, normal.z});
            if (receiver.isInside < 0.5f) continue;
            const auto stored = [&](int x, int y, int) { return scene->storedDepth(x, y); };
            const auto seed = shared::lxSeedOf({local.x, local.y, local.z});
            EXPECT_FLOAT_EQ(litBy(scene->lookup.how, scene->row, receiver, stored, seed), 1.0f);
            ++asked;
        }
    });
    std::printf("%d receivers\n", asked);
    EXPECT_GT(asked, test::scaled(test::kCases) / 2);
}

TEST(Lookup, AnOccluderNearerThanTheBiasAllowsShadowsAndOneBehindDoesNot)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const auto scene = anyPlaneUnderLight(rng, "pcf(1)");
        if (!scene) return;
        const LightImage image(scene->lightClipFromLocal, scene->rectangle);
        const auto ray =
            image.rayThrough({rng.uniform(1, scene->rectangle.x1 - 1), rng.uniform(1, scene->rectangle.y1 - 1)});
        const double t = -scene->plane.signedDistance(ray->originLocal) / dot(scene->plane.normal, ray->directionLocal);
        const Vec3d p = ray->originLocal + t * ray->directionLocal;
        const Vec3f local = toFloat(p), normal = toFloat(scene->plane.normal);
        const auto r = shared::lxReceive(scene->row, {local.x, local.y, local.z}, {normal.x, normal.y, normal.z});
        if (r.isInside < 0.5f || r.depth < 0 || r.depth > 1) return;
        const float threshold =
            shared::lxShadowingDepth(r, {std::floor(r.lixel.x) + 0.5f, std::floor(r.lixel.y) + 0.5f});
        const auto at = [](float depth) { return [depth](int, int, int) { return depth; }; };
        EXPECT_EQ(litByPcf(scene->row, r, 1, at(0.0f)), 1.0f);
        EXPECT_EQ(litByPcf(scene->row, r, 1, at(threshold)), 1.0f);
        if (threshold < 0.999f) {
            EXPECT_EQ(litByPcf(scene->row, r, 1, at(threshold + 1e-3f)), 0.0f);
        }
    });
}

TEST(Lookup, PcfGivesOneOfItsSharesAndStopsAtTheRectangle)
{
    shared::ShadowRegion region;
    for (int i = 0; i < 4; ++i)
        region.lightClipFromLocal[i] = {i == 0 ? 1.0f : 0, i == 1 ? 1.0f : 0, i == 2 ? 1.0f : 0, i == 3 ? 1.0f : 0};
    region.lixelFromNdc = {4, 4, 12, 12};
    region.rectangle = region.serves = {8, 8, 16, 16};
    forEachCase(test::kCases, [&](Rng& rng) {
        const int side = rng.integer(1, 5);
        const shared::vec3 p{float(rng.uniform(-1, 1)), float(rng.uniform(-1, 1)), 0.5f};
        const auto r = shared::lxReceive(region, p, {0, 0, 1});
        ASSERT_EQ(r.isInside, 1.0f);
        int lit = 0;
        const float v = litByPcf(region, r, side, [&](int x, int y, int layer) {
            EXPECT_TRUE(x >= 8 && x < 16 && y >= 8 && y < 16 && layer == 0);
            const bool blocks = rng.chance(0.5);
            lit += !blocks;
            return blocks ? 0.9f : 0.1f;
        });
        EXPECT_EQ(v, float(lit) / float(side * side));
    });
}

} // namespace
} // namespace lixel
