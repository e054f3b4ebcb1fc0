// SPDX-License-Identifier: MIT
// What the command line says no to: one line, the right exit code, at once, and nothing is left behind.
#include "report/sample_results.h"
#include "run_command.h"
#include "support/scene_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace lixel::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr int kFailed = 1, kBadUsage = 2, kBadInput = 3, kNoGraphics = 4, kRefused = 5;

// Seconds of processor time; sanitizers, and builds that are not optimised, take several times as long.
#if defined(__SANITIZE_ADDRESS__) || !defined(__OPTIMIZE__)
constexpr double kAtOnce = 10;
#else
constexpr double kAtOnce = 1;
#endif

// A scene that is read in no time.
std::string room() { return (dataFolder() / "room.obj").string(); }

Words operator+(Words left, const Words& right)
{
    left.insert(left.end(), right.begin(), right.end());
    return left;
}

std::vector<std::string> namesIn(const fs::path& folder)
{
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

// Runs it in a folder of its own and looks at all that a refusal promises. Returns the line without "lixel: ".
class RefusedInput : public ::testing::Test
{
protected:
    std::string refusal(const Words& words, int exitCode, CommandOptions options = {})
    {
        SCOPED_TRACE(asTyped(words));
        const auto before = namesIn(folder_.path());
        options.folder = folder_.path();
        const CommandResult run = runLixel(words, options);
        EXPECT_EQ(run.exitCode, exitCode) << run.err;
        EXPECT_EQ(run.err.substr(0, 7), "lixel: ");
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
        EXPECT_EQ(run.err.back(), '\n');
        EXPECT_EQ(run.out, "");
        EXPECT_LT(run.cpuSeconds, kAtOnce);
        EXPECT_EQ(namesIn(folder_.path()), before) << "something is left behind";
        return run.err.size() > 8 ? run.err.substr(7, run.err.size() - 8) : "";
    }
    std::string renderRefusal(const Words& words, int exitCode)
    {
        return refusal(Words{"render", room(), "-o", "a.png", "--executor", "trace"} + words, exitCode);
    }
    void write(const std::string& name, const std::string& text) const { std::ofstream(folder_.path() / name) << text; }

    TemporaryFolder folder_;
};

void expectMention(const std::string& line, const std::string& word)
{
    EXPECT_NE(line.find(word), std::string::npos) << "\"" << word << "\" is not in: " << line;
}

TEST_F(RefusedInput, CommandsAndOptionsMustBeKnown)
{
    expectMention(refusal({}, kBadUsage), "render, compare, reproduce, study, merge, bench, techniques, scenes");
    expectMention(refusal({"paint"}, kBadUsage), "\"paint\": no such command");
    expectMention(refusal({"--paint"}, kBadUsage), "lixel --help");
    expectMention(refusal({"render"}, kBadUsage), "SCENE");
    for (const char* option : {"--axes", "--techniques"})
        expectMention(refusal({"bench", option, "nonsense", "--json", "-"}, kBadUsage), "nonsense");
    expectMention(renderRefusal({"--paint"}, kBadUsage), "--paint");
    expectMention(renderRefusal({"room.obj"}, kBadUsage), "room.obj");
    expectMention(renderRefusal({"--size", "8x8", "--size", "9x9"}, kBadUsage), "--size");
    expectMention(renderRefusal({"--executor", "gl"}, kBadUsage), "--executor");
    expectMention(refusal({"render", room(), "-o", "a.png", "--executor", "vulkan"}, kBadUsage), "gl,trace");
    expectMention(refusal({"render", room()}, kBadUsage), "-o PICTURE.png, --exr FILE.exr or --plan FILE.json");
    expectMention(refusal({"compare", room()}, kBadUsage), "-o FOLDER");
    expectMention(refusal({"techniques", "all"}, kBadUsage), "all");
    expectMention(refusal({"scenes", "atlantis"}, kBadUsage), "atlantis");
    expectMention(refusal({"reproduce", "nothing"}, kBadUsage), "normal-against-focused");
    expectMention(refusal({"study", "nothing"}, kBadUsage), "one-to-one");
    expectMention(refusal({"study", "one-to-one", "--count", "0"}, kBadUsage), "--count");
    expectMention(refusal({"study", "one-to-one", "-o", "out"}, kBadUsage), "-o");
    expectMention(refusal({"study", "one-to-one", "--lights", "5"}, kBadUsage), "study one-to-one --help");
    expectMention(refusal({"study", "scene-optimal-metrics", "objects"}, kBadUsage), "objects");
    expectMention(refusal({"study", "resolution", "--tolerance", "1%"}, kBadUsage), "SCENE");
    expectMention(refusal({"study", "resolution", "bunnies"}, kBadUsage), "--tolerance");
    expectMention(refusal({"study", "resolution", "bunnies", "--tolerance", "1%", "--seed", "1"}, kBadUsage), "--seed");
    for (const char* tolerance : {"much", "0", "-1%", "101%", "%", "nan"})
        expectMention(refusal({"study", "resolution", "bunnies", "--tolerance", tolerance}, kBadUsage), "--tolerance");
    expectMention(refusal({"study", "resolution", "bunnies", "--tolerance", "1", "--technique", "exact"}, kBadUsage),
                  "has no map");
    expectMention(refusal({"study", "resolution", "bunnies", "--tolerance", "1", "--technique", "psm,tsm"}, kBadUsage),
                  "one technique");
    expectMention(refusal({"study", "plane-budget", "-o", "-"}, kBadUsage), "folder");
    expectMention(refusal({"reproduce", "lixel-fig7", "-o", "-"}, kBadUsage), "folder");
    expectMention(refusal({"reproduce", "normal-against-focused", "--seed", "-1"}, kBadUsage), "whole number");
}

TEST_F(RefusedInput, TechniquesMustBeKnownAndWhole)
{
    expectMention(renderRefusal({"--technique", "nope"}, kBadUsage), "\"nope\" is not known");
    expectMention(renderRefusal({"--technique", ""}, kBadUsage), "empty");
    expectMention(renderRefusal({"--technique", "uniform+focused"}, kBadUsage), "more than one fit");
    expectMention(renderRefusal({"--technique", "whole+whole"}, kBadUsage), "more than one partition");
    expectMention(renderRefusal({"--technique", "pcf(3)"}, kBadUsage), "pcf(k)");
    expectMention(renderRefusal({"--technique", "exact-area(2)"}, kBadUsage), "square");
    expectMention(renderRefusal({"--technique", "uniform,focused"}, kBadUsage), "compare");
    expectMention(refusal({"compare", room(), "-o", "out", "--techniques", "uniform,"}, kBadUsage), "empty");
    expectMention(refusal({"compare", room(), "-o", "out", "--techniques", "focused,whole+focused"}, kBadUsage),
                  "the same");
}

TEST_F(RefusedInput, ScenesAndViewsMustBeKnown)
{
    expectMention(refusal({"render", "atlantis", "-o", "a.png"}, kBadUsage), "bunnies, table");
    expectMention(refusal({"render", "", "-o", "a.png"}, kBadUsage), "not built in");
    expectMention(refusal({"render", "fence(height=3)", "-o", "a.png"}, kBadUsage), "tufts");
    expectMention(refusal({"render", "bunnies(0)", "-o", "a.png"}, kBadUsage), "count");
    expectMention(refusal({"render", "table", "--view", "nowhere", "-o", "a.png"}, kBadUsage), "under-table");
    expectMention(renderRefusal({"--view", "all"}, kBadUsage), "one view");
    expectMention(renderRefusal({"--path"}, kBadUsage), "has a path");
    expectMention(renderRefusal({"--animation", "0"}, kBadUsage), "the scene has 0");
    expectMention(refusal({"compare", "table", "--path", "--view", "all", "-o", "out"}, kBadUsage), "one view");
}

TEST_F(RefusedInput, SizesAreFromOneToALimit)
{
    for (const char* size :
         {"0x0", "0x5", "1000000000", "1000000000x1", "99999999999999999999x1", "-5x5", "5x", "x5", "5x5x5", "", "a"}) {
        expectMention(renderRefusal({"--lixels", size}, kBadUsage), "--lixels");
        expectMention(renderRefusal({std::string("--size=") + size}, kBadUsage), "--size");
    }
    expectMention(refusal({"compare", room(), "-o", "out", "--timing-frames", "-1"}, kBadUsage), "--timing-frames");
}

TEST_F(RefusedInput, CamerasMustSee)
{
    expectMention(renderRefusal({"--eye", "1,2"}, kBadUsage), "--eye \"1,2\": expected three finite numbers");
    for (const char* point : {"", "1,2,3,4", "1;2;3", "nan,0,0", "0,inf,0", "1,2,x"})
        expectMention(renderRefusal({"--target", point}, kBadUsage), "three finite numbers");
    expectMention(renderRefusal({"--eye", "1,2,3", "--target", "1,2,3"}, kBadUsage), "eye and target");
    expectMention(renderRefusal({"--eye", "1,2,3", "--target", "1,5,3", "--up", "0,1,0"}, kBadUsage), "up");
    expectMention(renderRefusal({"--up", "0,0,0"}, kBadUsage), "up");
    expectMention(renderRefusal({"--eye", "1e13,0,0"}, kBadUsage), "at most");
    for (const char* degrees : {"0", "180", "-10", "nan", "1e999"})
        expectMention(renderRefusal({"--fovy", degrees}, kBadUsage), "fovy");
    expectMention(renderRefusal({"--near", "0"}, kBadUsage), "--near");
    expectMention(renderRefusal({"--near", "nan"}, kBadUsage), "--near");
    expectMention(renderRefusal({"--near", "2", "--far", "2"}, kBadUsage), "--far");
    expectMention(renderRefusal({"--far", "nan"}, kBadUsage), "--far");
    for (const char* seconds : {"nan", "inf", "-1", "", "soon"})
        expectMention(renderRefusal({"--time", seconds}, kBadUsage), "--time");
}

TEST_F(RefusedInput, LightsMustBeSomewhere)
{
    expectMention(renderRefusal({"--light-position", "nan,0,0"}, kBadUsage), "--light-position");
    expectMention(renderRefusal({"--light-direction", "0,0,0"}, kBadUsage), "direction");
    expectMention(renderRefusal({"--light-angle", "30"}, kBadUsage), "--light-position");
    expectMention(renderRefusal({"--light-direction", "0,-1,0", "--light-range", "5"}, kBadUsage), "--light-range");
    for (const char* degrees : {"0", "180", "nan"})
        expectMention(
            renderRefusal({"--light-position", "0,5,0", "--light-direction", "0,-1,0", "--light-angle", degrees},
                          kBadUsage),
            "angle");
    for (const char* range : {"0", "-1", "nan"})
        expectMention(renderRefusal({"--light-position", "0,5,0", "--light-range", range}, kBadUsage), "range");
}

TEST_F(RefusedInput, EveryBadFileIsNamed)
{
    for (const auto& entry : fs::directory_iterator(dataFolder() / "bad")) {
        const std::string path = entry.path().string();
        expectMention(refusal({"render", path, "-o", "a.png", "--executor", "trace"}, kBadInput), path);
    }
    expectMention(refusal({"render", "missing.glb", "-o", "a.png"}, kBadInput), "missing.glb: no such file");
    expectMention(refusal({"compare", "missing.glb", "-o", "out"}, kBadInput), "missing.glb: no such file");
    expectMention(refusal({"render", "./", "-o", "a.png"}, kBadInput), "directory");
}

TEST_F(RefusedInput, GigabytesOfNothingAreNotReadFirst)
{
    for (const char* name : {"large.obj", "large.glb", "large.gltf"}) {
        write(name, "");
        fs::resize_file(folder_.path() / name, std::uintmax_t(3) << 30);
        expectMention(refusal({"render", std::string("./") + name, "-o", "a.png"}, kBadInput), name);
    }
    // A start that is right, gigabytes of nothing behind it.
    const std::string json = R"({"asset": {"version": "2.0"}})";
    const auto glb = [&](std::uint32_t length, std::uint32_t jsonSize, const std::string& text) {
        std::string bytes = "glTF";
        for (const std::uint32_t n : {2u, length, jsonSize, 0x4e4f534au})
            for (int i = 0; i < 4; ++i) bytes += char(n >> 8 * i & 0xff);
        return bytes + text;
    };
    const std::uint32_t size = 3u << 30;
    const std::pair<const char*, std::string> starts[] = {
        {"short.glb", glb(100, 80, json)},
        {"text.glb", glb(size, size - 20, json)},
        {"chunk.glb", glb(size, std::uint32_t(json.size()), json)},
        {"asset.glb", glb(size, 12, R"({"asset": 1})")},
        {"start.gltf", json},
        {"start.obj", "v 0 0 0\n"},
        {"line.obj", "v 0 0 zero\n"},
        {"buffer.gltf",
         R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 8, "uri": "short.glb"}], "bufferViews": [{"buffer": 0, "byteLength": 9}]})"},
    };
    for (const auto& [name, start] : starts) {
        write(name, start);
        if (std::string_view(name) != "buffer.gltf") fs::resize_file(folder_.path() / name, size);
        expectMention(refusal({"render", name, "-o", "a.png"}, kBadInput), name);
    }
    write("image.png", "\x89PNG\r\n\x1a\n");
    fs::resize_file(folder_.path() / "image.png", 250u << 20);
    write("image.gltf", R"({"asset": {"version": "2.0"}, "images": [{"uri": "image.png"}], "textures": [{"source": 0}],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}]})");
    expectMention(refusal({"render", "image.gltf", "-o", "a.png"}, kBadInput), "PNG");
    write("start.json", "{}");
    fs::resize_file(folder_.path() / "start.json", size);
    expectMention(renderRefusal({"--view", "start.json"}, kBadInput), "zero byte");
    expectMention(renderRefusal({"--technique", "plan(start.json)"}, kBadInput), "zero byte");

    // What is right as far as it is looked at, and too much of it.
    const std::string accessor =
        R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 3221225472, "uri": "short.glb"}],
            "bufferViews": [{"buffer": 0, "byteLength": 3221225472}], "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 268435455, "type": "VEC3"}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}]})";
    write("accessor.gltf", accessor);
    fs::resize_file(folder_.path() / "short.glb", size);
    expectMention(refusal({"render", "accessor.gltf", "-o", "a.png"}, kBadInput), "67108864 triangles");
    const auto repeated = [&](const char* name, const std::string& begin, std::string_view text, std::size_t bytes) {
        std::string block;
        while (block.size() < (1u << 20)) block += text;
        std::ofstream file(folder_.path() / name, std::ios::binary);
        file << begin;
        for (std::size_t written = 0; written < bytes; written += block.size()) file << block;
    };
    repeated("nothing.obj", "", "\n", 200u << 20);
    repeated("vertices.obj", "", "v 0 0 0\n", 200u << 20);
    repeated("words.obj", "", "a b c\n", 200u << 20);
    for (const char* name : {"nothing.obj", "vertices.obj", "words.obj"})
        expectMention(refusal({"render", name, "-o", "a.png"}, kBadInput), "no triangles");
    repeated("values.gltf", R"({"asset": {"version": "2.0"}, "x": [)", "[[1]],", 40u << 20);
    expectMention(refusal({"render", "values.gltf", "-o", "a.png"}, kBadInput), "4000000 values");
    repeated("large.json", "{", " ", 40u << 20);
    expectMention(renderRefusal({"--view", "large.json"}, kBadInput), "32 MiB");

    write("huge.glb", "glTF");
    fs::resize_file(folder_.path() / "huge.glb", std::uintmax_t(20) << 30);
    expectMention(refusal({"render", "huge.glb", "-o", "a.png"}, kBadInput), "at most 4 GiB");
}

