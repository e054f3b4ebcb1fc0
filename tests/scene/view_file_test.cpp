// SPDX-License-Identifier: MIT
#include "lixel/scene/view_file.h"

#include "lixel/scene/load.h"

#include "support/random_cases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>

namespace lixel::test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

std::string messageOf(const std::string& text)
{
    try {
        parseViewFile(text, "view.json");
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

void expectNear(Vec3d a, Vec3d b, double tolerance = 1e-15)
{
    EXPECT_LE(length(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(ViewFile, EveryMemberArrivesInItsPlace)
{
    const ViewFile file = parseViewFile(R"({
        "camera": {"eye": [1, 2, 3], "target": [4, 5, 6], "up": [0, 2, 0], "fovy": 30, "near": 0.5, "far": 100},
        "lights": [
            {"name": "sun", "direction": [0, -3, 4]},
            {"position": [7, 8, 9], "range": 12},
            {"name": "stage", "position": [1, 1, 1], "direction": [0, -2, 0], "angle": 40, "range": 5}],
        "planes": [
            {"name": "floor", "point": [0, 1, 0], "normal": [0, 2, 0]},
            {"name": "table", "point": [0, 1, 0], "normal": [0, 1, 0], "polygon": [[0, 1, 0], [1, 1, 0], [0, 1, 1]]}],
        "time": 2.5,
        "path": [
            {"time": 0, "eye": [0, 0, 0], "target": [0, 0, -1], "light": [0, -2, 0]},
            {"time": 2, "eye": [2, 0, 0], "target": [2, 0, -1], "light": {"direction": [-1, 0, 0]}}]})",
                                        "view.json");
    ASSERT_TRUE(file.camera);
    EXPECT_EQ(file.camera->eyeWorld, (Vec3d{1, 2, 3}));
    EXPECT_EQ(file.camera->targetWorld, (Vec3d{4, 5, 6}));
    EXPECT_EQ(file.camera->up, (Vec3d{0, 1, 0}));
    EXPECT_DOUBLE_EQ(file.camera->fovy, 30 * kDegree);
    EXPECT_EQ(file.camera->near, 0.5);
    EXPECT_EQ(file.camera->far, 100);
    EXPECT_EQ(file.camera->orthographicHeight, 0);

    ASSERT_EQ(file.lights.size(), 3u);
    EXPECT_EQ(file.lights[0].kind, LightKind::Directional);
    EXPECT_EQ(file.lights[0].name, "sun");
    expectNear(file.lights[0].directionWorld, {0, -0.6, 0.8});
    EXPECT_EQ(file.lights[1].kind, LightKind::Point);
    EXPECT_EQ(file.lights[1].name, "light-2");
    EXPECT_EQ(file.lights[1].positionWorld, (Vec3d{7, 8, 9}));
    EXPECT_EQ(file.lights[1].range, 12);
    EXPECT_EQ(file.lights[2].kind, LightKind::Spot);
    EXPECT_DOUBLE_EQ(file.lights[2].coneAngle, 40 * kDegree);
    EXPECT_EQ(file.lights[2].range, 5);
    expectNear(file.lights[2].directionWorld, {0, -1, 0});

    ASSERT_EQ(file.planes.size(), 2u);
    EXPECT_EQ(file.planes[0].name, "floor");
    EXPECT_EQ(file.planes[0].normalWorld, (Vec3d{0, 1, 0}));
    EXPECT_TRUE(file.planes[0].polygonWorld.empty());
    EXPECT_EQ(file.planes[1].polygonWorld.size(), 3u);
    EXPECT_EQ(file.time, 2.5);

    ASSERT_EQ(file.path.size(), 2u);
    EXPECT_EQ(file.path[0].lightDirectionWorld, (Vec3d{0, -1, 0}));
    EXPECT_EQ(file.path[1].lightDirectionWorld, (Vec3d{-1, 0, 0}));
    EXPECT_FALSE(file.path[1].lightPositionWorld);
}

TEST(ViewFile, AnEmptyObjectLeavesEverythingToOthers)
{
    const ViewFile file = parseViewFile("{}", "view.json");
    EXPECT_FALSE(file.camera || file.time);
    EXPECT_TRUE(file.lights.empty() && file.planes.empty() && file.path.empty());
}

TEST(ViewFile, WhatACameraLeavesOutTakesTheStandard)
{
    const Camera camera = *parseViewFile(R"({"camera": {"eye": [0, 0, 5], "target": [0, 0, 0]}})", "view.json").camera;
    const Camera standard;
    EXPECT_EQ(camera.up, standard.up);
    EXPECT_EQ(camera.fovy, standard.fovy);
    EXPECT_EQ(camera.near, 0);
    EXPECT_TRUE(std::isinf(camera.far));
}

TEST(ViewFile, OneLightMayStandAlone)
{
    const ViewFile file = parseViewFile(R"({"light": {"position": [0, 5, 0]}})", "view.json");
    ASSERT_EQ(file.lights.size(), 1u);
    EXPECT_EQ(file.lights[0].name, "light");
    EXPECT_EQ(file.lights[0].kind, LightKind::Point);
    EXPECT_TRUE(std::isinf(file.lights[0].range));
}

TEST(ViewFile, AnOrthographicCameraHasAHeight)
{
    const ViewFile file = parseViewFile(
        R"({"camera": {"eye": [0, 9, 0], "target": [0, 0, 0], "up": [0, 0, -1], "orthographic": 12}})", "view.json");
    EXPECT_EQ(file.camera->orthographicHeight, 12);
}

TEST(ViewFile, EveryMistakeIsNamedWithItsPlace)
{
    const std::string camera = R"({"camera": {"eye": [0, 0, 5], "target": [0, 0, 0])";
    const std::string path = R"({"path": [{"time": 0, "eye": [0, 0, 1], "target": [0, 0, 0]}, )";
    const struct
    {
        std::string text, expected;
    } cases[] = {
        {"", "view.json: line 1, column 1: expected JSON"},
        {"{\n \"time\": oops}", "view.json: line 2, column 10: expected JSON"},
        {"[]", "view.json: /: expected an object with members from: camera, light"},
        {R"({"camra": {}})", "view.json: /: member \"camra\" is unknown; expected: camera"},
        {R"({"time": 1, "time": 2})", "member \"time\" is given twice"},
        {R"({"time": 1e999})", "view.json: expected numbers that fit a double"},
        {R"({"time": "noon"})", "view.json: /time: expected a number"},
        {R"({"time": true})", "view.json: /time: expected a number"},
        {R"({"time": -1})", "view.json: /time: expected a time of at least 0"},
        {R"({"camera": {"target": [0, 0, 0]}})", "view.json: /camera: expected a member \"eye\""},
        {R"({"camera": {"eye": [0, 0, 1]}})", "view.json: /camera: expected a member \"target\""},
        {R"({"camera": {"eye": [0, 0], "target": [0, 0, 0]}})", "view.json: /camera/eye: expected three numbers"},
        {R"({"camera": {"eye": [0, null, 0], "target": [0, 0, 0]}})", "view.json: /camera/eye/1: expected a number"},
        {R"({"camera": {"eye": [0, 1e13, 0], "target": [0, 0, 0]}})",
         "view.json: /camera/eye/1: expected a number of at most"},
        {R"({"camera": {"eye": [1, 2, 3], "target": [1, 2, 3]}})",
         "view.json: /camera: expected eye and target to be different"},
        {R"({"camera": {"eye": [0, 5, 0], "target": [0, 0, 0]}})",
         "view.json: /camera: expected up not to be zero or along"},
        {camera + R"(, "up": [0, 0, 0]}})", "view.json: /camera/up: expected a direction"},
        {camera + R"(, "fov": 50}})", "view.json: /camera: member \"fov\" is unknown; expected: eye, target, up, fovy"},
        {camera + R"(, "fovy": 0}})", "view.json: /camera/fovy: expected a number greater than 0"},
        {camera + R"(, "fovy": 180}})", "view.json: /camera: expected fovy to be more than 0 and less than 180"},
        {camera + R"(, "fovy": 400}})", "view.json: /camera: expected fovy to be more than 0 and less than 180"},
        {camera + R"(, "near": 0}})", "view.json: /camera/near: expected a number greater than 0"},
        {camera + R"(, "near": 1e-300}})", "view.json: /camera: expected near to be at least"},
        {camera + R"(, "near": 5, "far": 5}})", "view.json: /camera: expected far to be greater than near"},
        {camera + R"(, "far": -5}})", "view.json: /camera/far: expected a number greater than 0"},
        {camera + R"(, "orthographic": 0}})", "view.json: /camera/orthographic: expected a number greater than 0"},
        {camera + R"(, "orthographic": 5, "fovy": 20}})",
         "view.json: /camera: expected one of \"fovy\" and \"orthographic\""},
        {R"({"light": {}})", "view.json: /light: expected \"position\", \"direction\", or both with \"angle\""},
        {R"({"light": {"direction": [0, 0, 0]}})", "view.json: /light/direction: expected a direction, not [0, 0, 0]"},
        {R"({"light": {"direction": [0, -1, 0], "range": 3}})", "view.json: /light/range: expected no range"},
        {R"({"light": {"position": [0, 0, 0], "range": 0}})",
         "view.json: /light/range: expected a number greater than 0"},
        {R"({"light": {"position": [0, 0, 0], "angle": 30}})",
         "view.json: /light/angle: expected no angle but of a spot"},
        {R"({"light": {"position": [0, 0, 0], "direction": [0, 1, 0]}})", "view.json: /light: expected \"angle\""},
        {R"({"light": {"position": [0, 0, 0], "direction": [0, 1, 0], "angle": 180}})",
         "view.json: /light: expected an angle of more than 0 and less"},
        {R"({"light": {"position": [0, 0, 0], "direction": [0, 1, 0], "angle": 0}})",
         "view.json: /light/angle: expected a number greater than 0"},
        {R"({"light": {"name": "a b", "position": [0, 0, 0]}})", "view.json: /light/name: expected a name of letters"},
        {R"({"lights": []})", "view.json: /lights: expected an array of at least 1"},
        {R"({"lights": {"position": [0, 0, 0]}})", "view.json: /lights: expected an array"},
        {R"({"light": {"position": [0, 0, 0]}, "lights": [{"position": [0, 0, 0]}]})",
         "view.json: /: expected one of \"light\" and \"lights\""},
        {R"({"lights": [{"name": "a", "position": [0, 0, 0]}, {"name": "a", "position": [1, 0, 0]}]})",
         "view.json: /lights/1: expected another name"},
        {R"({"planes": [{"name": "floor", "point": [0, 0, 0]}]})",
         "view.json: /planes/0: expected a member \"normal\""},
        {R"({"planes": [{"point": [0, 0, 0], "normal": [0, 1, 0]}]})",
         "view.json: /planes/0: expected a member \"name\""},
        {R"({"planes": [{"name": "floor", "point": [0, 0, 0], "normal": [0, 0, 0]}]})",
         "view.json: /planes/0/normal: expected a direction"},
        {R"({"planes": [{"name": "f", "point": [0, 0, 0], "normal": [0, 1, 0], "polygon": [[0, 0, 0], [1, 0, 0]]}]})",
         "view.json: /planes/0/polygon: expected an array of at least 3"},
        {R"({"planes": [{"name": "f", "point": [0, 0, 0], "normal": [0, 1, 0], "polygon": [[0, 0, 0], [1, 0, 0], [0, 1, 1]]}]})",
         "view.json: /planes/0/polygon: expected corners in the plane"},
        {R"({"planes": [{"name": "f", "point": [0, 0, 0], "normal": [0, 1, 0]}, {"name": "f", "point": [0, 1, 0], "normal": [0, 1, 0]}]})",
         "view.json: /planes/1: expected another name"},
        {R"({"path": []})", "view.json: /path: expected an array of at least 1"},
        {R"({"path": [{"time": 0, "eye": [0, 0, 0], "target": [0, 0, 0]}]})",
         "view.json: /path/0: expected eye and target"},
        {R"({"path": [{"eye": [0, 0, 1], "target": [0, 0, 0]}]})", "view.json: /path/0: expected a member \"time\""},
        {R"({"path": [{"time": -1, "eye": [0, 0, 1], "target": [0, 0, 0]}]})",
         "view.json: /path/0/time: expected a time of at least 0"},
        {path + R"({"time": 0, "eye": [0, 0, 1], "target": [0, 0, 0]}]})",
         "view.json: /path/1: expected a time after that of the key before"},
        {path + R"({"time": 1, "eye": [0, 0, -1], "target": [0, 0, 0]}]})",
         "view.json: /path/1: expected eye and target not to meet"},
        {path + R"({"time": 1, "eye": [0, 0, 1], "target": [0, 0, 0], "light": {"position": [0, 1, 0]}}]})",
         "view.json: /path/1: expected a light of the same kind in every key"},
        {path + R"({"time": 1, "eye": [0, 0, 1], "target": [0, 0, 0], "light": [0, 1, 0]}]})",
         "view.json: /path/1/light: expected {\"position\": ...} or {\"direction\": ...}"},
        {path + R"({"time": 1, "eye": [0, 0, 1], "target": [0, 0, 0], "light": {}}]})",
         "view.json: /path/1/light: expected \"position\" or \"direction\""},
        {R"({"light": {"direction": [0, -1, 0]}, "path": [{"time": 0, "eye": [0, 0, 1], "target": [0, 0, 0], "light": {"position": [0, 1, 0]}}]})",
         "view.json: /path/0/light/position: expected \"direction\""},
        {R"({"light": {"position": [0, 1, 0]}, "path": [{"time": 0, "eye": [0, 0, 1], "target": [0, 0, 0], "light": {"direction": [0, 1, 0]}}]})",
         "view.json: /path/0/light/direction: expected \"position\""},
        {R"({"light": {"direction": [0, -1, 0]}, "path": [{"time": 0, "eye": [0, 0, 1], "target": [0, 0, 0], "light": [0, 1, 0]}, {"time": 1, "eye": [0, 0, 1], "target": [0, 0, 0], "light": [0, -1, 0]}]})",
         "view.json: /path/1: expected a light direction that is not opposite"},
        {"{\"camera\": \"\xff\"}", "view.json: line 1, column"},
    };
    for (const auto& c : cases) {
        const std::string message = messageOf(c.text);
        EXPECT_EQ(message.rfind("view.json: ", 0), 0u) << message;
        EXPECT_NE(message.find(c.expected), std::string::npos)
            << c.text << "\n  says     " << message << "\n  expected " << c.expected;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
}

TEST(ViewFile, AMissingFileIsAnInputErrorWithItsName)
{
    try {
        readViewFile("no/such/view.json");
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("no/such/view.json"), std::string::npos) << error.what();
    }
}

TEST(ViewFile, AFileReadsAsItsText)
{
    const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / "lixel_view_file_test.json";
    std::ofstream(path) << R"({"time": 3})";
    EXPECT_EQ(readViewFile(path.string()).time, 3);
    std::filesystem::remove(path);
}

TEST(ViewFile, NoBytesBreakTheReader)
{
    const std::string good =
        R"({"camera": {"eye": [1, 2, 3], "target": [4, 5, 6]}, "light": {"position": [1, 2, 3]}, "path": [{"time": 0, "eye": [0, 0, 1], "target": [0, 0, 0]}]})";
    forEachCase(kCases, [&](Rng& rng) {
        std::string text = good.substr(0, std::size_t(rng.integer(0, int(good.size()))));
        for (int i = rng.integer(0, 4); i > 0 && !text.empty(); --i)
            text[std::size_t(rng.integer(0, int(text.size()) - 1))] = char(rng.integer(0, 255));
        try {
            parseViewFile(text, "view.json");
        } catch (const InputError&) {
        }
    });
    EXPECT_NE(messageOf(std::string(100000, '[')), "no error");
}

TEST(CheckCamera, NumbersThatAreNotFiniteAreRefused)
{
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
    Camera good;
    good.eyeWorld = {0, 0, 5};
    ASSERT_EQ(checkCamera(good), std::nullopt);
    for (double bad : {nan, infinite, -infinite}) {
        Camera camera = good;
        camera.eyeWorld.x = bad;
        EXPECT_TRUE(checkCamera(camera));
        camera = good, camera.targetWorld.y = bad;
        EXPECT_TRUE(checkCamera(camera));
        camera = good, camera.up.z = bad;
        EXPECT_TRUE(checkCamera(camera));
        camera = good, camera.fovy = bad;
        EXPECT_TRUE(checkCamera(camera));
        camera = good, camera.near = bad;
        EXPECT_TRUE(checkCamera(camera));
        camera = good, camera.orthographicHeight = bad;
        EXPECT_TRUE(checkCamera(camera));
    }
    Camera camera = good;
    camera.far = nan;
    EXPECT_TRUE(checkCamera(camera));
    camera = good, camera.orthographicHeight = -1;
    EXPECT_TRUE(checkCamera(camera));
}

TEST(CheckLight, OnlyWhatItsKindUsesCounts)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Light light;
    light.positionWorld = {nan, 0, 0};
    EXPECT_EQ(checkLight(light), std::nullopt);
    light.kind = LightKind::Point;
    EXPECT_TRUE(checkLight(light));
    light.positionWorld = {};
    light.directionWorld = {0, 0, 0};
    EXPECT_EQ(checkLight(light), std::nullopt);
    light.kind = LightKind::Spot;
    EXPECT_TRUE(checkLight(light));
    light.directionWorld = {0, -1, 0};
    EXPECT_EQ(checkLight(light), std::nullopt);
    light.range = nan;
    EXPECT_TRUE(checkLight(light));
}

TEST(Path, IsLinearBetweenKeysAndHeldBeyondThem)
{
    const ViewFile file = parseViewFile(R"({"light": {"position": [0, 9, 0]}, "path": [
        {"time": 1, "eye": [0, 0, 5], "target": [0, 0, 0], "light": [0, 1, 0]},
        {"time": 3, "eye": [4, 0, 5], "target": [2, 0, 0], "light": [0, 3, 0]},
        {"time": 4, "eye": [4, 8, 5], "target": [2, 0, 0], "light": [0, 3, 2]}]})",
                                        "view.json");
    const auto at = [&](double time) { return keyAt(file.path, time); };
    EXPECT_EQ(at(0).eyeWorld, (Vec3d{0, 0, 5}));
    EXPECT_EQ(at(1).eyeWorld, (Vec3d{0, 0, 5}));
    EXPECT_EQ(at(2).eyeWorld, (Vec3d{2, 0, 5}));
    EXPECT_EQ(at(2).targetWorld, (Vec3d{1, 0, 0}));
    EXPECT_EQ(at(2).lightPositionWorld, (Vec3d{0, 2, 0}));
    EXPECT_EQ(at(3).eyeWorld, (Vec3d{4, 0, 5}));
    EXPECT_EQ(at(3.5).eyeWorld, (Vec3d{4, 4, 5}));
    EXPECT_EQ(at(99).lightPositionWorld, (Vec3d{0, 3, 2}));

    Camera base;
    base.fovy = 0.3;
    const Camera camera = cameraAt(file.path, 2, base);
    EXPECT_EQ(camera.eyeWorld, (Vec3d{2, 0, 5}));
    EXPECT_EQ(camera.fovy, 0.3);
    EXPECT_EQ(lightsAt(file.path, 2, file.lights).at(0).positionWorld, (Vec3d{0, 2, 0}));
    EXPECT_TRUE(lightsAt(file.path, 2, {}).empty());
}

