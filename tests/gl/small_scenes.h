// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/box.h"
#include "lixel/base/caster_source.h"
#include "lixel/base/view.h"
#include "support/random_cases.h"

#include <vector>

// Small scenes made of triangles in memory.
namespace lixel::test {

// Owns what its casters() point into. Positions are Local.
struct SmallScene
{
    Vec3d originWorld;
    std::vector<Vec3f> positions, normals;
    std::vector<Vec2f> uv;
    std::vector<Vec4f> colour;
    std::vector<std::uint32_t> indices, material;
    std::vector<Material> materials;
    std::vector<Texture> textures;

    CasterBuffers casters() const; // of version 0: uploaded each time
    Box boxWorld() const;

    // Two triangles, corners in order around the quad.
    void addQuad(Vec3f a, Vec3f b, Vec3f c, Vec3f d, std::uint32_t materialOfQuad = 0);
    void addBox(Vec3d min, Vec3d max, std::uint32_t materialOfBox = 0);
    // A sphere of 2 * rings^2 or so triangles, closed, its corners on the sphere.
    void addSphere(Vec3d centre, double radius, int rings, std::uint32_t materialOfSphere = 0);
};

// A floor at y = 0 of this half size, with boxes and spheres on it.
SmallScene anyObjectsOnAFloor(Rng& rng, double halfSize);

// Triangles without order in a cube of this half size, with random alpha masks.
SmallScene anyTriangleSoup(Rng& rng, int triangles, double half);

// Random texels, some of them transparent.
Texture anyTexture(Rng& rng, int mostTexels);

// A view that sees a scene of this half size around `centreWorld`: perspective (finite or infinite, off-centre at times) or
// orthographic.
View anyViewOf(Rng& rng, Vec3d centreWorld, double half, int width, int height);

} // namespace lixel::test
