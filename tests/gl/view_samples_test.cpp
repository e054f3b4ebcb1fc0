// SPDX-License-Identifier: MIT
#include "graphics.h"
#include "small_scenes.h"

#include "lixel/gl/passes/gather_pass.h"
#include "lixel/gl/passes/view_pass.h"
#include "lixel/trace/trace_scene.h"
#include "lixel/trace/trace_view_samples.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

namespace lixel::test {
namespace {

using namespace gl;

// The two passes with what they keep from frame to frame.
struct ViewDrawer
{
    Device& device;
    Surfaces surfaces{device};
    ViewPass viewPass;
    GatherPass gatherPass;
    ViewTargets targets;
    PointList points{device};

    explicit ViewDrawer(Device& on) : device(on) {}
    ViewSamples operator()(const CasterBuffers& casters, const View& view)
    {
        surfaces.update(casters);
        targets.resize(device, view.width, view.height);
        viewPass.run(surfaces, view, targets);
        gatherPass.run(surfaces, view, targets, points);
        return points.download();
    }
};

class ViewSamplesTest : public GlTest
{
};

double distanceFromTriangle(const LocalTriangles& triangles, std::uint32_t triangle, Vec3d p)
{
    const auto corner = [&](std::size_t c) {
        return toDouble(triangles.positionLocal[triangles.indices[3 * std::size_t(triangle) + c]]);
    };
    const Vec3d a = corner(0), b = corner(1), c = corner(2), n = normalized(cross(b - a, c - a));
    double outside = std::abs(dot(n, p - a));
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}})
        outside = std::max(outside, -dot(normalized(cross(n, to - from)), p - from));
    return outside;
}

TEST_F(ViewSamplesTest, SamplesLieOnTheirTriangleFaceTheEyeAndProjectToTheirPixel)
{
    ViewDrawer draw(device());
    forEachCase(30, [&](Rng& rng) {
        const double half = rng.logUniform(1e-3, 1e4);
        SmallScene scene = rng.chance(0.5) ? anyObjectsOnAFloor(rng, half) : anyTriangleSoup(rng, 60, half);
        scene.originWorld = rng.chance(0.5) ? Vec3d{} : 1e5 * rng.onSphere();
        const View view = anyViewOf(rng, scene.originWorld, half, rng.integer(1, 90), rng.integer(1, 70));
        const ViewSamples samples = draw(scene.casters(), view);
        const LocalTriangles triangles = flatten(scene.casters());
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const Vec3d p = toDouble(samples.positionLocal[i]), n = toDouble(samples.normal[i]);
            ASSERT_LT(samples.triangle[i], triangles.triangleCount());
            EXPECT_LE(distanceFromTriangle(triangles, samples.triangle[i], p), 3e-7 * (half + length(p)));
            EXPECT_NEAR(length(n), 1, 1e-6);
            EXPECT_GE(dot(n, normalized(towardsEye(view, samples.originWorld, p))), -1e-6);
            const Vec3d pixel = pixelFromLocal(view, samples.originWorld, p);
            EXPECT_NEAR(pixel.x, samples.pixel[i].x, 0.02);
            EXPECT_NEAR(pixel.y, samples.pixel[i].y, 0.02);
        }
    });
}

TEST_F(ViewSamplesTest, RasterizerAndRaysSeeTheSameSurfaces)
{
    ViewDrawer draw(device());
    std::size_t all = 0, differing = 0, together = 0;
    double farthest = 0;
    forEachCase(40, [&](Rng& rng) {
        SmallScene scene = rng.chance(0.5) ? anyObjectsOnAFloor(rng, 1) : anyTriangleSoup(rng, 60, 1);
        const View view = anyViewOf(rng, {}, 1, rng.integer(1, 120), rng.integer(1, 90));
        const ViewSamples drawn = draw(scene.casters(), view);
        const ViewSamples traced = traceViewSamples(TraceScene(scene.casters()), view);
        std::map<std::pair<float, float>, std::size_t> at;
        for (std::size_t i = 0; i < traced.size(); ++i) at[{traced.pixel[i].y, traced.pixel[i].x}] = i;
        all += std::max(drawn.size(), traced.size());
        std::size_t same = 0;
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            const auto found = at.find({drawn.pixel[i].y, drawn.pixel[i].x});
            if (found == at.end() || traced.triangle[found->second] != drawn.triangle[i]) continue;
            ++same;
            farthest = std::max(
                farthest, length(toDouble(drawn.positionLocal[i]) - toDouble(traced.positionLocal[found->second])));
            EXPECT_GT(dot(toDouble(drawn.normal[i]), toDouble(traced.normal[found->second])), 0.999999);
        }
        together += same;
        differing += std::max(drawn.size(), traced.size()) - same;
    });
    // Pixels may differ where an edge, of a triangle or of an alpha mask, passes through their centre.
    EXPECT_LT(double(differing), 2e-3 * double(all)) << together << " samples agree";
    EXPECT_LT(farthest, 1e-4);
    std::printf("%zu agree, %zu differ, farthest %g\n", together, differing, farthest);
}

