// SPDX-License-Identifier: MIT
#include "small_scenes.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace lixel::test {

CasterBuffers SmallScene::casters() const
{
    CasterBuffers out;
    out.originWorld = originWorld;
    CasterMesh mesh;
    mesh.positions = positions;
    mesh.indices = indices;
    mesh.uv = uv;
    mesh.colour = colour;
    mesh.normals = normals;
    mesh.material = material;
    out.meshes.push_back(mesh);
    out.materials = materials;
    out.textures = textures;
    return out;
}

Box SmallScene::boxWorld() const
{
    Box box;
    for (const Vec3f& p : positions) box.include(toDouble(p) + originWorld);
    return box;
}

void SmallScene::addQuad(Vec3f a, Vec3f b, Vec3f c, Vec3f d, std::uint32_t materialOfQuad)
{
    const auto first = std::uint32_t(positions.size());
    positions.insert(positions.end(), {a, b, c, d});
    for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) indices.push_back(first + corner);
    material.insert(material.end(), 2, materialOfQuad);
}

void SmallScene::addBox(Vec3d min, Vec3d max, std::uint32_t materialOfBox)
{
    const std::array<Vec3d, 8> corner = Box{min, max}.corners();
    constexpr std::array<std::array<std::size_t, 4>, 6> faces{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (const auto& f : faces)
        addQuad(toFloat(corner[f[0]]), toFloat(corner[f[1]]), toFloat(corner[f[2]]), toFloat(corner[f[3]]),
                materialOfBox);
}

void SmallScene::addSphere(Vec3d centre, double radius, int rings, std::uint32_t materialOfSphere)
{
    const int segments = 2 * rings;
    const auto first = std::uint32_t(positions.size());
    for (int i = 0; i <= rings; ++i)
        for (int j = 0; j < segments; ++j) {
            const double polar = std::numbers::pi * i / rings, around = 2 * std::numbers::pi * j / segments;
            const Vec3d d{std::sin(polar) * std::cos(around), std::cos(polar), std::sin(polar) * std::sin(around)};
            positions.push_back(toFloat(centre + radius * d));
        }
    const auto at = [&](int i, int j) { return first + std::uint32_t(i * segments + j % segments); };
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < segments; ++j) {
            if (i > 0) {
                indices.insert(indices.end(), {at(i, j), at(i, j + 1), at(i + 1, j)});
                material.push_back(materialOfSphere);
            }
            if (i + 1 < rings) {
                indices.insert(indices.end(), {at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
                material.push_back(materialOfSphere);
            }
        }
}

SmallScene anyObjectsOnAFloor(Rng& rng, double halfSize)
{
    SmallScene scene;
    const auto h = float(halfSize);
    scene.addQuad({-h, 0, -h}, {-h, 0, h}, {h, 0, h}, {h, 0, -h});
    for (int i = rng.integer(2, 6); i > 0; --i) {
        const Vec3d at{rng.uniform(-0.6, 0.6) * halfSize, 0, rng.uniform(-0.6, 0.6) * halfSize};
        const double size = rng.uniform(0.05, 0.2) * halfSize;
        if (rng.chance(0.5)) scene.addBox(at - Vec3d{size, 0, size}, at + Vec3d{size, rng.uniform(1, 3) * size, size});
        else scene.addSphere(at + Vec3d{0, size, 0}, size, 12);
    }
    return scene;
}

Texture anyTexture(Rng& rng, int mostTexels)
{
    Texture texture;
    texture.pixels = Image<Rgba8>(rng.integer(1, mostTexels), rng.integer(1, mostTexels));
    const auto byte = [&] { return std::uint8_t(rng.integer(0, 255)); };
    for (Rgba8& texel : texture.pixels.data()) texel = {byte(), byte(), byte(), byte()};
    texture.wrapU = Wrap(rng.integer(0, 2));
    texture.wrapV = Wrap(rng.integer(0, 2));
    return texture;
}

SmallScene anyTriangleSoup(Rng& rng, int triangles, double half)
{
    SmallScene scene;
    for (int i = rng.integer(1, 3); i > 0; --i) scene.textures.push_back(anyTexture(rng, 9));
    for (int i = 0; i < 5; ++i) {
        Material m;
        m.baseColour = {float(rng.uniform(0, 1)), float(rng.uniform(0, 1)), float(rng.uniform(0, 1)),
                        float(rng.uniform(0.3, 1))};
        m.texture = rng.integer(-1, int(scene.textures.size()) - 1);
        m.alphaMode = rng.chance(0.5) ? AlphaMode::Mask : AlphaMode::Opaque;
        m.alphaCutoff = float(rng.uniform(0, 1));
        scene.materials.push_back(m);
    }
    for (int i = 0; i < triangles; ++i) {
        const Vec3d at = rng.inBox(half);
        for (int c = 0; c < 3; ++c) {
            scene.indices.push_back(std::uint32_t(scene.positions.size()));
            scene.positions.push_back(toFloat(at + rng.inBox(0.4 * half)));
            scene.uv.push_back({float(rng.uniform(-3, 3)), float(rng.uniform(-3, 3))});
            scene.colour.push_back({1, 1, 1, float(rng.uniform(0.5, 1))});
        }
        scene.material.push_back(std::uint32_t(rng.integer(0, 4)));
    }
    return scene;
}

View anyViewOf(Rng& rng, Vec3d centreWorld, double half, int width, int height)
{
    const Vec3d away = normalized(rng.onSphere() + Vec3d{0, 1.2, 0});
    const Vec3d eye = centreWorld + rng.uniform(1.2, 3) * half * (length(away) > 0 ? away : Vec3d{0, 1, 0});
    const Vec3d target = centreWorld + rng.inBox(0.3 * half);
    const Vec3d up = std::abs(away.y) > 0.95 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    const double near = 0.01 * half, far = rng.chance(0.5) ? std::numeric_limits<double>::infinity() : 10 * half;
    if (rng.chance(0.3))
        return orthographicView(eye, target, up, rng.uniform(1, 3) * half, -half, 10 * half, width, height);
    View view = perspectiveView(eye, target, up, rng.uniform(0.4, 1.5), near, far, width, height);
    if (rng.chance(0.3)) // off-centre: NDC moved by a part of the picture
        view.clipFromAnchored = Mat4d::fromRows({1, 0, 0, rng.uniform(-0.3, 0.3)}, {0, 1, 0, rng.uniform(-0.3, 0.3)},
                                                {0, 0, 1, 0}, {0, 0, 0, 1}) *
                                view.clipFromAnchored;
    return view;
}

} // namespace lixel::test
