// SPDX-License-Identifier: MIT
// `lixel render`: pictures and channels.
#include "report/sample_results.h"
#include "run_command.h"
#include "support/scene_files.h"

#include "lixel/base/view.h"
#include "lixel/report/exr.h"
#include "lixel/report/png.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <numbers>

namespace lixel::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr int kSide = 48;

std::string dataFile(const char* name) { return (dataFolder() / name).string(); }

class Render : public ::testing::Test
{
protected:
    // Renders by the CPU executor, 48x48, unless `words` say otherwise.
    CommandResult render(const std::string& scene, const Words& words)
    {
        Words all{"render", scene, "--size", "48x48", "--lixels", "128x128", "--executor", "trace"};
        all.insert(all.end(), words.begin(), words.end());
        CommandOptions options;
        options.folder = folder_.path();
        const CommandResult run = runLixel(all, options);
        EXPECT_EQ(run.exitCode, 0) << asTyped(all) << "\n" << run.err;
        return run;
    }
    Image<Rgba8> picture(const std::string& scene, Words words)
    {
        words.insert(words.end(), {"-o", "picture.png"});
        EXPECT_EQ(render(scene, words).out, "");
        return readPng(folder_.path() / "picture.png");
    }
    ExrPicture channels(const std::string& scene, Words words)
    {
        words.insert(words.end(), {"--exr", "channels.exr"});
        render(scene, words);
        return readExr(folder_.path() / "channels.exr");
    }
    void write(const char* name, const std::string& text) const { std::ofstream(folder_.path() / name) << text; }

    TemporaryFolder folder_;
};

std::vector<std::string> namesOf(const ExrPicture& exr)
{
    std::vector<std::string> names;
    for (const auto& [name, values] : exr.channels) names.push_back(name);
    return names;
}

TEST_F(Render, APictureHasItsSizeAndLitAndShadowedParts)
{
    const Image<Rgba8> shadowed = picture("table", {"--view", "overview"});
    EXPECT_EQ(shadowed.width(), kSide);
    EXPECT_EQ(shadowed.height(), kSide);
    const Image<Rgba8> lit = picture("table", {"--view", "overview", "--light-direction", "0.1,-1,0.1"});
    EXPECT_NE(shadowed.data(), lit.data());
}

TEST_F(Render, StandardOutputTakesTheSamePicture)
{
    const Image<Rgba8> file = picture("table", {"--view", "overview"});
    const CommandResult run = render("table", {"--view", "overview", "-o", "-"});
    EXPECT_EQ(decodePng(run.out, "standard output").data(), file.data());
}

TEST_F(Render, PositionsProjectToTheirPixelsAndDepths)
{
    const ExrPicture exr =
        channels("table", {"--eye", "2.5,2,3", "--target", "0,0.5,0", "--up", "0,1,0", "--fovy", "50", "--near", "0.1",
                           "--far", "30", "--light-direction", "0.3,-1,-0.2"});
    const View view =
        perspectiveView({2.5, 2, 3}, {0, 0.5, 0}, {0, 1, 0}, 50 * std::numbers::pi / 180, 0.1, 30, kSide, kSide);
    ASSERT_EQ(exr.width, kSide);
    ASSERT_EQ(exr.height, kSide);
    int receivers = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const auto at = [&](const char* name) {
                return double(exr.channels.at(name)[std::size_t(y) * kSide + std::size_t(x)]);
            };
            if (at("receiver.A") == 0) {
                EXPECT_TRUE(std::isnan(at("position.X")));
                EXPECT_EQ(at("depth.Z"), 1);
                EXPECT_EQ(at("visibility.V"), 0);
                continue;
            }
            ++receivers;
            const Vec3d pointLocal{at("position.X"), at("position.Y"), at("position.Z")};
            const Vec3d normal{at("normal.X"), at("normal.Y"), at("normal.Z")};
            const Vec3d pixel = pixelFromLocal(view, exr.originWorld, pointLocal);
            EXPECT_NEAR(pixel.x, x + 0.5, 0.01);
            EXPECT_NEAR(pixel.y, y + 0.5, 0.01);
            EXPECT_NEAR(pixel.z, at("depth.Z"), 1e-5);
            EXPECT_NEAR(length(normal), 1, 1e-5);
            EXPECT_GT(dot(normal, towardsEye(view, exr.originWorld, pointLocal)), 0);
            EXPECT_GE(at("visibility.V"), 0);
            EXPECT_LE(at("visibility.V"), 1);
        }
    EXPECT_GT(receivers, kSide * kSide / 2);
}