TEST(Path, ALightTakesTheKindThatItsPathMoves)
{
    PathKey key;
    key.lightPositionWorld = Vec3d{1, 2, 3};
    Light sunlight;
    EXPECT_EQ(lightsAt({&key, 1}, 0, {sunlight}).at(0).kind, LightKind::Point);
    key.lightPositionWorld.reset();
    key.lightDirectionWorld = Vec3d{0, -1, 0};
    Light bulb;
    bulb.kind = LightKind::Point;
    EXPECT_EQ(lightsAt({&key, 1}, 0, {bulb}).at(0).kind, LightKind::Directional);
    bulb.kind = LightKind::Spot;
    EXPECT_EQ(lightsAt({&key, 1}, 0, {bulb}).at(0).kind, LightKind::Spot);
}

TEST(Path, DirectionsStayUnit)
{
    forEachCase(kCases, [](Rng& rng) {
        std::vector<PathKey> path(2);
        path[1].time = 1;
        for (PathKey& key : path) key.lightDirectionWorld = rng.onSphere();
        if (length(*path[0].lightDirectionWorld + *path[1].lightDirectionWorld) < 1e-6) return;
        EXPECT_NEAR(length(*keyAt(path, rng.uniform(-1, 2)).lightDirectionWorld), 1, 1e-14);
    });
}

} // namespace
} // namespace lixel::test