TEST_F(RefusedInput, ViewFilesAreReadToTheLetter)
{
    const std::pair<const char*, const char*> files[] = {
        {"", "empty"},
        {R"({"camera":)", "line"},
        {R"([])", "object"},
        {R"({"kamera": {}})", "kamera"},
        {R"({"camera": {"eye": [0, 0, 0], "target": [0, 0, 0]}})", "eye and target"},
        {R"({"camera": {"eye": [0, 0], "target": [0, 0, 0]}})", "/camera/eye"},
        {R"({"camera": {"eye": [0, 0, 1], "target": [0, 0, 0], "fovy": 0}})", "/camera/fovy"},
        {R"({"camera": {"eye": [0, 0, 1], "target": [0, 0, 0], "fovy": 180}})", "fovy"},
        {R"({"camera": {"eye": [0, 0, 1], "target": [0, 0, 0], "near": 2, "far": 1}})", "near"},
        {R"({"lights": []})", "/lights"},
        {R"({"light": {}})", "position"},
        {R"({"light": {"position": [NaN, 0, 0]}})", "line"},
        {R"({"light": {"position": [1e400, 0, 0]}})", "double"},
        {R"({"light": {"direction": [0, 0, 0]}})", "direction"},
        {R"({"lights": [{"name": "a", "direction": [0, -1, 0]}, {"name": "a", "direction": [1, -1, 0]}]})",
         "\"a\" is taken"},
        {R"({"time": -1})", "/time"},
        {R"({"path": []})", "/path"},
        {R"({"path": [{"time": 1, "eye": [0, 0, 1], "target": [0, 0, 0]}, {"time": 0, "eye": [0, 0, 1], "target": [0, 0, 0]}]})",
         "/path/1"},
    };
    for (const auto& [text, mention] : files) {
        write("view.json", text);
        const std::string line = renderRefusal({"--view", "view.json"}, kBadInput);
        EXPECT_EQ(line.substr(0, 9), "view.json");
        expectMention(line, mention);
    }
    expectMention(renderRefusal({"--view", "missing.json"}, kBadInput), "missing.json: no such file");
    expectMention(renderRefusal({"--view", "."}, kBadInput), "directory");
}