TEST_F(Render, ExactFootprintAndDensityComeOnRequest)
{
    const Words always{"depth.Z",    "normal.X",   "normal.Y",   "normal.Z",
                       "position.X", "position.Y", "position.Z", "receiver.A"};
    Words plain = always, all = always;
    plain.push_back("visibility.V");
    all.insert(all.end(), {"visibility.V", "exact.V", "footprint.S", "density.S"});
    std::sort(all.begin(), all.end());
    EXPECT_EQ(namesOf(channels("table", {"--view", "overview"})), plain);
    const ExrPicture exr = channels("table", {"--view", "overview", "--exact", "--footprint", "--density"});
    EXPECT_EQ(namesOf(exr), all);

    // The longest axis of a lixel is no shorter than the square root of its area.
    int counted = 0;
    for (std::size_t i = 0; i < exr.channels.at("footprint.S").size(); ++i) {
        const double footprint = exr.channels.at("footprint.S")[i], density = exr.channels.at("density.S")[i];
        const float exact = exr.channels.at("exact.V")[i];
        EXPECT_TRUE(exact == 0 || exact == 1);
        if (!std::isfinite(footprint)) continue;
        ++counted;
        EXPECT_GE(footprint * std::sqrt(density), 1 - 1e-4);
    }
    EXPECT_GT(counted, kSide * kSide / 4);
}

TEST_F(Render, TheExactTechniqueIsExact)
{
    const ExrPicture exr = channels("table", {"--view", "overview", "--technique", "exact", "--exact"});
    EXPECT_EQ(exr.channels.at("visibility.V"), exr.channels.at("exact.V"));
}

TEST_F(Render, SeveralLightsHaveChannelsByName)
{
    const ExrPicture exr = channels("table", {"--view", "two-lights", "--exact", "--density"});
    for (const char* name : {"visibility.sun.V", "visibility.ceiling-spot.V", "exact.sun.V", "exact.ceiling-spot.V",
                             "density.sun.S", "density.ceiling-spot.S"})
        EXPECT_TRUE(exr.channels.contains(name)) << name;
    EXPECT_NE(exr.channels.at("visibility.sun.V"), exr.channels.at("visibility.ceiling-spot.V"));
}

TEST_F(Render, LightsOfAFileThatShareANameAreToldApart)
{
    const ExrPicture exr = channels(dataFile("lights.gltf"), {});
    for (const char* name : {"visibility.sun.V", "visibility.light.V", "visibility.light-2.V", "visibility.light-3.V"})
        EXPECT_TRUE(exr.channels.contains(name)) << name;
}

TEST_F(Render, ALightThatReachesNothingInThePictureHasNoShadowsToMake)
{
    const Words away{"--eye", "1000,1000,1000", "--target", "2000,2000,2000"};
    const Image<Rgba8> empty = picture("table", away);
    const Image<Rgba8> exact =
        picture("table", {"--eye", "1000,1000,1000", "--target", "2000,2000,2000", "--technique", "exact"});
    EXPECT_EQ(empty.data(), exact.data());
    const ExrPicture exr =
        channels("table", {"--eye", "1000,1000,1000", "--target", "2000,2000,2000", "--exact", "--footprint"});
    for (const float covered : exr.channels.at("receiver.A")) EXPECT_EQ(covered, 0);
}

TEST_F(Render, AViewFileGivesCameraAndLights)
{
    write("view.json", R"({"camera": {"eye": [2.5, 2, 3], "target": [0, 0.5, 0], "fovy": 50, "near": 0.1, "far": 30},
                           "lights": [{"direction": [0.3, -1, -0.2]}]})");
    const Words flags{
        "--eye", "2.5,2,3", "--target", "0,0.5,0",           "--up",       "0,1,0", "--fovy", "50", "--near",
        "0.1",   "--far",   "30",       "--light-direction", "0.3,-1,-0.2"};
    const Image<Rgba8> byFile = picture("table", {"--view", "view.json"});
    EXPECT_EQ(byFile.data(), picture("table", flags).data());
    EXPECT_NE(byFile.data(), picture("table", {"--view", "view.json", "--eye", "-2.5,2,3"}).data())
        << "flags override it";
    EXPECT_NE(byFile.data(), picture("table", {"--view", "view.json", "--light-direction", "-0.3,-1,-0.2"}).data());
}

TEST_F(Render, AViewFilesPathIsFollowedInTime)
{
    write("path.json", R"({"camera": {"eye": [0, 1, 3], "target": [0, 0.5, 0]}, "time": 1,
                           "light": {"direction": [0.3, -1, -0.2]},
                           "path": [{"time": 0, "eye": [2, 2, 3], "target": [0, 0.5, 0]},
                                    {"time": 2, "eye": [4, 2, 3], "target": [0, 0.5, 0]}]})");
    const Words halfway{"--eye", "3,2,3",  "--target", "0,0.5,0",           "--up",
                        "0,1,0", "--fovy", "50",       "--light-direction", "0.3,-1,-0.2"};
    const Image<Rgba8> atItsTime = picture("table", {"--view", "path.json"});
    EXPECT_EQ(atItsTime.data(), picture("table", halfway).data());
    EXPECT_NE(atItsTime.data(), picture("table", {"--view", "path.json", "--time", "0"}).data());
}

