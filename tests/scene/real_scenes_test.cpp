// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "scene/loaded.h"

#include <chrono>

namespace lixel::test {
namespace {

// What the folder's own list states: triangles with instances counted; bounds at rest, skins not applied. Of the diorama's
// 141,802 triangles three outline shells of 40,734, 9,124 and 2,966 are left out.
struct RealScene
{
    const char* file;
    std::size_t triangles, animations;
    Vec3d min, max;
    bool isSkinned = false;
    std::size_t warnings = 0;
};

const RealScene kRealScenes[] = {
    {"sponza_crytek.glb", 262267, 0, {-19.21, -1.26, -11.83}, {18, 14.29, 11.05}},
    {"conference.glb", 277552, 0, {-3.06, -0.01, -3.17}, {5.06, 1.95, 2.01}},
    {"sibenik.glb", 75275, 0, {-20.14, -15.31, -8.5}, {20.14, 15.3, 8.5}},
    {"fireplace_room.glb", 105299, 0, {-0.7, -0.15, -4.02}, {6.29, 3.05, 2.18}},
    {"staircase_hall.glb", 30911, 0, {-21.72, -3.69, -3.08}, {7.16, 11.28, 6.95}},
    {"littlest_tokyo.glb", 88978, 1, {-2.75, -0.12, -2.8}, {2.71, 5.87, 2.72}, true, 1},
    {"heightmap_terrain.glb", 1048352, 0, {-1000, 0, -1000}, {1000, 188.32, 1000}},
    {"jacksboro_terrain.glb", 275772, 0, {-14971.44, 236, -15909.48}, {14971.44, 1076, 15909.48}},
    {"mjp_columns.glb", 16638, 0, {-814.8, -13.75, -59.39}, {110.97, 18.77, 58.81}},
    {"cesium_shadow_tester_4.glb", 2400, 0, {-201, 0, -201}, {205, 34, 205}},
    {"wood_tower.glb", 2036, 0, {-13.27, 0, -13.27}, {13.27, 48.08, 13.27}},
    {"hospital_electrical.glb", 153990, 0, {-48.4, 0, -46.12}, {48.4, 27.73, 46.12}},
    {"oaktree.glb", 5302, 0, {-3.85, 0, -4.09}, {3.64, 9.63, 3.01}},
    {"cesium_man.glb", 4672, 1, {-0.13, 0, -0.57}, {0.18, 1.51, 0.57}, true},
    {"cesium_milk_truck.glb", 3624, 1, {-2.43, 0, -1.4}, {2.44, 2.58, 1.4}},
    {"fox.glb", 576, 3, {-0.13, 0, -0.88}, {0.13, 0.79, 0.67}, true},
    {"robot_expressive.glb", 3237, 14, {-1.32, -0.01, -0.34}, {1.32, 1.84, 0.71}, true},
    {"stanford_bunny.glb", 69451, 0, {-0.09, 0.03, -0.06}, {0.06, 0.19, 0.06}},
    {"stanford_dragon.glb", 202520, 0, {-0.11, 0.05, -0.05}, {0.1, 0.2, 0.04}},
    {"armadillo.glb", 86482, 0, {-0.44, -0.57, -0.38}, {0.4, 0.43, 0.38}},
    {"nefertiti.glb", 99938, 0, {-0.12, -0.25, -0.18}, {0.12, 0.25, 0.18}},
    {"utah_teapot.glb", 6320, 0, {-0.15, 0, -0.1}, {0.17, 0.16, 0.1}},
};

class RealScenes : public testing::TestWithParam<RealScene>
{
};

std::size_t trianglesWithArea(const Mesh& mesh)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vec3d a = toDouble(mesh.position[mesh.indices[i]]), b = toDouble(mesh.position[mesh.indices[i + 1]]),
                    c = toDouble(mesh.position[mesh.indices[i + 2]]);
        count += cross(b - a, c - a) != Vec3d{};
    }
    return count;
}

TEST_P(RealScenes, LoadWithTheTrianglesAndBoundsTheirListStates)
{
    const RealScene& expected = GetParam();
    LX_SKIP_WITHOUT_SCENE(expected.file);
    const auto scene = std::make_shared<const Scene>(loadScene((sceneFolder() / expected.file).string()));
    EXPECT_EQ(scene->animations.size(), expected.animations);
    EXPECT_EQ(scene->warnings.size(), expected.warnings);

    std::size_t inFile = 0, withArea = 0;
    for (const Node& node : scene->nodes)
        for (const int m : node.meshes) {
            inFile += scene->meshes[std::size_t(m)].indices.size() / 3;
            withArea += trianglesWithArea(scene->meshes[std::size_t(m)]);
        }
    EXPECT_EQ(inFile, expected.triangles);

    const Box box = sceneBounds(*scene, {});
    const SceneBuffers buffers = evaluate(scene, {}, chooseOrigin(box.centre(), box));
    EXPECT_LE(buffers.triangles.triangleCount(), withArea);
    EXPECT_GE(buffers.triangles.triangleCount() + 10, withArea); // some lose it by rounding
    if (expected.isSkinned) return;
    expectNear(box.min, expected.min, 0.01);
    expectNear(box.max, expected.max, 0.01);
    expectNear(buffers.bounds.total().min, expected.min, 0.01);
    expectNear(buffers.bounds.total().max, expected.max, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Each, RealScenes, testing::ValuesIn(kRealScenes), [](const auto& of) {
    const std::string file = of.param.file;
    return file.substr(0, file.find('.'));
});

TEST(RealScenesInMotion, WalkingPeopleStayWithinReachOfTheirRestPose)
{
    for (const char* file : {"cesium_man.glb", "fox.glb", "robot_expressive.glb"}) {
        LX_SKIP_WITHOUT_SCENE(file);
        const auto scene = std::make_shared<const Scene>(loadScene((sceneFolder() / file).string()));
        for (int animation = 0; animation < int(scene->animations.size()); ++animation) {
            const double first = sceneBounds(*scene, {0, animation}).diagonal();
            for (const double time : {0.25, 0.5, 0.75, 100.0}) {
                const Box box = sceneBounds(*scene, {time, animation});
                EXPECT_GT(box.diagonal(), 0.5 * first) << file << " " << animation << " at " << time;
                EXPECT_LT(box.diagonal(), 2 * first) << file << " " << animation << " at " << time;
            }
        }
    }
}

} // namespace
} // namespace lixel::test
