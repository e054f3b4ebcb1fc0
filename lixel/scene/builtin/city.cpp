// SPDX-License-Identifier: MIT
#include "lixel/scene/builtin/assemble.h"
#include "lixel/scene/builtin/dice.h"
#include "lixel/scene/builtin/scenes.h"
#include "lixel/scene/builtin/shapes.h"
#include "lixel/scene/builtin/textures.h"

#include <algorithm>
#include <array>
#include <cmath>

// Square blocks of buildings and a few parks, with street lamps and trees; towers stand in the middle.
namespace lixel::builtin {

namespace {

constexpr double kPitch = 90, kStreet = 18, kBlock = kPitch - kStreet; // metres
constexpr double kKerb = 0.15;
constexpr std::size_t kFacades = 5;

// What a block is made of, one mesh a material; walls reach a little below the kerb.
struct Block
{
    std::array<Mesh, kFacades> walls;
    Mesh roofs, metal, trunks, crowns;
};

Vec3d lifted(Vec3d p, double y) { return {p.x, y, p.z}; }

// A body with its parapet, and machines on the roof.
void addHouse(Block& block, Dice& dice, std::size_t facadeKind, Vec3d centre, double width, double depth, double from,
              double to)
{
    append(block.walls[facadeKind], boxAround(lifted(centre, 0.5 * (from + to)), {width, to - from, depth}, 26));
    append(block.roofs, boxAround(lifted(centre, to + 0.15), {width + 0.5, 0.7, depth + 0.5}, 8));
    const int machines = dice.integer(0, 3);
    for (int i = 0; i < machines; ++i) {
        const double w = dice.uniform(1.5, 4), h = dice.uniform(1.2, 3), x = 0.32 * width * dice.uniform(-1, 1),
                     z = 0.32 * depth * dice.uniform(-1, 1);
        append(block.metal, boxAround(lifted(centre, to + 0.45 - 0.03 * i + 0.5 * h) + Vec3d{x, 0, z},
                                      {w, h, dice.uniform(1.5, 4)}));
    }
}

void addTower(Block& block, Dice& dice, std::size_t facadeKind, Vec3d centre, double width, double depth, double height)
{
    double from = 0.1, w = width, d = depth;
    const int steps = dice.integer(2, 4);
    for (int i = 1; i <= steps; ++i) {
        const double to = height * (i == steps ? 1 : (0.45 + 0.5 * i / steps) * dice.uniform(0.8, 1));
        if (to < from + 6) continue;
        addHouse(block, dice, facadeKind, centre, w, d, from, to);
        from = to + 0.2;
        w *= dice.uniform(0.66, 0.84);
        d *= dice.uniform(0.66, 0.84);
    }
    append(block.metal, rod(lifted(centre, from), lifted(centre, from + 0.18 * height), 0.25, 10));
}

void addRoundTower(Block& block, std::size_t facadeKind, Vec3d centre, double radius, double height)
{
    const double around = std::round(2 * 3.14159 * radius / 26), up = height / 26;
    append(block.walls[facadeKind],
           surface(
               [&](double u, double v) {
                   const double a = 2 * 3.14159265358979 * (u == 1 ? 0 : u);
                   return Vec3d{radius * std::cos(a), 0.1 + v * height, -radius * std::sin(a)};
               },
               48, 1, {around, up}),
           at(centre));
    append(block.roofs, cylinder(radius + 0.4, 0.8, 48), at(lifted(centre, height - 0.2)));
}

void addTree(Block& block, Dice& dice, Vec3d centre)
{
    const double size = dice.uniform(0.8, 1.4);
    append(block.trunks, cylinder(0.22 * size, 3 * size, 12), at(lifted(centre, 0.1 * size - 0.05)));
    append(block.crowns, sphere(1, 20),
           at(lifted(centre, 4.3 * size)) * turnedY(dice.uniform(0, 360)) *
               scaling({2.1 * size, 2.4 * size, 2.0 * size}));
    append(block.crowns, sphere(1, 16),
           at(lifted(centre, 5.6 * size) + Vec3d{0.5 * size, 0, 0.3 * size}) *
               scaling({1.4 * size, 1.5 * size, 1.5 * size}));
}

void addLampPosts(Block& block)
{
    for (double side : {-0.5 * kBlock + 1.2, 0.5 * kBlock - 1.2})
        for (double along : {-24.0, 0.0, 24.0}) {
            append(block.metal, rod({side, 0.1, along}, {side, 7.5, along}, 0.09, 8));
            append(block.metal, rod({side, 7.4, along}, {side + std::copysign(2.2, side), 7.7, along}, 0.06, 8));
        }
}

// `middle` is 1 in the middle of the city and 0 at its edge.
Block makeBlock(std::uint64_t seed, double middle)
{
    Dice dice(seed);
    Block block;
    addLampPosts(block);
    if (dice.chance(0.12)) {
        for (int i = 0; i < 36; ++i) addTree(block, dice, {dice.uniform(-31, 31), 0, dice.uniform(-31, 31)});
        return block;
    }
    const int lots = dice.integer(2, 3);
    const double lot = (kBlock - 8) / lots;
    for (int i = 0; i < lots; ++i)
        for (int j = 0; j < lots; ++j) {
            const Vec3d centre{(i - 0.5 * (lots - 1)) * lot, 0, (j - 0.5 * (lots - 1)) * lot};
            const double width = lot * dice.uniform(0.68, 0.92), depth = lot * dice.uniform(0.68, 0.92);
            const double height = (10 + 22 * dice.uniform(0, 1)) * (1 + 2.6 * middle * middle * dice.uniform(0.2, 1));
            const std::size_t facadeKind = std::size_t(dice.integer(0, int(kFacades) - 1));
            if (dice.chance(0.07)) addTree(block, dice, centre);
            else if (height > 50 && dice.chance(0.25))
                addRoundTower(block, facadeKind, centre, 0.45 * std::min(width, depth), height);
            else if (height > 38) addTower(block, dice, facadeKind, centre, width, depth, height);
            else addHouse(block, dice, facadeKind, centre, width, depth, 0.1, height);
        }
    return block;
}

struct Materials
{
    std::array<int, kFacades> walls;
    int roofs, metal, trunks, crowns, pavement;
};

Materials addMaterials(Scene& scene)
{
    return {{addTextured(scene, facade(0xc9b79c, 0x4f6276, 8)), addTextured(scene, facade(0xa4573f, 0x39424d, 7)),
             addTextured(scene, facade(0xd8d6cf, 0x5d7f93, 9)), addTextured(scene, facade(0x7f8a93, 0xa9c3d2, 8)),
             addTextured(scene, facade(0xdab779, 0x4d4238, 6))},
            addMaterial(scene, 0x8b8880),
            addMaterial(scene, 0xa3a9ad),
            addMaterial(scene, 0x6b5240),
            addMaterial(scene, 0x5d8a46),
            addTextured(scene, tiles(0xb7b4ad, 0x98958e, 4))};
}

void addBlocks(Scene& scene, int blocks)
{
    const Materials material = addMaterials(scene);
    const int pavement = addMesh(
        scene, box({-0.5 * kBlock, -0.3, -0.5 * kBlock}, {0.5 * kBlock, kKerb, 0.5 * kBlock}, 8), material.pavement);
    const double half = 0.5 * (blocks - 1);
    for (int i = 0; i < blocks; ++i)
        for (int j = 0; j < blocks; ++j) {
            const double fromMiddle = std::hypot(i - half, j - half) / std::max(1.0, half);
            const Block block =
                makeBlock(1 + std::uint64_t(i) * 1009 + std::uint64_t(j), std::max(0.0, 1 - fromMiddle));
            std::vector<int> meshes = {pavement};
            const auto take = [&](const Mesh& mesh, int its) {
                if (!mesh.indices.empty()) meshes.push_back(addMesh(scene, mesh, its));
            };
            for (std::size_t k = 0; k < kFacades; ++k) take(block.walls[k], material.walls[k]);
            take(block.roofs, material.roofs);
            take(block.metal, material.metal);
            take(block.trunks, material.trunks);
            take(block.crowns, material.crowns);
            addNode(scene, "block " + std::to_string(i + 1) + "-" + std::to_string(j + 1), meshes,
                    {{(i - half) * kPitch, 0, (j - half) * kPitch}});
        }
}

// Streets run along multiples of kPitch from the middle, offset by half of it when the number of blocks is odd.
void addViews(Scene& scene, int blocks)
{
    const double s = blocks % 2 == 0 ? 0 : 0.5 * kPitch, edge = 0.5 * kPitch * blocks;
    const Light morning = sun({0.62, -0.6, -0.5});
    addView(scene, "overview", "the city from its corner, from the air",
            lookAt({0.85 * edge, 0.42 * edge + 60, 1.1 * edge}, {0, 10, -0.05 * edge}, 46), {morning});
    addView(scene, "street", "along a street at eye height", lookAt({s + 3, 1.8, s + 2.2 * kPitch}, {s, 14, s}, 56),
            {sun({0.75, -0.62, -0.22})});
    addView(scene, "crossing", "a crossing from the third floor", lookAt({s + 5, 24, s + 62}, {s - 6, 2, s - 4}, 56),
            {sun({0.5, -0.75, 0.42})});
    addView(scene, "rooftops", "over the roofs", lookAt({s - 130, 78, s + 190}, {s + 20, 30, s - 40}, 46),
            {sun({0.7, -0.5, 0.5})});
    addView(scene, "plan", "straight down but for a little", lookAt({s, 420, s + 60}, {s, 0, s}, 50),
            {sun({0.5, -0.7, 0.5})});
    addView(scene, "kerb", "low over the pavement, one block away from a wall",
            lookAt({s + 10.6, 0.5, s + 44}, {s + 14.5, 4.5, s + 10}, 56), {sun({0.72, -0.5, -0.45})});
    addView(scene, "skyline", "from outside, the far end a kilometre behind",
            lookAt({0.2 * edge, 14, edge + 34}, {0.05 * edge, 30, 0}, 44), {sun({0.65, -0.45, -0.6})});
    addView(scene, "light-in-front", "down a street against the sun",
            lookAt({s - 2, 8, s + 2.4 * kPitch}, {s, 5, s}, 50), {sun({0.06, -0.42, 0.9})});
    addView(scene, "grazing", "the sun five degrees high", lookAt({s + 150, 95, s + 230}, {s, 12, s - 20}, 46),
            {sun({-0.9, -0.088, -0.42})});
    addView(scene, "light-in-frustum", "a lamp over the crossing, in the picture",
            lookAt({s + 6, 5, s + 60}, {s - 2, 7, s}, 56), {lamp({s, 13, s + 14}, "crossing-lamp")});
    addView(scene, "light-at-eye", "a searchlight at the eye", lookAt({s + 60, 70, s + 140}, {s, 15, s - 20}, 46),
            {spot({s + 60, 70, s + 140}, {s, 15, s - 20}, 84, "searchlight")});
    addView(scene, "helicopter", "a spot from 180 metres up, and the moon",
            lookAt({s + 5, 62, s + 118}, {s - 6, 4, s - 4}, 52),
            {tinted(spot({s - 40, 180, s + 60}, {s, 0, s}, 50, "searchlight"), {0.75, 0.72, 0.62}),
             tinted(sun({0.5, -0.7, -0.5}, "moon"), {0.2, 0.26, 0.4})});
}

Scene build(std::span<const double> values)
{
    const int blocks = int(values[0]);
    const double reach = 0.5 * kPitch * blocks + 40, s = blocks % 2 == 0 ? 0 : 0.5 * kPitch;
    Scene scene = emptyScene("city");
    addStatic(scene, "ground", box({-reach, -1, -reach}, {reach, 0, reach}, 20),
              addTextured(scene, plaster(0x6b6d70, 0.05)));
    addPlane(scene, "floor", {0, 0, 0}, {0, 1, 0});
    addPlane(scene, "pavement", {0, kKerb, 0}, {0, 1, 0});
    addBlocks(scene, blocks);
    addViews(scene, blocks);
    addPath(scene, LightKind::Directional, 3,
            {{{s + 3, 1.8, s + 2.2 * kPitch}, {s, 14, s}, {0.75, -0.62, -0.22}},
             {{s + 2, 6, s + 1.6 * kPitch}, {s, 14, s}, {0.78, -0.5, 0}},
             {{s, 22, s + kPitch}, {s - 10, 10, s}, {0.76, -0.42, 0.25}},
             {{s - 60, 60, s + kPitch}, {s, 18, s}, {0.7, -0.36, 0.45}},
             {{s - 130, 90, s + 190}, {s + 20, 25, s - 40}, {0.6, -0.32, 0.6}}});
    return scene;
}

constexpr BuiltinParameter kParameters[] = {{"blocks", 12, 2, 64, "blocks along each side, 90 metres each"}};

} // namespace

constinit const BuiltinScene kCity = {"city", "streets and buildings over a square kilometre", kParameters, build};

} // namespace lixel::builtin
