// SPDX-License-Identifier: MIT
#include "small_scenes.h"

#include "lixel/gl/passes/mesh_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace lixel::test {
namespace {

TEST(MeshEdges, OfAClosedBodyRunAsOftenOneWayAsTheOther)
{
    forEachCase(kCases, [](Rng& rng) {
        SmallScene scene;
        for (int i = rng.integer(1, 5); i > 0; --i) {
            const Vec3d a = rng.inBox(3);
            scene.addBox(a, a + Vec3d{rng.uniform(0.1, 2), rng.uniform(0.1, 2), rng.uniform(0.1, 2)});
        }
        const gl::MeshEdges mesh = gl::edgesOf(scene.positions, scene.indices);
        EXPECT_FALSE(mesh.edges.empty());
        for (const gl::MeshEdge& edge : mesh.edges) {
            EXPECT_LT(edge.from, edge.to);
            int turned = 0;
            for (std::uint32_t i = 0; i < edge.useCount; ++i) turned += int(mesh.uses[edge.firstUse + i] & 1);
            EXPECT_EQ(2 * turned, int(edge.useCount));
        }
    });
}

TEST(MeshEdges, ABoxWithCornersOfItsOwnForEachFaceHas18)
{
    SmallScene scene;
    scene.addBox({-1, -1, -1}, {1, 1, 1});
    const gl::MeshEdges mesh = gl::edgesOf(scene.positions, scene.indices);
    EXPECT_EQ(mesh.edges.size(), 18u); // 12, and a diagonal a face
    EXPECT_EQ(mesh.uses.size(), 36u);
}

TEST(MeshEdges, ManyTrianglesMayMeetInOne)
{
    const std::array<Vec3f, 5> positions{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}}};
    const std::array<std::uint32_t, 9> indices{0, 1, 2, 0, 1, 3, 1, 0, 4};
    const gl::MeshEdges mesh = gl::edgesOf(positions, indices);
    EXPECT_EQ(mesh.edges.size(), 7u);
    const auto shared = std::find_if(mesh.edges.begin(), mesh.edges.end(),
                                     [](const gl::MeshEdge& edge) { return edge.from == 0 && edge.to == 1; });
    ASSERT_NE(shared, mesh.edges.end());
    ASSERT_EQ(shared->useCount, 3u);
    EXPECT_EQ(mesh.uses[shared->firstUse], 0u);
    EXPECT_EQ(mesh.uses[shared->firstUse + 1], 2u);
    EXPECT_EQ(mesh.uses[shared->firstUse + 2], 5u); // the third runs from 1 to 0
}

TEST(MeshEdges, PlacesThatDifferInTheSignOfZeroAreOneAndSidesWithoutLengthAreNone)
{
    const std::array<Vec3f, 4> positions{{{0, 0, 0}, {-0.0f, 0, -0.0f}, {1, 0, 0}, {0, 1, 0}}};
    const std::array<std::uint32_t, 6> indices{0, 1, 2, 1, 2, 3};
    const gl::MeshEdges mesh = gl::edgesOf(positions, indices);
    EXPECT_EQ(mesh.edges.size(), 3u);
    EXPECT_EQ(mesh.uses.size(), 5u);
}

} // namespace
} // namespace lixel::test
