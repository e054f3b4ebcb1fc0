// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "scene/loaded.h"

namespace lixel::test {
namespace {

const std::vector<Vec3f> kTriangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
const std::vector<Vec3f> kSquare{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}};

TEST(GltfGeometry, ABufferInsideTheUriIsRead) { EXPECT_EQ(corners(evaluateData("data_uri.gltf")), kTriangle); }

// Parent: T(10, 20, 30) R(y, 90 degrees) S(2, 3, 4); child: x -> y -> -x, then (5, 6, 7). By hand: p = (x, y, 0) goes
// to (5 - y, 6 + x, 7), is scaled to (10 - 2y, 18 + 3x, 28) and turned to (28, 18 + 3x, 2y - 10).
TEST(GltfGeometry, TransformsOfParentAndChildAreChained)
{
    expectNear(corners(evaluateData("node_transforms.gltf")), {{38, 38, 20}, {38, 41, 20}, {38, 38, 22}}, 1e-5);
}

TEST(GltfGeometry, AMeshIsDrawnByEachNodeThatHasIt)
{
    const SceneBuffers buffers = evaluateData("instances.glb");
    ASSERT_EQ(buffers.triangles.triangleCount(), 6u);
    ASSERT_EQ(buffers.bounds.boxesWorld.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(buffers.bounds.boxesWorld[i].min, (Vec3d{2.0 * double(i), 0, 0}));
        EXPECT_EQ(buffers.bounds.boxesWorld[i].max, (Vec3d{2.0 * double(i) + 1, 1, 0}));
    }
}

TEST(GltfGeometry, OnlyTheDefaultSceneIsDrawn) { EXPECT_EQ(corners(evaluateData("two_scenes.gltf")), kTriangle); }

TEST(GltfGeometry, IndicesOfEveryWidthAndNoneGiveTheSameTriangles)
{
    const std::vector<Vec3f> found = corners(evaluateData("indices.gltf"));
    ASSERT_EQ(found.size(), 4 * kSquare.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i], kSquare[i % kSquare.size()]) << i;
}

TEST(GltfGeometry, StripsAndFansBecomeTrianglesOfOneOrientationAndPointsAreLeftOut)
{
    const SceneBuffers buffers = evaluateData("strip_fan.gltf");
    const std::vector<Vec3f> found = corners(buffers);
    ASSERT_EQ(found.size(), 15u);
    double area = 0;
    for (std::size_t t = 0; t < found.size(); t += 3) {
        const Vec3d normal =
            cross(toDouble(found[t + 1]) - toDouble(found[t]), toDouble(found[t + 2]) - toDouble(found[t]));
        EXPECT_EQ(normal.z > 0, t >= 9) << "the strip runs clockwise, the fan counter-clockwise; triangle " << t / 3;
        area += length(normal) / 2;
    }
    EXPECT_DOUBLE_EQ(area, 2.5);
    ASSERT_EQ(buffers.scene->warnings.size(), 2u);
    EXPECT_NE(buffers.scene->warnings[0].find("meshes[0].primitives[2]: points and lines are left out"),
              std::string::npos);
}

TEST(GltfGeometry, InterleavedAndNormalizedAttributesAreRead)
{
    const SceneBuffers buffers = evaluateData("interleaved.glb");
    EXPECT_EQ(corners(buffers), kSquare);
    ASSERT_EQ(buffers.triangles.normal.size(), 4u);
    for (const Vec3f& n : buffers.triangles.normal) EXPECT_EQ(n, (Vec3f{0, 0, 1}));
    EXPECT_EQ(buffers.triangles.uv, (std::vector<Vec2f>{{0, 1}, {1, 1}, {1, 0}, {0, 0}}));
}

TEST(GltfGeometry, QuantizedPositionsAreNormalizedThenPlaced)
{
    expectNear(corners(evaluateData("quantized.gltf")), {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}}, 1e-6);
}

TEST(GltfGeometry, SparseAccessorsReplaceElementsOfADenseOneAndOfNothing)
{
    const auto scene = loadData("sparse.gltf");
    EXPECT_EQ(scene->meshes.at(0).position, (std::vector<Vec3f>{{0, 0, 5}, {1, 0, 0}, {0, 1, 5}}));
    EXPECT_EQ(scene->meshes.at(0).morphTargets.at(0).position, (std::vector<Vec3f>{{0, 0, 5}, {0, 0, 0}, {0, 1, 5}}));
}

// The shared array also holds a vertex that is no number and that no triangle uses.
TEST(GltfGeometry, OfASharedVertexArrayEachPrimitiveKeepsWhatItUses)
{
    const auto scene = loadData("shared_vertices.gltf");
    ASSERT_EQ(scene->meshes.size(), 2u);
    EXPECT_EQ(scene->meshes[0].position, kTriangle);
    EXPECT_EQ(scene->meshes[1].position, (std::vector<Vec3f>{{5, 5, 5}, {6, 5, 5}, {5, 6, 5}}));
    EXPECT_EQ(scene->meshes[1].indices, (std::vector<std::uint32_t>{2, 0, 1}));
}

TEST(GltfGeometry, ACameraIsPlacedByItsNodeWithoutTheNodesScale)
{
    const SceneBuffers buffers = evaluateData("cameras.gltf");
    ASSERT_EQ(buffers.cameras.size(), 2u);
    const Camera& eye = buffers.cameras[0];
    EXPECT_EQ(eye.name, "eye");
    EXPECT_EQ(eye.eyeWorld, (Vec3d{1, 2, 3}));
    expectNear(eye.targetWorld, {0, 2, 3}, 1e-12); // -z turned by 90 degrees about y
    expectNear(eye.up, {0, 1, 0}, 1e-12);
    EXPECT_EQ(eye.fovy, 0.5);
    EXPECT_EQ(eye.near, 0.1);
    EXPECT_TRUE(std::isinf(eye.far));
    EXPECT_EQ(buffers.cameras[1].orthographicHeight, 6);
    EXPECT_EQ(buffers.cameras[1].far, 50);
}

TEST(GltfGeometry, LightsArePlacedByTheirNodesAndTheBrightestOfAUnitIsOne)
{
    const SceneBuffers buffers = evaluateData("lights.gltf");
    ASSERT_EQ(buffers.lights.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(buffers.lights[i].positionWorld, (Vec3d{double(i), 0, 0}));
        expectNear(buffers.lights[i].directionWorld, {0, -1, 0}, 1e-12); // -z turned by -90 degrees about x
    }
    const std::vector<Light>& lights = buffers.lights;
    EXPECT_EQ(lights[0].kind, LightKind::Directional);
    EXPECT_EQ(lights[0].name, "sun");
    EXPECT_EQ(lights[0].colour, (Vec3d{1, 0.5, 0.25}));
    EXPECT_EQ(lights[1].colour, (Vec3d{0.25, 0.25, 0.25}));
    EXPECT_EQ(lights[2].kind, LightKind::Spot);
    EXPECT_EQ(lights[2].coneAngle, 1.0);
    EXPECT_EQ(lights[2].range, 20);
    EXPECT_EQ(lights[2].colour, (Vec3d{0.25, 0.25, 0.25}));
    EXPECT_EQ(lights[3].kind, LightKind::Point);
    EXPECT_TRUE(std::isinf(lights[3].range));
    EXPECT_EQ(lights[3].colour, (Vec3d{0, 1, 0}));
}

} // namespace
} // namespace lixel::test
