// SPDX-License-Identifier: MIT
#include "lixel/trace/trace_executor.h"

#include "lixel/trace/exact_visibility.h"
#include "lixel/trace/trace_view_samples.h"
#include "plan/random_warps.h"
#include "trace/shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace lixel {
namespace {

using namespace lixel::test;

// A view of the ball from outside, and a plan for it.
View anyViewOf(Rng& rng, Vec3d centreWorld, double radius)
{
    const double away = rng.uniform(1.5, 5);
    const Vec3d eye = centreWorld + radius * away * rng.onSphere();
    return perspectiveView(eye, centreWorld, rng.onSphere(), 2 * std::atan(1.1 / away), 1e-3 * radius,
                           std::numeric_limits<double>::infinity(), 40, 40);
}

FramePlan planFor(const View& view, const std::vector<Light>& lights, const LocalTriangles& casters, int lixels,
                  const std::string& words)
{
    Box box;
    for (const Vec3f& p : casters.positionLocal) box.include(toDouble(p) + casters.originWorld);
    const auto technique = std::get<MapTechnique>(*parseTechnique(words));
    return planShadows({view, lights, std::span(&box, 1), casters.originWorld, technique, {lixels, lixels}});
}

bool isFacing(const ViewSamples& samples, std::size_t i, const Light& light)
{
    return isLightFacing(light, samples.originWorld, toDouble(samples.positionLocal[i]), toDouble(samples.normal[i]));
}

constexpr std::array kLookups{"pcf(1)",        "pcf(4)",           "pcf(9)",     "pcf(25,rotated)",
                              "bilinear",      "hardware-pcf",     "dual-plane", "bilinear+dual-plane",
                              "depths(2,min)", "depths(3)+pcf(4)", "depths(4)",  "depths(8,q=25)+pcf(9)",
                              "depths(2,max)", "fast-pcf"};

// Warps as strong as any, whatever the technique would have made.
void warpAnyhow(FramePlan& plan, Rng& rng)
{
    plan.warpTable.clear();
    for (std::size_t i = 0; i < plan.regionTable.size(); ++i) {
        PlannedRegion& region = plan.lights[0].regions[i];
        const int band = int(std::ceil(plan.lookup.reach));
        const LixelRectangle& r = region.rectangle;
        if (std::min(r.width(), r.height()) <= 2 * band) continue;
        region.warp = anyWarp({r.x0 + band, r.y0 + band, r.x1 - band, r.y1 - band, r.layer}, rng);
        plan.regionTable[i].warp = appendWarp(region.warp, plan.warpTable);
    }
}

enum class MapKind { Matrix, Paraboloid };

// A body alone, of which all that faces the light is lit. Returns how many samples a map served.
int expectBodyIsLit(Rng& rng, bool isWarped, MapKind maps = MapKind::Matrix)
{
    int served = 0;
    const double scale = rng.logUniform(1e-3, 1e4);
    const Vec3d centreWorld = rng.inBox(rng.chance(0.5) ? 1e5 : 0);
    const int kind = rng.integer(0, 2);
    const Shape shape = kind == 0   ? gridPlane(rng.integer(1, 12), 1)
                        : kind == 1 ? sphere(40, 20, 1)
                                    : box({-1, -0.4, -0.6}, {1, 0.4, 0.6}, 3);
    const Mat4d worldFromShape = translation(centreWorld) * anyRotation(rng) * scaling({scale, scale, scale});
    const LocalTriangles casters = triangles(placed(worldFromShape, shape), centreWorld + rng.inBox(scale));
    const TraceScene scene(casters, {}, {});
    const View view = anyViewOf(rng, centreWorld, scale);
    const ViewSamples samples = traceViewSamples(scene, view);
    Light light = anyLight(rng, centreWorld, 2 * scale);
    if (maps == MapKind::Paraboloid && light.kind == LightKind::Directional) light.kind = LightKind::Point;
    const char* const lookup = kLookups[std::size_t(rng.integer(0, int(kLookups.size()) - 1))];
    const std::string fit = rng.chance(0.5) ? "focused+" : "uniform+";
    const std::string partition = maps == MapKind::Paraboloid ? "dual-paraboloid+" : "";
    FramePlan plan = planFor(view, {light}, casters, rng.integer(16, 200), partition + fit + lookup);
    if (isWarped) warpAnyhow(plan, rng);
    const Visibility visibility = runTraced(scene, plan, samples).front();
    for (std::size_t i = 0; i < samples.size(); ++i) {
        // At a silhouette a view ray may meet the far side's edge: such a sample looks into the body.
        const Vec3d outwards = toDouble(samples.positionLocal[i]) - (centreWorld - casters.originWorld);
        const bool looksInside = kind != 0 && dot(toDouble(samples.normal[i]), outwards) < 0;
        if (looksInside || !isFacing(samples, i, light)) continue;
        EXPECT_NEAR(visibility.value[i], 1, 1e-6) << lookup;
        EXPECT_EQ(visibility.unserved[i], plan.lights[0].refused ? 1 : 0);
        served += visibility.unserved[i] == 0;
    }
    return served;
}

TEST(TraceExecutor, AnUnoccludedBodyIsLitAtAnySlopeScaleAndResolution)
{
    int served = 0;
    forEachCase(kCases, [&](Rng& rng) { served += expectBodyIsLit(rng, false); });
    EXPECT_GT(served, 10000);
}

TEST(TraceExecutor, AnUnoccludedBodyIsLitUnderAnyWarp)
{
    int served = 0;
    forEachCase(kCases, [&](Rng& rng) { served += expectBodyIsLit(rng, true); });
    EXPECT_GT(served, 10000);
}

TEST(TraceExecutor, AnUnoccludedBodyIsLitOnParaboloidsWithAndWithoutWarps)
{
    int served = 0;
    forEachCase(kCases, [&](Rng& rng) { served += expectBodyIsLit(rng, rng.chance(0.5), MapKind::Paraboloid); });
    EXPECT_GT(served, 10000);
}

TEST(TraceExecutor, TendsToExactVisibilityAsLixelsGrow)
{
    const Shape shape = joined(joined(gridPlane(4, 2), placed(translation({0, 0.6, 0}), sphere(40, 20, 0.5))),
                               box({0.7, 0, -1.2}, {1.2, 1, -0.7}));
    const LocalTriangles casters = triangles(shape);
    const TraceScene scene(casters, {}, {});
    const View view = perspectiveView({1, 3, 4}, {0, 0.3, 0}, {0, 1, 0}, 0.8, 0.1, 20, 256, 256);
    const ViewSamples samples = traceViewSamples(scene, view);
    std::vector<Light> lights(3);
    lights[0].directionWorld = normalized(Vec3d{1, -2, -0.5});
    lights[1].kind = LightKind::Point, lights[1].positionWorld = {-2, 4, 1};
    lights[2].kind = LightKind::Spot, lights[2].positionWorld = {-1, 5, 0};
    lights[2].directionWorld = normalized(Vec3d{0.2, -1, 0}), lights[2].coneAngle = 0.7;
    double before[3] = {1, 1, 1};
    for (const int lixels : {32, 128, 512, 2048}) {
        const std::vector<Visibility> visibility =
            runTraced(scene, planFor(view, lights, casters, lixels, "focused+pcf(1)"), samples);
        ASSERT_EQ(visibility.size(), lights.size());
        for (std::size_t k = 0; k < lights.size(); ++k) {
            const std::vector<float> exact = exactVisibility(scene, samples, lights[k]);
            int facing = 0, wrong = 0;
            for (std::size_t i = 0; i < samples.size(); ++i) {
                if (!isFacing(samples, i, lights[k])) continue;
                ++facing;
                wrong += (visibility[k].value[i] >= 0.5f) != (exact[i] >= 0.5f);
            }
            const double share = double(wrong) / facing;
            std::printf("%d lixels, light %zu: %.3f %% misclassified\n", lixels, k, 100 * share);
            EXPECT_LT(share, 0.6 * before[k]);
            before[k] = share;
        }
    }
    for (const double share : before) EXPECT_LT(share, 0.002);
}

TEST(TraceExecutor, ARefusedLightLightsEverythingUnserved)
{
    const LocalTriangles casters = triangles(box({-1, -1, -1}, {1, 1, 1}));
    const TraceScene scene(casters, {}, {});
    const View view = perspectiveView({0, 0, 0.5}, {0, 0, 0}, {0, 1, 0}, 1, 0.1, 20, 16, 16);
    const ViewSamples samples = traceViewSamples(scene, view);
    Light lamp;
    lamp.kind = LightKind::Point;
    const FramePlan plan = planFor(view, {lamp}, casters, 64, "uniform+pcf(1)");
    ASSERT_TRUE(plan.lights[0].refused.has_value());
    const Visibility visibility = runTraced(scene, plan, samples).front();
    for (std::size_t i = 0; i < samples.size(); ++i) {
        EXPECT_EQ(visibility.value[i], 1);
        EXPECT_EQ(visibility.unserved[i], 1);
    }
}

} // namespace
} // namespace lixel
