// SPDX-License-Identifier: MIT
#include "lixel/scene/framing.h"

#include "lixel/scene/view_file.h"

#include "support/random_cases.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lixel::test {
namespace {

Box anyBox(Rng& rng)
{
    const Vec3d centre = rng.logUniform(1e-3, 1e5) * rng.onSphere();
    const double size = rng.logUniform(1e-3, 1e4);
    Box box;
    box.include(centre - size * Vec3d{rng.uniform(0, 1), rng.uniform(0, 1), rng.uniform(0, 1)});
    box.include(centre + size * Vec3d{rng.uniform(0, 1), rng.uniform(0, 1), rng.uniform(0, 1)});
    return box;
}

Camera anyCamera(Rng& rng, const Box& box)
{
    Camera camera;
    camera.eyeWorld = box.centre() + rng.logUniform(1e-2, 10) * box.diagonal() * rng.onSphere();
    camera.targetWorld = box.centre() + 0.1 * box.diagonal() * rng.onSphere();
    camera.fovy = rng.uniform(0.2, 2.5);
    return camera;
}

TEST(DefaultCamera, ShowsTheWholeBoxAndFillsThePicture)
{
    forEachCase(kCases, [](Rng& rng) {
        const Box box = anyBox(rng);
        const int width = rng.integer(50, 2000), height = rng.integer(50, 2000);
        const Camera camera = defaultCamera(box, double(width) / height);
        ASSERT_EQ(checkCamera(camera), std::nullopt);
        const View view = makeView(camera, width, height, box);
        double widest = 0;
        for (const Vec3d& corner : box.corners()) {
            const Vec4d clip = view.clipFromAnchored * point(corner - view.anchorWorld);
            ASSERT_GT(clip.w, 0);
            EXPECT_LE(std::abs(clip.z), clip.w);
            widest = std::max({widest, std::abs(clip.x / clip.w), std::abs(clip.y / clip.w)});
        }
        EXPECT_LT(widest, 1);
        EXPECT_GT(widest, 0.3); // flat and long boxes touch the margin at one side only
    });
}

TEST(DefaultCamera, StandsAboveAndLooksDownAtTheMiddle)
{
    const Box box{{-2, 0, -1}, {2, 3, 1}};
    const Camera camera = defaultCamera(box, 1);
    EXPECT_EQ(camera.targetWorld, box.centre());
    EXPECT_GT(camera.eyeWorld.y, box.centre().y);
    EXPECT_LT(defaultSun().directionWorld.y, 0);
    EXPECT_NEAR(length(defaultSun().directionWorld), 1, 1e-15);
}

TEST(DefaultCamera, AnEmptyBoxAndASinglePointStillGiveAView)
{
    Box single;
    single.include(Vec3d{1e5, 2, -3});
    for (const Box& box : {Box(), single}) {
        const Camera camera = defaultCamera(box, 1.5);
        EXPECT_EQ(checkCamera(camera), std::nullopt);
        EXPECT_TRUE(inverse(makeView(camera, 30, 20, box).clipFromAnchored));
    }
}

TEST(DepthRange, HoldsAllOfTheSceneThatIsFarEnoughBeforeTheEye)
{
    forEachCase(kCases, [](Rng& rng) {
        const Box box = anyBox(rng);
        const Camera camera = anyCamera(rng, box);
        const DepthRange range = depthRange(camera, box);
        ASSERT_TRUE(range.near > 0 && range.near < range.far);
        const Vec3d forward = normalized(camera.targetWorld - camera.eyeWorld);
        for (const Vec3d& corner : box.corners()) {
            const double depth = dot(corner - camera.eyeWorld, forward);
            EXPECT_LE(depth, range.far);
            if (depth > 1.001e-3 * range.far) {
                EXPECT_GE(depth, range.near);
            }
        }
    });
}

TEST(DepthRange, AnOrthographicCameraTakesWhatLiesBehindItToo)
{
    forEachCase(kCases, [](Rng& rng) {
        const Box box = anyBox(rng);
        Camera camera = anyCamera(rng, box);
        camera.orthographicHeight = box.diagonal();
        const DepthRange range = depthRange(camera, box);
        const Vec3d forward = normalized(camera.targetWorld - camera.eyeWorld);
        for (const Vec3d& corner : box.corners()) {
            const double depth = dot(corner - camera.eyeWorld, forward);
            EXPECT_TRUE(depth >= range.near && depth <= range.far);
        }
    });
}

TEST(DepthRange, PlanesOfTheCameraAreKept)
{
    const Box box{{-1, -1, -1}, {1, 1, 1}};
    Camera camera;
    camera.eyeWorld = {0, 0, 5};
    camera.near = 0.25;
    EXPECT_EQ(depthRange(camera, box).near, 0.25);
    camera.far = 4.5;
    EXPECT_EQ(depthRange(camera, box).far, 4.5);
    camera.near = 0;
    EXPECT_EQ(depthRange(camera, box).far, 4.5);
    EXPECT_LT(depthRange(camera, box).near, 4.5);
    camera.near = 100; // behind all of the scene
    camera.far = std::numeric_limits<double>::infinity();
    EXPECT_GT(depthRange(camera, box).far, 100);
}

TEST(DepthRange, ASceneBehindTheEyeStillMakesAProjection)
{
    Camera camera;
    camera.eyeWorld = {0, 0, -5};
    camera.targetWorld = {0, 0, -6};
    const DepthRange range = depthRange(camera, {{-1, -1, -1}, {1, 1, 1}});
    EXPECT_TRUE(range.near > 0 && range.near < range.far);
}

TEST(MakeView, TheTargetIsInTheMiddleOfThePicture)
{
    forEachCase(kCases, [](Rng& rng) {
        const Box box = anyBox(rng);
        Camera camera = anyCamera(rng, box);
        if (rng.chance(0.3)) camera.orthographicHeight = 2 * box.diagonal();
        const View view = makeView(camera, 640, 480, box);
        const Vec3d pixel = pixelFromLocal(view, camera.eyeWorld, camera.targetWorld - camera.eyeWorld);
        EXPECT_NEAR(pixel.x, 320, 1e-6);
        EXPECT_NEAR(pixel.y, 240, 1e-6);
        EXPECT_EQ(view.width, 640);
        EXPECT_EQ(view.height, 480);
    });
}

} // namespace
} // namespace lixel::test
