// SPDX-License-Identifier: MIT
#include "lixel/trace/trace_view_samples.h"

#include "trace/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lixel {
namespace {

using namespace lixel::test;

View anyView(Rng& rng, Vec3d centreWorld, double radius)
{
    const Vec3d eye = centreWorld + radius * rng.logUniform(2, 100) * rng.onSphere();
    const Vec3d up = rng.onSphere();
    const double distance = length(eye - centreWorld);
    if (rng.chance(0.3))
        return orthographicView(eye, centreWorld, up, 3 * radius, 0.01 * radius, distance + 3 * radius, 48, 32);
    View view =
        perspectiveView(eye, centreWorld, up, 2 * std::atan(1.5 * radius / distance), 1e-3 * radius,
                        rng.chance(0.5) ? std::numeric_limits<double>::infinity() : distance + 3 * radius, 48, 32);
    // Off-centre, as tiled or jittered pictures are.
    if (rng.chance(0.3)) {
        view.clipFromAnchored =
            translation({rng.uniform(-0.3, 0.3), rng.uniform(-0.3, 0.3), 0}) * view.clipFromAnchored;
    }
    return view;
}

struct Placed
{
    LocalTriangles casters;
    Vec3d centreWorld;
    double scale;

    explicit Placed(Rng& rng) : scale(rng.logUniform(1e-3, 1e4))
    {
        centreWorld = rng.inBox(rng.chance(0.5) ? 1e5 : 0);
        const Mat4d worldFromShape = translation(centreWorld) * anyRotation(rng) * scaling({scale, scale, scale});
        const Shape shape = joined(gridPlane(5, 1.2), placed(translation({0, 0.3, 0}), sphere(24, 12, 0.5)));
        casters = triangles(placed(worldFromShape, shape), centreWorld + rng.inBox(scale));
    }
};

TEST(TraceViewSamples, EverySampleProjectsToItsPixelsCentreAndLiesOnItsTriangle)
{
    forEachCase(kCases, [](Rng& rng) {
        const Placed scene(rng);
        const View view = anyView(rng, scene.centreWorld, scene.scale);
        const TraceScene traced(scene.casters, {}, {});
        const ViewSamples samples = traceViewSamples(traced, view);
        EXPECT_GT(samples.size(), 0u);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const Vec3d p = toDouble(samples.positionLocal[i]), n = toDouble(samples.normal[i]);
            const Vec3d pixel = pixelFromLocal(view, samples.originWorld, p);
            EXPECT_NEAR(pixel.x, samples.pixel[i].x, 1e-3);
            EXPECT_NEAR(pixel.y, samples.pixel[i].y, 1e-3);
            const Corners corners = traced.corners(samples.triangle[i]);
            EXPECT_NEAR(dot(*unitNormal(corners), p - corners[0]), 0, 1e-6 * scene.scale);
            EXPECT_GE(dot(n, towardsEye(view, samples.originWorld, p)), 0);
            EXPECT_NEAR(length(n), 1, 1e-6);
        }
    });
}

