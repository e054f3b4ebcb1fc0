// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "lixel/scene/triangulate.h"
#include "scene/loaded.h"
#include "support/random_cases.h"

#include <algorithm>

namespace lixel::test {
namespace {

const Node& nodeNamed(const Scene& scene, const std::string& name)
{
    return *std::find_if(scene.nodes.begin(), scene.nodes.end(), [&](const Node& node) { return node.name == name; });
}

double areaOf(const Mesh& mesh)
{
    double area = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vec3d a = toDouble(mesh.position[mesh.indices[i]]), b = toDouble(mesh.position[mesh.indices[i + 1]]),
                    c = toDouble(mesh.position[mesh.indices[i + 2]]);
        area += length(cross(b - a, c - a)) / 2;
    }
    return area;
}

TEST(Obj, GroupsPolygonsAndNegativeIndicesAreRead)
{
    const auto scene = loadData("room.obj");
    EXPECT_EQ(scene->name, "room");
    const Mesh& floor = scene->meshes.at(std::size_t(nodeNamed(*scene, "floor").meshes.at(0)));
    EXPECT_EQ(floor.indices.size(), 6u);
    EXPECT_DOUBLE_EQ(areaOf(floor), 16);
    for (const Vec3f& n : floor.normal) EXPECT_EQ(n, (Vec3f{0, 1, 0}));
    // The wall's corner (2, 1) goes inwards: half of 4 x 3, less the triangle above the bend.
    const Mesh& wall = scene->meshes.at(std::size_t(nodeNamed(*scene, "wall").meshes.at(0)));
    EXPECT_EQ(wall.indices.size(), 9u);
    EXPECT_DOUBLE_EQ(areaOf(wall), 12 - 4);
    EXPECT_TRUE(wall.normal.empty());
    ASSERT_EQ(scene->warnings.size(), 1u);
    EXPECT_NE(scene->warnings[0].find("fewer than 3 corners"), std::string::npos);
}

TEST(Obj, MaterialsHaveTheirColoursMapsAndMasks)
{
    const auto scene = loadData("room.obj");
    const auto materialOf = [&](const char* group) {
        return scene->materials.at(
            std::size_t(scene->meshes.at(std::size_t(nodeNamed(*scene, group).meshes.at(0))).material));
    };
    EXPECT_EQ(materialOf("floor").baseColour, (Vec4f{1, 0, 0, 1}));
    EXPECT_EQ(materialOf("floor").emission, (Vec3f{0, 0, 0.5f}));
    EXPECT_EQ(materialOf("floor").alphaMode, AlphaMode::Opaque);
    const Material tiled = materialOf("wall");
    const Texture& colour = scene->textures.at(std::size_t(tiled.texture));
    EXPECT_EQ(colour.wrapU, Wrap::ClampToEdge);
    EXPECT_EQ(colour.pixels(0, 0).g, 255) << "vt = 0 is the last row of the file";
    EXPECT_EQ(colour.pixels(0, 1).g, 0);
    const Material leaf = materialOf("leaf");
    EXPECT_EQ(leaf.alphaMode, AlphaMode::Mask);
    EXPECT_EQ(leaf.baseColour.w, 0.75f);
    const Texture& alpha = scene->textures.at(std::size_t(leaf.texture));
    EXPECT_EQ(alpha.pixels(0, 0).a, 200);
    EXPECT_EQ(alpha.pixels(0, 1).a, 0);
    EXPECT_EQ(alpha.pixels(0, 1).r, 255);
}

TEST(Obj, TextureOptionsScaleAndMoveTheUv)
{
    const auto scene = loadData("room.obj");
    const Mesh& wall = scene->meshes.at(std::size_t(nodeNamed(*scene, "wall").meshes.at(0)));
    for (const Vec2f& uv : wall.uv) { // corners at 0 and 1, scaled by (2, 3), moved by (1/2, 1/4)
        EXPECT_TRUE(uv.x == 0.5f || uv.x == 2.5f) << uv.x;
        EXPECT_TRUE(uv.y == 0.25f || uv.y == 3.25f) << uv.y;
    }
}

TEST(Obj, WithoutItsMaterialFileItIsGreyAndSaysSo)
{
    const auto scene = loadData("no_mtl.obj");
    EXPECT_EQ(scene->materials.at(std::size_t(scene->meshes.at(0).material)).baseColour, Material{}.baseColour);
    ASSERT_EQ(scene->warnings.size(), 1u);
    EXPECT_NE(scene->warnings[0].find("nowhere.mtl: no such file; its materials are grey"), std::string::npos);
}

TEST(Obj, FacesMayNameVerticesThatStandFurtherDownAndLinesMayEndInAnyWay)
{
    const std::string bodies[] = {"f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0", "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n",
                                  "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3",
                                  "v 0 0 0\nv 1 \\\n 0 0\nv\t0 1 0 # up\nf 1 2 3 "};
    for (const std::string& body : bodies) {
        EXPECT_EQ(loadObj(body, "a.obj", "").meshes.at(0).position,
                  (std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}))
            << body;
    }
}

// A star-shaped polygon in any plane: the triangles' areas, with sign, add up to the polygon's.
TEST(Triangulate, CoversAnyStarShapedPolygonOnce)
{
    forEachCase(kCases, [](Rng& rng) {
        const int n = rng.integer(3, 24);
        const Vec3d normal = rng.onSphere(), s = anyPerpendicular(normal), t = cross(normal, s), centre = rng.inBox(10);
        std::vector<Vec3d> corners;
        for (int i = 0; i < n; ++i) {
            const double angle = 6.283185307179586 * i / n, radius = rng.uniform(0.2, 3);
            corners.push_back(centre + radius * (std::cos(angle) * s + std::sin(angle) * t));
        }
        std::vector<std::uint32_t> triangles;
        triangulatePolygon(corners, triangles);
        ASSERT_EQ(triangles.size(), 3 * (corners.size() - 2));
        double area = 0, expected = 0;
        for (std::size_t i = 0; i < triangles.size(); i += 3) {
            const Vec3d a = corners[triangles[i]], b = corners[triangles[i + 1]], c = corners[triangles[i + 2]];
            area += length(cross(b - a, c - a)) / 2;
        }
        for (std::size_t i = 0; i < corners.size(); ++i)
            expected += dot(normal, cross(corners[i] - centre, corners[(i + 1) % corners.size()] - centre)) / 2;
        EXPECT_NEAR(area, expected, 1e-9);
    });
}

// Text is read a mebibyte at a time: ends of lines, continued lines and numbers may lie across the border.
TEST(Obj, LinesMayLieAcrossTheBlocksThatAreRead)
{
    for (const std::string end : {"\n", "\r\n", "\r"})
        for (int shift = -24; shift <= 8; ++shift) {
            const std::string comment(std::size_t((1 << 20) + shift) - end.size(), '#');
            const Scene scene =
                loadObj(comment + end + "v 0 0\\" + end + " 0" + end + "v 1 0 0" + end + "v 0 1.25 0" + end + "f 1 2 3",
                        "a.obj", "");
            ASSERT_EQ(scene.meshes.size(), 1u);
            EXPECT_EQ(scene.meshes[0].position, (std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}, {0, 1.25f, 0}})) << shift;
        }
}

} // namespace
} // namespace lixel::test
