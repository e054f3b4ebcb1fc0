// SPDX-License-Identifier: MIT
#include "lixel/trace/light_map.h"

#include "lixel/base/view.h"
#include "trace/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lixel {
namespace {

using namespace lixel::test;

// A region that sees the ball of this radius from outside, by perspective or in parallel.
PlannedRegion anyRegion(Rng& rng, Vec3d centreLocal, double radius)
{
    const Vec3d from = centreLocal + radius * rng.logUniform(3, 1e4) * rng.onSphere();
    const double distance = length(from - centreLocal);
    const double near = distance - rng.uniform(0.2, 1.7) * radius, far = distance + 1.8 * radius;
    const View view = rng.chance(0.5) ? orthographicView(from, centreLocal, rng.onSphere(), 2 * radius, near, far, 8, 8)
                                      : perspectiveView(from, centreLocal, rng.onSphere(),
                                                        2 * std::atan(radius / distance), near, far, 8, 8);
    PlannedRegion region;
    region.lightClipFromLocal = clipFromLocal(view, {});
    region.rectangle = {3, 5, 3 + rng.integer(1, 30), 5 + rng.integer(1, 30), 0};
    return region;
}

struct Surface
{
    double depth = 0;      // reversed; 0: nothing
    bool isCertain = true; // no edge is near
};

// The nearest surface at a lixel centre: each triangle projected, its depth interpolated in the light image.
Surface nearestByProjection(const LocalTriangles& casters, const PlannedRegion& region, int x, int y)
{
    const LixelRectangle& r = region.rectangle;
    const Vec2d centre{2 * (x - r.x0 + 0.5) / r.width() - 1, 2 * (y - r.y0 + 0.5) / r.height() - 1};
    Surface nearest;
    for (std::size_t t = 0; t < casters.triangleCount(); ++t) {
        Vec3d corner[3];
        for (std::size_t k = 0; k < 3; ++k)
            corner[k] = project(region.lightClipFromLocal, toDouble(casters.positionLocal[casters.indices[3 * t + k]]));
        const Vec2d b{corner[1].x - corner[0].x, corner[1].y - corner[0].y},
            c{corner[2].x - corner[0].x, corner[2].y - corner[0].y};
        const Vec2d p{centre.x - corner[0].x, centre.y - corner[0].y};
        const double area = cross(b, c);
        if (std::abs(area) < 1e-12) continue;
        const double u = cross(p, c) / area, v = cross(b, p) / area, least = std::min({u, v, 1 - u - v});
        if (least > -1e-3 && least < 1e-3) nearest.isCertain = false;
        if (least < 0) continue;
        const double ndc = corner[0].z + u * (corner[1].z - corner[0].z) + v * (corner[2].z - corner[0].z);
        nearest.depth = std::max(nearest.depth, std::clamp(0.5 - 0.5 * ndc, 0.0, 1.0));
    }
    return nearest;
}

TEST(LightMap, HoldsTheNearestDepthOfTheRayThroughEachLixelCentre)
{
    forEachCase(kCases, [](Rng& rng) {
        const double scale = rng.logUniform(1e-3, 1e4);
        const Vec3d centreLocal = rng.inBox(scale);
        const Shape shape = joined(gridPlane(3, 0.7), placed(translation({0, 0.3, 0}), sphere(12, 7, 0.4)));
        const LocalTriangles casters =
            triangles(placed(translation(centreLocal) * anyRotation(rng) * scaling({scale, scale, scale}), shape));
        const PlannedRegion region = anyRegion(rng, centreLocal, scale);
        const TraceScene scene(casters, {}, {});
        Image<float> layer(40, 40, -7.0f);
        traceLightMap(scene, region, layer);
        const LixelRectangle& r = region.rectangle;
        // The direction of rays is a difference of points that may be 1e4 radii away.
        const double tolerance = 2e-7;
        for (int y = 0; y < layer.height(); ++y) {
            for (int x = 0; x < layer.width(); ++x) {
                if (x < r.x0 || y < r.y0 || x >= r.x1 || y >= r.y1) {
                    EXPECT_EQ(layer(x, y), -7.0f); // another region's
                    continue;
                }
                const Surface expected = nearestByProjection(casters, region, x, y);
                if (!expected.isCertain) continue;
                EXPECT_NEAR(layer(x, y), expected.depth, tolerance) << x << ", " << y;
            }
        }
    });
}

TEST(LightMap, WhatLiesBeforeTheNearSideCountsAndWhatLiesBehindTheFarSideIsNothing)
{
    const auto plateAt = [](double y) {
        return TraceScene(triangles(placed(translation({0, y, 0}), gridPlane(1, 9))), {}, {});
    };
    for (const bool isParallel : {true, false}) {
        const View view = isParallel ? orthographicView({0, 10, 0}, {0, 0, 0}, {0, 0, 1}, 4, 2, 8, 4, 4)
                                     : perspectiveView({0, 10, 0}, {0, 0, 0}, {0, 0, 1}, 0.5, 2, 8, 4, 4);
        const PlannedRegion region{clipFromLocal(view, {}), {0, 0, 8, 8, 0}};
        Image<float> layer(8, 8, -7.0f);
        traceLightMap(plateAt(9), region, layer);
        for (const float depth : layer.data()) EXPECT_EQ(depth, 1);
        traceLightMap(plateAt(1), region, layer);
        for (const float depth : layer.data()) EXPECT_EQ(depth, 0);
        traceLightMap(plateAt(5), region, layer);
        for (const float depth : layer.data()) EXPECT_TRUE(depth > 0 && depth < 1);
        // Behind the light: a parallel light comes from infinitely far, a point does not.
        traceLightMap(plateAt(12), region, layer);
        for (const float depth : layer.data()) EXPECT_EQ(depth, isParallel ? 1 : 0);
    }
}

TEST(LightMap, OfASceneWithoutTrianglesIsEmpty)
{
    const View view = orthographicView({0, 10, 0}, {0, 0, 0}, {0, 0, 1}, 4, 2, 8, 4, 4);
    Image<float> layer(8, 8, -7.0f);
    traceLightMap(TraceScene(LocalTriangles{}, {}, {}), {clipFromLocal(view, {}), {0, 0, 8, 8, 0}}, layer);
    for (const float depth : layer.data()) EXPECT_EQ(depth, 0);
}

TEST(LightMap, HolesOfAMaskLetLightThrough)
{
    Texture texture;
    texture.pixels = Image<Rgba8>(2, 1);
    texture.pixels(0, 0).a = 0;
    texture.wrapU = Wrap::ClampToEdge;
    LocalTriangles casters = triangles(gridPlane(1, 1));
    for (const Vec3f& p : casters.positionLocal) casters.uv.push_back({0.5f * p.x + 0.5f, 0.5f});
    Material mask;
    mask.alphaMode = AlphaMode::Mask, mask.texture = 0;
    const TraceScene scene(casters, std::span(&mask, 1), std::span(&texture, 1));
    const View view = orthographicView({0, 10, 0}, {0, 0, 0}, {0, 0, -1}, 2, 2, 12, 8, 8);
    Image<float> layer(8, 8);
    traceLightMap(scene, {clipFromLocal(view, {}), {0, 0, 8, 8, 0}}, layer);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) EXPECT_EQ(layer(x, y) > 0, x >= 4);
}

} // namespace
} // namespace lixel