// Brute force in another formula: the least depth of all triangles whose projection holds the pixel's centre.
TEST(TraceViewSamples, SeesTheNearestTriangle)
{
    forEachCase(kCases, [](Rng& rng) {
        const Placed scene(rng);
        const View view = anyView(rng, scene.centreWorld, scene.scale);
        const TraceScene traced(scene.casters, {}, {});
        const ViewSamples samples = traceViewSamples(traced, view);
        Image<double> nearest(view.width, view.height, 2.0);
        for (std::uint32_t t = 0; t < scene.casters.triangleCount(); ++t) {
            const Corners c = traced.corners(t);
            const Vec3d a = pixelFromLocal(view, samples.originWorld, c[0]),
                        b = pixelFromLocal(view, samples.originWorld, c[1]),
                        d = pixelFromLocal(view, samples.originWorld, c[2]);
            const double area = cross(Vec2d{b.x - a.x, b.y - a.y}, Vec2d{d.x - a.x, d.y - a.y});
            if (area == 0) continue;
            for (int y = 0; y < view.height; ++y) {
                for (int x = 0; x < view.width; ++x) {
                    const Vec2d p{x + 0.5 - a.x, y + 0.5 - a.y};
                    const double u = cross(p, Vec2d{d.x - a.x, d.y - a.y}) / area;
                    const double v = cross(Vec2d{b.x - a.x, b.y - a.y}, p) / area;
                    if (u < 0 || v < 0 || u + v > 1) continue;
                    const double depth = a.z + u * (b.z - a.z) + v * (d.z - a.z);
                    if (depth >= -1) nearest(x, y) = std::min(nearest(x, y), depth);
                }
            }
        }
        std::size_t covered = 0;
        for (const double depth : nearest.data()) covered += depth <= 1 ? 1 : 0;
        EXPECT_NEAR(double(samples.size()), double(covered), 2);
        // Compared as distances: the NDC depth of both, turned into world units by its slope along the ray.
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const int x = int(samples.pixel[i].x), y = int(samples.pixel[i].y);
            const Vec3d p = toDouble(samples.positionLocal[i]);
            const Vec3d back = normalized(towardsEye(view, samples.originWorld, p));
            const double depth = pixelFromLocal(view, samples.originWorld, p).z;
            const double farther = pixelFromLocal(view, samples.originWorld, p - 2e-3 * scene.scale * back).z;
            EXPECT_LT(depth, nearest(x, y) + (farther - depth));
        }
    });
}

TEST(TraceViewSamples, NothingBeforeTheNearPlaneOrBehindTheFarPlaneIsSeen)
{
    const Shape plates = joined(
        joined(placed(translation({0, -1, 0}), gridPlane(1, 9)), placed(translation({0, -3, 0}), gridPlane(1, 9))),
        placed(translation({0, -5, 0}), gridPlane(1, 99)));
    const TraceScene scene(triangles(plates), {}, {});
    const View view = perspectiveView({0, 0, 0}, {0, -1, 0}, {0, 0, 1}, 1, 2, 4, 16, 16);
    const ViewSamples samples = traceViewSamples(scene, view);
    EXPECT_EQ(samples.size(), 256u);
    for (const Vec3f& p : samples.positionLocal) EXPECT_EQ(p.y, -3);
    EXPECT_EQ(traceViewSamples(scene, perspectiveView({0, 0, 0}, {0, -1, 0}, {0, 0, 1}, 1, 6, 9, 16, 16)).size(), 0u);
}

TEST(TraceViewSamples, HolesOfAMaskAreSeenThrough)
{
    Texture texture;
    texture.pixels = Image<Rgba8>(2, 1);
    texture.pixels(0, 0).a = 0;
    texture.wrapU = Wrap::ClampToEdge;
    LocalTriangles casters = triangles(joined(gridPlane(1, 1), placed(translation({0, -1, 0}), gridPlane(1, 1))));
    for (const Vec3f& p : casters.positionLocal) casters.uv.push_back({0.5f * p.x + 0.5f, 0.5f});
    casters.material = {1, 1, 0, 0};
    Material mask;
    mask.alphaMode = AlphaMode::Mask, mask.texture = 0;
    const TraceScene scene(casters, std::vector<Material>{Material{}, mask}, std::span(&texture, 1));
    const ViewSamples samples =
        traceViewSamples(scene, orthographicView({0, 5, 0}, {0, 0, 0}, {0, 0, -1}, 2, 1, 9, 20, 20));
    ASSERT_EQ(samples.size(), 400u);
    for (std::size_t i = 0; i < samples.size(); ++i)
        EXPECT_EQ(samples.positionLocal[i].y, samples.pixel[i].x < 10 ? -1 : 0);
}

} // namespace
} // namespace lixel
