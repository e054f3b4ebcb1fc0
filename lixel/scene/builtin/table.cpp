// SPDX-License-Identifier: MIT
#include "lixel/scene/builtin/assemble.h"
#include "lixel/scene/builtin/dice.h"
#include "lixel/scene/builtin/scenes.h"
#include "lixel/scene/builtin/textures.h"
#include "lixel/scene/builtin/things.h"

#include <algorithm>
#include <cmath>

// A laid table over a floor of planks, in the corner of a room with a window.
namespace lixel::builtin {

namespace {

constexpr double kTableHeight = 0.74, kTableWidth = 2.1, kTableDepth = 1.1;
constexpr double kBack = -1.9, kLeft = -2.5, kRight = 2.8, kFront = 2.6; // the room's inner sides, metres
constexpr double kRoomHeight = 2.6;
constexpr double kSink = 0.0003; // how deep things dip into what they stand on

void addRoom(Scene& scene)
{
    const int wood = addTextured(scene, planks(0xa9784f, 0x5d4129, 6)),
              wall = addTextured(scene, plaster(0xe7dfcf, 0.03));
    addStatic(scene, "floor", box({kLeft - 0.1, -0.15, kBack - 0.1}, {kRight, 0, kFront}, 1.8), wood);
    addStatic(scene, "wall", box({kLeft - 0.12, -0.1, kBack - 0.2}, {kRight + 0.02, kRoomHeight, kBack}, 2), wall);
    const Mesh windowed = wallWithHole({{kBack - 0.15, -0.12}, {kFront - 0.01, kRoomHeight + 0.03}},
                                       {{-0.95, 0.9}, {1.05, 2.2}}, 0.16, 2);
    Mesh leftWall;
    append(leftWall, windowed, at({kLeft - 0.08, 0, 0}) * turnedY(-90));
    addStatic(scene, "window wall", leftWall, wall);

    // Glazing bars: thin, in the middle of the wall, reaching a little into it.
    Mesh bars;
    for (double z : {-0.55, -0.05, 0.45}) append(bars, boxAround({kLeft - 0.08, 1.55, z}, {0.03, 1.32, 0.03}));
    for (double y : {1.33, 1.77}) append(bars, boxAround({kLeft - 0.08, y, -0.05}, {0.028, 0.03, 2.02}));
    addStatic(scene, "window bars", bars, addMaterial(scene, 0xf4f1ea));
    addPlane(scene, "floor", {0, 0, 0}, {0, 1, 0});
    addPlane(scene, "wall", {0, 0, kBack}, {0, 0, 1});
    const double x = 0.5 * kTableWidth, z = 0.5 * kTableDepth, y = kTableHeight - kSink;
    addPlane(scene, "table", {0, y, 0}, {0, 1, 0}, {{-x, y, -z}, {-x, y, z}, {x, y, z}, {x, y, -z}});
}

void addFurniture(Scene& scene)
{
    addNode(scene, "table",
            {addMesh(scene, tableFrame(kTableWidth, kTableDepth, kTableHeight),
                     addTextured(scene, planks(0xc79a63, 0xa87b47, 4)))},
            {{0, -kSink, 0}});
    const int seat = addMesh(scene, chair(), addMaterial(scene, 0x3f6e7a));
    addNode(scene, "chair 1", {seat}, {{-0.5, -kSink, -0.72}, 8});
    addNode(scene, "chair 2", {seat}, {{0.55, -kSink, -0.75}, -6});
    addNode(scene, "chair 3", {seat}, {{1.45, -kSink, 0.25}, -100});
    addNode(scene, "chair 4", {seat}, {{-0.35, -kSink, 1.05}, 195});
    addNode(scene, "basket", {addMesh(scene, basket(36), addMaterial(scene, 0xb58a54))},
            {{-1.75, -kSink, 0.9}, 0, {2, 2, 2}});
}

// Kinds of things in turn, on the cells of a grid, each turned its own way; more things are smaller.
void addThings(Scene& scene, int count)
{
    const std::vector<int> kinds = {addMesh(scene, teapot(48), addMaterial(scene, 0x2f6f9f)),
                                    addMesh(scene, plate(64), addMaterial(scene, 0xf1eee6)),
                                    addMesh(scene, candlestick(48), addMaterial(scene, 0xc9a24a)),
                                    addMesh(scene, bowl(64), addMaterial(scene, 0xd9694f)),
                                    addMesh(scene, mug(48), addMaterial(scene, 0xe7b23f)),
                                    addMesh(scene, bookStack(3, 5), addMaterial(scene, 0x8a3b3b)),
                                    addMesh(scene, goblet(48), addMaterial(scene, 0x9fb7c4)),
                                    addMesh(scene, basket(28), addMaterial(scene, 0x9a6a3a)),
                                    addMesh(scene, vase(64), addMaterial(scene, 0x4f8f73)),
                                    addMesh(scene, pear(40), addMaterial(scene, 0xb8b84a)),
                                    addMesh(scene, mug(48), addMaterial(scene, 0xe9e4da)),
                                    addMesh(scene, bookStack(2, 9), addMaterial(scene, 0x3c5a8a))};
    const int fruit = addMesh(scene, apple(40), addMaterial(scene, 0xb8392f));
    const int columns = std::max(1, int(std::ceil(std::sqrt(1.9 * count)))), rows = (count + columns - 1) / columns;
    const double cellX = (kTableWidth - 0.12) / columns, cellZ = (kTableDepth - 0.12) / rows;
    const double size = std::min(1.0, std::min(cellX, cellZ) / 0.29);
    Dice dice(11);
    for (int i = 0; i < count; ++i) {
        const int column = i % columns, row = i / columns;
        const Vec3d centre{-0.5 * kTableWidth + 0.06 + (column + 0.5) * cellX, kTableHeight - 2 * kSink,
                           -0.5 * kTableDepth + 0.06 + (row + 0.5) * cellZ};
        const double free = 0.03 * size;
        const Vec3d position = centre + Vec3d{dice.uniform(-free, free), 0, dice.uniform(-free, free)};
        const std::size_t kind = std::size_t(i) % kinds.size();
        addNode(scene, "thing " + std::to_string(i + 1), {kinds[kind]},
                {position, dice.uniform(0, 360), {size, size, size}});

        // A fruit lies on every plate and in every bowl.
        if (kind == 1 || kind == 3)
            addNode(scene, "apple " + std::to_string(i + 1), {fruit},
                    {position + Vec3d{0, (kind == 1 ? 0.005 : 0.0165) * size, 0},
                     dice.uniform(0, 360),
                     {size, size, size}});
    }
}

void addViews(Scene& scene)
{
    const Light window = sun({0.9, -0.41, -0.1}), evening = sun({0.93, -0.34, 0.02});
    const Light hanging = spot({0.15, 2.45, 0.1}, {0.1, 0, 0}, 116, "ceiling-spot");
    addView(scene, "overview", "table and chairs, sun from the open side",
            lookAt({1.9, 1.95, 2.9}, {-0.25, 0.55, -0.15}, 46), {sun({-0.62, -0.7, -0.36})});
    addView(scene, "window-sun", "down on the table, sun through the window",
            lookAt({0.5, 1.55, 1.45}, {-0.05, 0.72, -0.1}, 46), {window});
    addView(scene, "close-up", "things on the table from close by", lookAt({-0.15, 1.0, 0.85}, {-0.3, 0.8, -0.1}, 42),
            {sun({-0.5, -0.7, -0.5})});
    addView(scene, "ceiling-spot", "a spot above the table", lookAt({-1.6, 1.9, 2.4}, {0.15, 0.5, -0.15}, 48),
            {hanging});
    addView(scene, "under-table", "from the floor between the legs", lookAt({1.0, 0.25, 1.9}, {-0.3, 0.42, -0.6}, 52),
            {sun({0.45, -0.5, -0.6})});
    addView(scene, "low-wall", "a hand above the floor, looking at the wall",
            lookAt({2.1, 0.1, 1.9}, {-0.6, 0.75, -1.9}, 50), {sun({-0.55, -0.55, -0.62})});
    addView(scene, "grazing", "light that all but skims the table", lookAt({0.9, 1.35, 1.7}, {-0.1, 0.68, -0.1}, 46),
            {sun({-0.97, -0.17, -0.17})});
    addView(scene, "light-in-front", "looking at the window, shadows come forward",
            lookAt({2.5, 1.55, 0.5}, {-0.6, 0.7, -0.1}, 48), {evening});
    addView(scene, "light-in-frustum", "a bare bulb over the table, in the picture",
            lookAt({0.5, 1.5, 2.7}, {0, 0.95, 0}, 50), {lamp({-0.1, 1.72, 0.1}, "bulb")});
    addView(scene, "light-at-eye", "a lamp worn on the head", lookAt({1.35, 1.6, 1.9}, {-0.1, 0.65, -0.2}, 48),
            {spot({1.35, 1.6, 1.9}, {-0.1, 0.65, -0.2}, 90, "head-lamp")});
    addView(scene, "two-lights", "sun through the window and a ceiling spot",
            lookAt({1.6, 2.1, 2.5}, {-0.2, 0.6, -0.15}, 48),
            {tinted(window, {0.7, 0.65, 0.55}), tinted(hanging, {0.3, 0.36, 0.5})});
}

Scene build(std::span<const double> values)
{
    Scene scene = emptyScene("table");
    addRoom(scene);
    addFurniture(scene);
    addThings(scene, int(values[0]));
    addViews(scene);
    addPath(scene, LightKind::Directional, 1.5,
            {{{1.9, 1.95, 2.9}, {-0.25, 0.55, -0.15}, {0.9, -0.41, -0.1}},
             {{1.2, 1.7, 2.2}, {-0.15, 0.65, -0.15}, {0.88, -0.5, -0.02}},
             {{0.5, 1.55, 1.5}, {-0.05, 0.72, -0.1}, {0.9, -0.42, 0.05}},
             {{-0.9, 1.7, 1.9}, {0.1, 0.68, -0.1}, {0.9, -0.36, 0.1}}});
    return scene;
}

constexpr BuiltinParameter kParameters[] = {{"things", 16, 1, 400, "things on the table"}};

} // namespace

constinit const BuiltinScene kTable = {"table", "a laid table over a floor, beside a window", kParameters, build};

} // namespace lixel::builtin