TEST_F(ViewSamplesTest, SamplesSurviveTheWayToTheDeviceAndBack)
{
    PointList points(device());
    forEachCase(kCases, [&](Rng& rng) {
        ViewSamples samples;
        samples.width = rng.integer(1, 300), samples.height = rng.integer(1, 300);
        samples.originWorld = rng.inBox(1e5);
        for (int i = rng.integer(0, 500); i > 0; --i) {
            samples.pixel.push_back(
                {float(rng.integer(0, samples.width - 1)) + 0.5f, float(rng.integer(0, samples.height - 1)) + 0.5f});
            samples.positionLocal.push_back(toFloat(rng.inBox(100)));
            samples.normal.push_back(toFloat(rng.onSphere()));
            samples.triangle.push_back(rng.chance(0.1) ? kNoTriangle : std::uint32_t(rng.integer(0, 1 << 30)));
        }
        points.upload(samples);
        const ViewSamples back = points.download();
        EXPECT_EQ(back.pixel, samples.pixel);
        EXPECT_EQ(back.positionLocal, samples.positionLocal);
        EXPECT_EQ(back.normal, samples.normal);
        EXPECT_EQ(back.triangle, samples.triangle);
        EXPECT_EQ(back.originWorld, samples.originWorld);
    });
}

TEST_F(ViewSamplesTest, FramesAfterTheFirstMakeNoObjects)
{
    ViewDrawer draw(device());
    Rng rng(1);
    const SmallScene scene = anyTriangleSoup(rng, 200, 1);
    draw(scene.casters(), anyViewOf(rng, {}, 1, 61, 47));
    const std::uint64_t before = objectsMade();
    for (int i = 0; i < 5; ++i) draw(scene.casters(), anyViewOf(rng, {}, 1, 61, 47));
    EXPECT_EQ(objectsMade(), before);
}

TEST_F(ViewSamplesTest, ListsAndTrianglesThatAreSplitGiveTheSameSamples)
{
    ViewDrawer draw(device());
    Rng rng(3);
    const SmallScene scene = anyTriangleSoup(rng, 300, 1);
    const View view = anyViewOf(rng, {}, 1, 171, 99);
    const ViewSamples whole = draw(scene.casters(), view);
    // Bytes that hold all positions, but only 896 of the 16,929 entries, and in the second case all but 24 triangles.
    for (const std::int64_t bytes : {std::int64_t(32 * 1024), std::int64_t(300 * 3 * 12)}) {
        const LowLimits low(device(), bytes);
        const ViewSamples split = draw(scene.casters(), view);
        EXPECT_GT(draw.points.parts().size(), 10u);
        EXPECT_EQ(split.positionLocal, whole.positionLocal);
        EXPECT_EQ(split.normal, whole.normal);
        EXPECT_EQ(split.triangle, whole.triangle);
    }
    const LowLimits tooLow(device(), 300 * 3 * 12 - 1);
    EXPECT_THROW(draw(scene.casters(), view), GraphicsError);
}

TEST_F(ViewSamplesTest, AnEmptySceneHasNoSamples)
{
    ViewDrawer draw(device());
    Rng rng(1);
    EXPECT_EQ(draw(CasterBuffers{}, anyViewOf(rng, {}, 1, 8, 8)).size(), 0u);
}

} // namespace
} // namespace lixel::test
