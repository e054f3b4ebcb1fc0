// SPDX-License-Identifier: MIT
#include "lixel/trace/exact_visibility.h"
#include "lixel/trace/trace_executor.h"
#include "support/random_cases.h"
#include "trace/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>

namespace lixel {
namespace {

using test::Rng;

// A box (sometimes a thin wall, sometimes a low slab) that stands on the middle of a floor, at any scale.
struct Standing
{
    Vec3d half; // of the box in x and z; y is its height
    double scale = 1;
    LocalTriangles triangles; // the floor is the first two
};

Standing anyStanding(Rng& rng)
{
    Standing s;
    s.scale = rng.logUniform(1e-3, 1e4);
    s.half = s.scale * Vec3d{rng.logUniform(0.03, 0.4), rng.logUniform(0.05, 1), rng.logUniform(0.03, 0.4)};
    s.triangles = test::triangles(test::joined(test::gridPlane(1, 2 * s.scale),
                                               test::box({-s.half.x, 0, -s.half.z}, {s.half.x, s.half.y, s.half.z})));
    return s;
}

// One sample on the floor, with the one of its two triangles that it lies in.
void addFloorSample(ViewSamples& samples, const LocalTriangles& casters, Vec3d pointLocal)
{
    const auto corner = [&](std::size_t i) { return toDouble(casters.positionLocal[casters.indices[i]]); };
    int turns = 0; // the same way about all three corners: inside
    for (std::size_t i = 0; i < 3; ++i)
        turns += cross(corner((i + 1) % 3) - corner(i), pointLocal - corner(i)).y >= 0 ? 1 : -1;
    test::addSample(samples, casters, std::abs(turns) == 3 ? 0 : 1, pointLocal, {0, 1, 0});
}

// How far a place of the light image is from the image of the segment middle +- half, the larger of both axes.
double lixelsFromLine(const LightImage& image, Vec2d lixel, Vec3d middle, Vec3d half)
{
    double least = INFINITY;
    for (int i = 0; i <= 1000; ++i)
        if (const auto on = image.lixelAt(middle + (0.002 * i - 1) * half))
            least = std::min(least, std::max(std::abs(on->x - lixel.x), std::abs(on->y - lixel.y)));
    return least;
}

constexpr std::array kLookups{"pcf(1)",        "pcf(4)",           "pcf(9)",    "bilinear",     "dual-plane",
                              "depths(2)",     "depths(4)+pcf(4)", "depths(8)", "hardware-pcf", "bilinear+dual-plane",
                              "depths(2,min)", "pcf(9,rotated)"};

TEST(Contact, NoGapBetweenABoxAndItsShadowIsWiderThanOneLixel)
{
    int asked = 0;
    test::forEachCase(test::kCases / 10, [&](Rng& rng) {
        const Standing s = anyStanding(rng);
        const TraceScene scene(s.triangles, {}, {});
        Light light = test::anyLight(rng, {}, s.scale);
        light.directionWorld.y = -std::abs(light.directionWorld.y) - 0.02;
        light.directionWorld = normalized(light.directionWorld);
        light.positionWorld.y = std::abs(light.positionWorld.y) + 1.5 * s.scale;
        if (light.kind == LightKind::Spot) light.directionWorld = normalized(-light.positionWorld);
        light.range = INFINITY;

        const View view = perspectiveView({0.3 * s.scale, 1.5 * s.scale, 2 * s.scale}, {}, {0, 1, 0}, 1.2,
                                          1e-2 * s.scale, INFINITY, 256, 256);
        Box sceneWorld;
        sceneWorld.include(Vec3d{-2, 0, -2} * s.scale);
        sceneWorld.include(Vec3d{2, 1, 2} * s.scale);
        const char* const lookup = kLookups[std::size_t(rng.integer(0, int(kLookups.size()) - 1))];
        const auto technique = std::get<MapTechnique>(*parseTechnique(lookup));
        const double side = 2 * lookupLayout(technique).reach - 1; // of a square of taps that reaches as far
        const int size = rng.integer(64, 1024);
        const FramePlan plan =
            planShadows({view, std::span(&light, 1), std::span(&sceneWorld, 1), {}, technique, {size, size}});
        if (plan.lights[0].refused) return;
        const LightImage image(plan.lights[0].regions[0].lightClipFromLocal, plan.lights[0].regions[0].rectangle);

        // Receivers just behind the faces that look away from the light, by a lixel and the reach of more taps than one.
        ViewSamples samples;
        const double wanted = 1 + 0.5 * (side - 1);
        for (int i = 0; i < 20; ++i) {
            const bool alongX = rng.chance(0.5);
            const double sign = rng.chance(0.5) ? 1 : -1, along = rng.uniform(-0.5, 0.5);
            const Vec3d outward = alongX ? Vec3d{sign, 0, 0} : Vec3d{0, 0, sign};
            const Vec3d contact =
                alongX ? Vec3d{sign * s.half.x, 0, along * s.half.z} : Vec3d{along * s.half.x, 0, sign * s.half.z};
            if (dot(outward, towardsLight(light, {}, contact)) >= 0) continue;
            const auto from = image.lixelAt(contact);
            const double step = rng.logUniform(1e-3, 0.3) * s.scale;
            const auto to = image.lixelAt(contact + step * outward);
            if (!from || !to) continue;
            const Vec3d alongEdge = alongX ? Vec3d{0, 0, s.half.z} : Vec3d{s.half.x, 0, 0};
            const Vec3d edgeMiddle = contact - dot(contact, normalized(alongEdge)) * normalized(alongEdge);
            const double lixels = lixelsFromLine(image, {to->x, to->y}, edgeMiddle, alongEdge);
            const double distance = step * (wanted + 0.05) / lixels;
            const Vec3d receiver = contact + distance * outward;
            if (!(lixels > 0) || std::isinf(lixels) || std::abs(receiver.x) > 1.9 * s.scale ||
                std::abs(receiver.z) > 1.9 * s.scale)
                continue;
            // Every lixel that the taps may touch is in the box's shadow: no other border of it is near.
            const auto middle = image.lixelAt(receiver);
            if (!middle || lixelsFromLine(image, {middle->x, middle->y}, edgeMiddle, alongEdge) < wanted) continue;
            ViewSamples probe;
            for (int corner = 0; corner < 9; ++corner) {
                const double reach = 0.5 * side + 0.5;
                const auto ray =
                    image.rayThrough({middle->x + reach * (corner % 3 - 1), middle->y + reach * (corner / 3 - 1)});
                const double t = -ray->originLocal.y / ray->directionLocal.y;
                addFloorSample(probe, s.triangles, ray->originLocal + t * ray->directionLocal);
            }
            const std::vector<float> around = exactVisibility(scene, probe, light);
            if (std::any_of(around.begin(), around.end(), [](float v) { return v > 0; })) continue;
            addFloorSample(samples, s.triangles, receiver);
        }
        const std::vector<float> exact = exactVisibility(scene, samples, light);
        const Visibility mapped = runTraced(scene, plan, samples)[0];
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (exact[i] > 0) continue;
            ++asked;
            EXPECT_LT(mapped.value[i], 0.5f) << lookup;
        }
    });
    std::printf("%d receivers behind contacts\n", asked);
    EXPECT_GT(asked, test::scaled(test::kCases / 10));
}

} // namespace
} // namespace lixel
