// SPDX-License-Identifier: MIT
#include "lixel/scene/builtin/shapes.h"
#include "lixel/scene/builtin/things.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <string>
#include <utility>

namespace lixel::builtin {
namespace {

using Key = std::array<float, 3>;

Key keyOf(Vec3f p) { return {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f}; }

// Edges, by place, that are not used equally often in both directions.
int openEdges(const Mesh& mesh)
{
    std::map<std::pair<Key, Key>, int> balance;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const Key a = keyOf(mesh.position[mesh.indices[i]]);
        const Key b = keyOf(mesh.position[mesh.indices[i % 3 == 2 ? i - 2 : i + 1]]);
        if (a < b) ++balance[{a, b}];
        if (b < a) --balance[{b, a}];
    }
    int open = 0;
    for (const auto& edge : balance) open += edge.second != 0;
    return open;
}

// Of the space inside, positive when triangles turn counterclockwise seen from outside.
double volume(const Mesh& mesh)
{
    double sum = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto p = [&](std::size_t k) { return toDouble(mesh.position[mesh.indices[i + k]]); };
        sum += dot(p(0), cross(p(1), p(2))) / 6;
    }
    return sum;
}

std::vector<std::pair<std::string, Mesh>> solids()
{
    const Vec3d bend[] = {{0, 0, 0}, {0, 1, 0}, {1, 2, 0}, {2, 2, 1}};
    const Vec2d arch[] = {{-1, 0}, {0, 1}, {1, 0}}, line[] = {{-1, 2}, {0, 2}, {1, 2}};
    const Vec2d star[] = {{2, 0}, {0.5, 0.5}, {0, 2}, {-1, 0}, {0, -1}};
    return {{"box", box({-1, 2, 3}, {4, 5, 6})},
            {"sphere", sphere(2, 24)},
            {"cylinder", cylinder(1, 3, 17)},
            {"cone", cone(1, 2, 16)},
            {"torus", torus(2, 0.5, 24, 12)},
            {"torus knot", torusKnot(2, 3, 1, 0.2, 200, 10)},
            {"tube", tube(bend, 0.2, 0.1, 9)},
            {"pointed tube", tube(bend, 0.2, 0, 9)},
            {"rod", rod({0, 0, 0}, {1, 2, 3}, 0.1, 7)},
            {"band", band(arch, line, 0.5)},
            {"wall", wallWithHole({{-2, -1}, {2, 3}}, {{-1, 0}, {1, 1}}, 0.2)},
            {"prism", prism(star, 0.4)},
            {"soft box", softBox({1, 2, 3}, 5, 32)},
            {"bunny", bunny()},
            {"teapot", teapot(48)},
            {"mug", mug(32)},
            {"bowl", bowl(32)},
            {"plate", plate(32)},
            {"vase", vase(32)},
            {"candlestick", candlestick(32)},
            {"goblet", goblet(32)},
            {"apple", apple(32)},
            {"pear", pear(32)},
            {"basket", basket(20)},
            {"spring", spring(3, 1, 2, 0.1, 32, 8)},
            {"gear", gear(12, 1, 0.2)},
            {"books", bookStack(3, 1)},
            {"chair", chair()},
            {"table", tableFrame(2, 1, 0.7)}};
}

TEST(Shapes, SolidThingsAreClosedAndTurnTheirOutsideOut)
{
    for (const auto& [name, mesh] : solids()) {
        EXPECT_EQ(openEdges(mesh), 0) << name;
        EXPECT_GT(volume(mesh), 0) << name;
    }
}

TEST(Shapes, NormalsAreUnitAndOnTheSideOfTheirTriangles)
{
    for (const auto& [name, mesh] : solids()) {
        ASSERT_EQ(mesh.normal.size(), mesh.position.size());
        ASSERT_EQ(mesh.uv.size(), mesh.position.size());
        int against = 0;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const auto p = [&](std::size_t k) { return toDouble(mesh.position[mesh.indices[i + k]]); };
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3d normal = toDouble(mesh.normal[mesh.indices[i + k]]);
                ASSERT_NEAR(length(normal), 1, 1e-5) << name;
                against += dot(cross(p(1) - p(0), p(2) - p(0)), normal) < 0;
            }
        }
        EXPECT_LE(against, int(mesh.indices.size()) / 25) << name; // at rims and folds too sharp for their triangles
    }
}

TEST(Shapes, SizesAreWhatTheyAreCalled)
{
    EXPECT_NEAR(volume(box({0, 0, 0}, {1, 2, 3})), 6, 1e-6);
    EXPECT_NEAR(volume(sphere(1, 256)), 4.18879, 2e-3);
    EXPECT_NEAR(volume(cylinder(1, 2, 256)), 6.28319, 2e-3);
    EXPECT_NEAR(volume(torus(2, 0.5, 256, 128)), 9.8696, 2e-2);
    EXPECT_NEAR(volume(wallWithHole({{0, 0}, {4, 3}}, {{1, 1}, {2, 2}}, 0.5)), 5.5, 1e-6);
    EXPECT_NEAR(volume(rod({0, 0, 0}, {0, 0, 2}, 1, 256)), 6.28319, 2e-3);
    float lowest = 1, highest = 0;
    for (const Vec3f& p : bunny().position) lowest = std::min(lowest, p.y), highest = std::max(highest, p.y);
    EXPECT_EQ(lowest, 0);
    EXPECT_NEAR(highest, 1, 1e-6);
}

TEST(Shapes, TheBunnyIsOneClosedSurfaceWithoutHandles)
{
    const Mesh mesh = bunny();
    const long vertices = long(mesh.position.size()), triangles = long(mesh.indices.size() / 3);
    EXPECT_EQ(vertices - triangles * 3 / 2 + triangles, 2); // Euler's formula for a sphere
    EXPECT_NEAR(double(triangles), 9000, 90);
}

TEST(Shapes, AMovedPartKeepsItsShape)
{
    Mesh moved;
    append(moved, teapot(32), at({5, -2, 1}) * turnedY(37) * turned({1, 2, 3}, 101));
    EXPECT_NEAR(volume(moved), volume(teapot(32)), 1e-6);
}

} // namespace
} // namespace lixel::builtin
