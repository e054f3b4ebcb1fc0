// SPDX-License-Identifier: MIT
#include "lixel/trace/exact_area.h"

#include "lixel/trace/exact_visibility.h"
#include "lixel/trace/trace_view_samples.h"
#include "trace/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lixel {
namespace {

using namespace lixel::test;

LocalTriangles sphereOverFloor()
{
    return triangles(joined(gridPlane(4, 2), placed(translation({0, 0.8, 0}), sphere(32, 16, 0.5))));
}

TEST(ExactArea, OfOneSampleIsExactVisibility)
{
    const TraceScene scene(sphereOverFloor(), {}, {});
    const View view = perspectiveView({1, 3, 4}, {0, 0.3, 0}, {0, 1, 0}, 0.8, 0.1, 20, 128, 128);
    const ViewSamples samples = traceViewSamples(scene, view);
    Light light;
    light.directionWorld = normalized(Vec3d{1, -2, -0.5});
    EXPECT_EQ(exactArea(scene, view, samples, light, 1), exactVisibility(scene, samples, light));
}

// The shadow of a half plane on a floor seen from above: the share of a pixel on one side of a line is known.
TEST(ExactArea, IsTheShareOfThePixelOnTheLitSideOfAStraightShadowEdge)
{
    forEachCase(kCases / 40, [](Rng& rng) {
        const double edge = rng.uniform(-0.8, 0.8);
        const Shape roof = placed(translation({edge - 5, 1, 0}), gridPlane(1, 5)); // over x < edge
        const TraceScene scene(triangles(joined(gridPlane(1, 9), roof)), {}, {});
        // From below the roof, so that it hides nothing.
        const View view = orthographicView({0, 0.5, 0}, {0, 0, 0}, {0, 0, -1}, 2, 0.1, 2, 16, 16);
        const ViewSamples samples = traceViewSamples(scene, view);
        ASSERT_EQ(samples.size(), 256u);
        const std::vector<float> share = exactArea(scene, view, samples, Light{}, 256);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const double edgePixel = (edge + 1) * 8;
            const double expected = std::clamp(double(std::floor(samples.pixel[i].x)) + 1 - edgePixel, 0.0, 1.0);
            EXPECT_NEAR(share[i], expected, 1.0 / 32 + 1e-6); // 16 columns
        }
    });
}

TEST(ExactArea, CountsOnlyWhatFacesTheLight)
{
    // A ridge between a side that faces the light and one that faces away: nothing shadows the bright side.
    Shape ridge;
    ridge.corner = {{0, 0, -9}, {0, 0, 9}, {-9, -3, -9}, {-9, -3, 9}, {9, -3, -9}, {9, -3, 9}};
    ridge.indices = {0, 1, 3, 0, 3, 2, 0, 4, 5, 0, 5, 1};
    const TraceScene scene(triangles(ridge), {}, {});
    const View view = orthographicView({0, 5, 0}, {0, 0, 0}, {0, 0, -1}, 2, 1, 20, 15, 15);
    Light light;
    light.directionWorld = normalized(Vec3d{1, -0.1, 0});
    const ViewSamples samples = traceViewSamples(scene, view);
    const std::vector<float> share = exactArea(scene, view, samples, light, 16);
    for (std::size_t i = 0; i < samples.size(); ++i) EXPECT_EQ(share[i], samples.normal[i].x < 0 ? 1 : 0);
}

} // namespace
} // namespace lixel