TEST_F(Render, TimeMovesWhatIsAnimatedAndRepeatsIt)
{
    const auto at = [&](const char* scene, const char* time) { return picture(scene, {"--time", time}).data(); };
    EXPECT_NE(at("bunnies", "0"), at("bunnies", "0.4"));
    const std::string skin = dataFile("skin.glb");
    EXPECT_NE(at(skin.c_str(), "0"), at(skin.c_str(), "0.5"));
    EXPECT_EQ(at(skin.c_str(), "0.5").size(), at(skin.c_str(), "1e300").size());
}

TEST_F(Render, TheScenesPathMovesTheCamera)
{
    const auto along = [&](const char* time) {
        return channels("bunnies", {"--path", "--time", time}).channels.at("position.X");
    };
    EXPECT_NE(along("0"), along("1"));
}

TEST_F(Render, ACameraOfTheFileIsTakenByItsName)
{
    const std::string scene = dataFile("cameras.gltf");
    EXPECT_EQ(picture(scene, {}).data(), picture(scene, {"--view", "eye"}).data());
    picture(scene, {"--view", "camera 1"});
}

TEST_F(Render, WhatAFileHasAndIsLeftOutIsTold)
{
    const CommandResult run = render(dataFile("strip_fan.gltf"), {"-o", "picture.png"});
    EXPECT_EQ(run.err.substr(0, 13), "lixel: note: ");
    EXPECT_NE(run.err.find("points and lines are left out"), std::string::npos);
}

TEST_F(Render, OddNamesAndOnePixelAreFine)
{
    fs::create_directory(folder_.path() / "a b");
    fs::copy_file(dataFolder() / "shared_vertices.gltf", folder_.path() / "a b" / "ünï cödé.gltf");
    EXPECT_EQ(render("a b/ünï cödé.gltf", {"-o", "a b/picture 'ü'.png"}).err, "");
    EXPECT_EQ(readPng(folder_.path() / "a b" / "picture 'ü'.png").width(), kSide);

    CommandOptions options;
    options.folder = folder_.path();
    EXPECT_EQ(
        runLixel({"render", "table", "--size", "1x1", "--lixels", "1x1", "--executor", "trace", "-o", "one"}, options)
            .exitCode,
        0);
    EXPECT_EQ(readPng(folder_.path() / "one").height(), 1);
}

// Exporters that put all meshes into one view are many; it is not read anew for each.
TEST_F(Render, ManyAccessorsOfOneLargeViewAreReadAtOnce)
{
    constexpr int kCount = 100, kStep = 1 << 20;
    std::string accessors, primitives;
    for (int i = 0; i < kCount; ++i) {
        accessors +=
            fmt::format(R"({}{{"bufferView": 0, "byteOffset": {}, "componentType": 5126, "count": 3, "type": "VEC3"}})",
                        i > 0 ? "," : "", i * kStep);
        primitives += fmt::format(R"({}{{"attributes": {{"POSITION": {}}}}})", i > 0 ? "," : "", i);
    }
    const std::string text = fmt::format(
        R"({{"asset": {{"version": "2.0"}}, "scenes": [{{"nodes": [0]}}], "nodes": [{{"mesh": 0}}], "meshes": [{{"primitives": [{}]}}],
             "accessors": [{}], "bufferViews": [{{"buffer": 0, "byteLength": {}}}], "buffers": [{{"byteLength": {}, "uri": "many.bin"}}]}})",
        primitives, accessors, kCount * kStep, kCount * kStep);
    write("many.gltf", text);
    std::ofstream bin(folder_.path() / "many.bin", std::ios::binary);
    for (int i = 0; i < kCount; ++i) {
        const float x = float(i % 10), z = float(i / 10);
        const float triangle[] = {x, 0, z, x, 0, z + 1, x + 1, 0, z};
        bin.seekp(i * kStep);
        bin.write(reinterpret_cast<const char*>(triangle), sizeof triangle);
    }
    bin.close();
    std::filesystem::resize_file(folder_.path() / "many.bin", std::uintmax_t(kCount) * kStep);
    const std::vector<float> seen = channels("./many.gltf", {}).channels.at("receiver.A");
    EXPECT_GT(std::count(seen.begin(), seen.end(), 1.0f), 10);
}

TEST_F(Render, AMaterialFileIsReadOnceHoweverOftenItIsNamed)
{
    std::string text;
    for (int i = 0; i < 1000; ++i) text += i % 2 == 0 ? "mtllib none.mtl\n" : "mtllib ./none.mtl\n";
    write("named.obj", text + "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 3 2 1\n");
    const std::string notes = render("./named.obj", {"-o", "picture.png"}).err;
    EXPECT_EQ(std::count(notes.begin(), notes.end(), '\n'), 1) << notes;
    EXPECT_NE(notes.find("none.mtl: no such file"), std::string::npos) << notes;
}

} // namespace
} // namespace lixel::test