TEST_F(RefusedInput, OutputsMustBeWritable)
{
    write("file", "not a folder");
    fs::create_directory(folder_.path() / "folder.png");
    const auto render = [&](const Words& more, int code) {
        return refusal(Words{"render", room(), "--executor", "trace"} + more, code);
    };
    expectMention(render({"-o", "nowhere/a.png"}, kFailed), "nowhere/a.png: cannot be written");
    expectMention(render({"-o", "file/a.png"}, kFailed), "file/a.png: cannot be written");
    expectMention(render({"-o", "folder.png"}, kFailed), "folder.png: cannot be written");
    expectMention(render({"-o", "a.png", "--exr", "nowhere/a.exr"}, kFailed), "nowhere/a.exr");
    expectMention(render({"-o", "a.jpg"}, kBadUsage), ".png");
    expectMention(render({"--exr", "a.png"}, kBadUsage), ".exr");
    expectMention(render({"-o", "same", "--exr", "same"}, kBadUsage), "-o and --exr: expected two files");
    expectMention(render({"-o", "a.png", "--plan", "../" + folder_.path().filename().string() + "/./a.png"}, kBadUsage),
                  "-o and --plan: expected two files");
    expectMention(render({"-o", "-", "--plan", "-"}, kBadUsage), "-o and --plan: expected two files");
    expectMention(render({"-o", "a.png", "--exact"}, kBadUsage), "--exr");
    expectMention(render({"--exr", "a.exr", "--density", "--technique", "exact"}, kBadUsage), "no map");

    const auto compare = [&](const Words& more) {
        return refusal(Words{"compare", room(), "--executor", "trace"} + more, kFailed);
    };
    expectMention(compare({"-o", "file"}), "file: cannot be written");
    expectMention(compare({"-o", "file/deeper/out"}), "file/deeper/out: cannot be written");
    expectMention(compare({"-o", "new/deep", "--json", "nowhere/a.json"}), "nowhere/a.json");
    expectMention(refusal({"reproduce", "normal-against-focused", "--json", "nowhere/a.json"}, kFailed),
                  "nowhere/a.json");
}

