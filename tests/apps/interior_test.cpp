// SPDX-License-Identifier: MIT
// The first picture of files without a camera: rooms from inside, where something is to be seen, things from outside.
#include "report/sample_results.h"
#include "run_command.h"

#include "lixel/report/png.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string>

namespace lixel::test {
namespace {

// The faces of a box, turned outwards; as walls of a room, inwards.
std::string box(std::array<double, 3> min, std::array<double, 3> max, bool isRoom)
{
    std::string text;
    for (int i = 0; i < 8; ++i) {
        text += "v";
        for (int axis = 0; axis < 3; ++axis)
            text += " " + std::to_string(((i >> axis) & 1) != 0 ? max[std::size_t(axis)] : min[std::size_t(axis)]);
        text += "\n";
    }
    using Face = std::array<int, 4>;
    constexpr std::array<Face, 6> kFaces{Face{1, 5, 7, 3}, {2, 4, 8, 6}, {1, 2, 6, 5},
                                         {3, 7, 8, 4},     {1, 3, 4, 2}, {5, 6, 8, 7}};
    for (Face face : kFaces) {
        if (isRoom) std::reverse(face.begin(), face.end());
        text += "f";
        for (const int corner : face) text += " " + std::to_string(corner - 9);
        text += "\n";
    }
    return text;
}

class Interior : public ::testing::Test
{
protected:
    void write(const char* name, const std::string& text) const { std::ofstream(folder_.path() / name) << text; }
    CommandResult render(const std::vector<std::string>& words) const
    {
        std::vector<std::string> all{"render",     "scene.obj", "--size", "64x48",
                                     "--executor", "trace",     "-o",     "picture.png"};
        all.insert(all.end(), words.begin(), words.end());
        CommandOptions options;
        options.folder = folder_.path();
        return runLixel(all, options);
    }
    TemporaryFolder folder_;
};

TEST_F(Interior, ARoomIsFirstShownFromInsideLookingAtWhatStandsInIt)
{
    write("colours.mtl", "newmtl wall\nKd 0.8 0.8 0.8\nnewmtl post\nKd 0.9 0 0\n");
    write("scene.obj", "mtllib colours.mtl\nusemtl wall\n" + box({0, 0, 0}, {12, 3, 6}, true) + "usemtl post\n" +
                           box({10, 0, 2}, {10.5, 2, 2.5}, false) + box({9, 0, 4}, {9.5, 2, 4.5}, false));
    ASSERT_EQ(render({}).exitCode, 0);
    const Image<Rgba8> picture = readPng(folder_.path() / "picture.png");
    const auto isRed = [](Rgba8 p) { return p.r > 2 * p.g + 10; };
    EXPECT_GT(std::count_if(picture.data().begin(), picture.data().end(), isRed), 64 * 48 / 100);
    EXPECT_EQ(render({"--view", "inside"}).exitCode, 0);
    EXPECT_EQ(render({"--view", "outside"}).exitCode, 0);
}

TEST_F(Interior, AThingIsShownFromOutsideOnly)
{
    write("scene.obj", box({0, 0, 0}, {12, 3, 6}, false));
    EXPECT_EQ(render({"--view", "default"}).exitCode, 0);
    EXPECT_EQ(render({"--view", "inside"}).exitCode, 2);
}

} // namespace
} // namespace lixel::test