TEST_F(RefusedInput, ReportsThatCannotBeMadeLeaveNoFolder)
{
    expectMention(refusal({"compare", "missing.glb", "-o", "new/deep/out"}, kBadInput), "missing.glb");
    expectMention(refusal({"compare", "table", "--view", "nowhere", "-o", "new/deep/out"}, kBadUsage), "nowhere");
}

TEST_F(RefusedInput, WhatIsFullIsAFailure)
{
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
    const Words small{"--executor", "trace", "--size", "8x8", "--lixels", "8x8"};
    CommandOptions full;
    full.printTo = "/dev/full";
    expectMention(refusal({"techniques"}, kFailed, full), "standard output: cannot be written");
    expectMention(refusal({"--help"}, kFailed, full), "standard output: cannot be written");
    const Words scene{"render", room()};
    expectMention(refusal(scene + small + Words{"-o", "-"}, kFailed, full), "standard output: cannot be written");
    for (const Words& outputs :
         {Words{"-o", "/dev/full"}, Words{"-o", "/dev/full", "--exr", "a.exr"},
          Words{"-o", "a.png", "--exr", "/dev/full"}, Words{"-o", "a.png", "--plan", "/dev/full"}})
        expectMention(refusal(scene + small + outputs, kFailed), "/dev/full");
}

TEST_F(RefusedInput, WithoutGraphicsTheOtherExecutorIsNamed)
{
    CommandOptions options;
    options.environment = {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent.json"}};
    expectMention(refusal({"render", room(), "-o", "a.png"}, kNoGraphics, options), "--executor trace");
    expectMention(refusal({"compare", room(), "-o", "out"}, kNoGraphics, options), "--executor trace");
    expectMention(refusal({"compare", room(), "-o", "out", "--executor", "both"}, kNoGraphics, options),
                  "--executor trace");
}

TEST_F(RefusedInput, APointLightAmidTheVisibleSceneIsRefusedByName)
{
    // A lamp in the middle of the room sees around itself more than one perspective map can hold.
    const Words lamp{"--light-position", "2,0.5,2", "--executor", "trace", "--size", "16x16", "-o", "a.png"};
    const std::string line = refusal(Words{"render", room(), "--technique", "focused"} + lamp, kRefused);
    expectMention(line, "extent-not-in-hemisphere");
    expectMention(line, "cube is needed");
}

} // namespace
} // namespace lixel::test
