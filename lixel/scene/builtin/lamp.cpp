// SPDX-License-Identifier: MIT
#include "lixel/scene/builtin/assemble.h"
#include "lixel/scene/builtin/dice.h"
#include "lixel/scene/builtin/scenes.h"
#include "lixel/scene/builtin/textures.h"
#include "lixel/scene/builtin/things.h"

#include <algorithm>
#include <cmath>
#include <numbers>

// A closed room at night: a ribbed lamp hangs over a round table, and everything around throws shadows on walls, floor
// and ceiling. Seen from the lamp the room is on all sides, so that no single map can serve it.
namespace lixel::builtin {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kHalfX = 3.2, kHalfZ = 2.6, kHeight = 2.7; // of the room inside, metres
constexpr Vec3d kBulb{0, 1.62, 0};                          // where the lamp's light is
constexpr double kSink = 0.0003;

// Ribs between two rings, a cap above; the bulb's place stays free. Its origin is the bulb.
Mesh shade(int ribs)
{
    Mesh mesh;
    for (int i = 0; i < ribs; ++i) {
        std::vector<Vec3d> rib;
        for (int k = 0; k <= 16; ++k) {
            const double a = kPi * (0.12 + 0.56 * k / 16);
            rib.push_back({0.32 * std::sin(a), 0.26 * std::cos(a), 0});
        }
        append(mesh, tube(rib, 0.006, 0.006, 8), turnedY(360.0 * i / ribs));
    }
    append(mesh, torus(0.32 * std::sin(0.12 * kPi), 0.01, 48, 12), at({0, 0.26 * std::cos(0.12 * kPi), 0}));
    append(mesh, torus(0.32 * std::sin(0.68 * kPi), 0.012, 96, 12), at({0, 0.26 * std::cos(0.68 * kPi), 0}));
    append(mesh, torus(0.321, 0.005, 96, 10));
    append(mesh, cylinder(0.05, 0.09, 32), at({0, 0.16, 0}));
    append(mesh, rod({0, 0.245, 0}, {0, kHeight - kBulb.y + 0.01, 0}, 0.008, 10));
    return mesh;
}

Mesh roundTable()
{
    const Vec2d points[] = {{0, 0},      {0.26, 0},    {0.26, 0},   {0.27, 0.02}, {0.2, 0.05}, {0.06, 0.09},
                            {0.04, 0.2}, {0.06, 0.42}, {0.05, 0.6}, {0.13, 0.7},  {0.13, 0.7}, {0, 0.7}};
    Mesh mesh = lathe(smoothProfile(points, 6), 64);
    const Vec2d top[] = {{0, 0.698}, {0.6, 0.698}, {0.615, 0.71}, {0.615, 0.72}, {0.6, 0.73}, {0.6, 0.73}, {0, 0.73}};
    append(mesh, lathe(top, 96));
    return mesh;
}

Mesh shelf(double width, double height, int boards)
{
    Mesh mesh;
    for (double x : {-0.5 * width, 0.5 * width}) append(mesh, boxAround({x, 0.5 * height, 0}, {0.03, height, 0.26}));
    for (int i = 0; i < boards; ++i)
        append(mesh, boxAround({0, 0.08 + (height - 0.1) * i / (boards - 1), 0.002}, {width, 0.025, 0.25}));
    return mesh;
}

// Books stand side by side on each board of such a shelf but the top one, with gaps where something else may stand.
Mesh shelvedBooks(double width, double height, int boards, std::uint64_t seed)
{
    Dice dice(seed);
    Mesh mesh;
    for (int i = 0; i + 1 < boards; ++i) {
        const double y = 0.0922 + (height - 0.1) * i / (boards - 1);
        for (double x = -0.5 * width + 0.03; x < 0.5 * width - 0.07;) {
            const double w = dice.uniform(0.018, 0.05), h = dice.uniform(0.17, 0.26), d = dice.uniform(0.13, 0.2);
            if (dice.chance(0.86)) append(mesh, box({x, y, -0.11}, {x + w, y + h, -0.11 + d}));
            x += w + 0.0015;
        }
    }
    return mesh;
}

Mesh pot()
{
    const Vec2d points[] = {{0, 0},        {0.11, 0},     {0.11, 0},     {0.15, 0.26}, {0.15, 0.26},
                            {0.165, 0.26}, {0.165, 0.26}, {0.165, 0.3},  {0.165, 0.3}, {0.14, 0.3},
                            {0.14, 0.3},   {0.135, 0.25}, {0.135, 0.25}, {0, 0.26}};
    return lathe(points, 48);
}

// Stems rise from the pot's middle and arch over.
struct Stem
{
    double turnDegrees, reach, high;

    Vec3d point(double t) const { return {reach * t, 0.25 + high * t * (1.6 - 0.8 * t), 0}; }
};

std::vector<Stem> plantStems(Dice& dice)
{
    std::vector<Stem> stems;
    for (int i = 0; i < 14; ++i)
        stems.push_back({360.0 * i / 14 + dice.uniform(-12, 12), dice.uniform(0.2, 0.55), dice.uniform(0.5, 1.0)});
    return stems;
}

Mesh stemTubes(const std::vector<Stem>& stems)
{
    Mesh mesh;
    for (const Stem& stem : stems) {
        std::vector<Vec3d> path;
        for (int i = 0; i <= 12; ++i) path.push_back(stem.point(i / 12.0));
        append(mesh, tube(path, 0.006, 0.003, 8), turnedY(stem.turnDegrees));
    }
    return mesh;
}

// Pairs of leaves, smaller towards the tip; each is one bent sheet.
Mesh foliage(const std::vector<Stem>& stems, Dice& dice)
{
    Mesh mesh;
    for (const Stem& stem : stems)
        for (int i = 2; i <= 9; ++i) {
            const double t = i / 9.0, size = 0.2 * (1.2 - 0.6 * t);
            const auto sheet = [=](double u, double v) {
                return Vec3d{0.5 * size * (u - 0.5), 0.3 * size * v * v - 0.15 * size * std::abs(u - 0.5), size * v};
            };
            for (double side : {-1.0, 1.0})
                append(mesh, surface(sheet, 2, 4),
                       turnedY(stem.turnDegrees) * at(stem.point(t)) * turnedY(90 + side * 55) *
                           turned({1, 0, 0}, dice.uniform(-35, 5)));
        }
    return mesh;
}

Mesh ladder(double height)
{
    Mesh mesh;
    for (double x : {-0.2, 0.2}) append(mesh, rod({x, -0.002, 0.35}, {x, height, 0}, 0.018, 12));
    for (int i = 1; i < 8; ++i) {
        const double t = i / 8.0;
        append(mesh, rod({-0.2, height * t, 0.35 * (1 - t)}, {0.2, height * t, 0.35 * (1 - t)}, 0.014, 10));
    }
    return mesh;
}

void addRoom(Scene& scene)
{
    const int wall = addTextured(scene, stripes(0xcfd8c7, 0xbfcab5, 8)), plain = addMaterial(scene, 0xeae6da);
    const double x = kHalfX, z = kHalfZ, h = kHeight;
    addStatic(scene, "floor", box({-x - 0.05, -0.2, -z - 0.05}, {x + 0.05, 0, z + 0.05}, 1.6),
              addTextured(scene, planks(0x9a6b43, 0x5a3d26, 6)));
    addStatic(scene, "ceiling", box({-x - 0.06, h, -z - 0.06}, {x + 0.06, h + 0.2, z + 0.06}), plain);
    Mesh walls;
    append(walls, box({-x - 0.2, -0.1, -z - 0.2}, {x + 0.2, h + 0.1, -z}, 1.2));
    append(walls, box({-x - 0.21, -0.11, z}, {x + 0.21, h + 0.11, z + 0.2}, 1.2));
    append(walls, box({-x - 0.19, -0.12, -z - 0.1}, {-x, h + 0.12, z + 0.1}, 1.2));
    append(walls, box({x, -0.13, -z - 0.11}, {x + 0.19, h + 0.13, z + 0.11}, 1.2));
    addStatic(scene, "walls", walls, wall);
    addPlane(scene, "floor", {0, 0, 0}, {0, 1, 0});
    addPlane(scene, "ceiling", {0, h, 0}, {0, -1, 0});
    addPlane(scene, "wall", {0, 0, -z}, {0, 0, 1});
    addPlane(scene, "left-wall", {-x, 0, 0}, {1, 0, 0});
}

void addFurniture(Scene& scene)
{
    const int wood = addMaterial(scene, 0x8a5a36), seat = addMesh(scene, chair(), addMaterial(scene, 0xb04a3c));
    addNode(scene, "lamp", {addMesh(scene, shade(28), addMaterial(scene, 0x55483a))}, {kBulb});
    addNode(scene, "table", {addMesh(scene, roundTable(), wood)}, {{0, -kSink, 0}});
    for (int i = 0; i < 4; ++i) {
        const double a = (35 + 90 * i) * kPi / 180;
        addNode(scene, "chair " + std::to_string(i + 1), {seat},
                {{0.95 * std::sin(a), -kSink, 0.95 * std::cos(a)}, 180.0 + 35 + 90 * i + 9 * (i % 2)});
    }
    const int frame = addMesh(scene, shelf(1.5, 2.0, 6), wood);
    addNode(scene, "shelf", {frame, addMesh(scene, shelvedBooks(1.5, 2.0, 6, 3), addMaterial(scene, 0x4a6b8a))},
            {{-1.5, -kSink, -kHalfZ + 0.15}});
    addNode(scene, "shelf 2", {frame, addMesh(scene, shelvedBooks(1.5, 2.0, 6, 14), addMaterial(scene, 0x8a4a4a))},
            {{-kHalfX + 0.15, -kSink, 0.6}, 90});
    const int green = addMasked(scene, leaf(0x4f8f4a, 0x9cc47e));
    Dice dice(6);
    const std::vector<Stem> stems = plantStems(dice);
    const std::vector<int> plant = {addMesh(scene, pot(), addMaterial(scene, 0xb5643c)),
                                    addMesh(scene, stemTubes(stems), addMaterial(scene, 0x567a45)),
                                    addMesh(scene, foliage(stems, dice), green)};
    addNode(scene, "plant", plant, {{2.55, -kSink, -1.95}});
    addNode(scene, "plant 2", plant, {{-2.5, -kSink, -1.2}, 70, {0.8, 0.8, 0.8}});
    addNode(scene, "ladder", {addMesh(scene, ladder(2.3), addMaterial(scene, 0xc9a46a))}, {{1.2, 0, -kHalfZ + 0.05}});
    addNode(scene, "basket", {addMesh(scene, basket(36), addMaterial(scene, 0xb58a54))},
            {{1.7, -kSink, 1.5}, 0, {3, 3, 3}});
    addNode(scene, "bunny", {addMesh(scene, bunny(), addMaterial(scene, 0xe8d8c0))},
            {{2.3, -kSink, 0.2}, 20, {0.6, 0.6, 0.6}});
}

// Small things: the first few on the table, the rest on the floor along a ring around the chairs.
void addThings(Scene& scene, int count)
{
    const std::vector<int> kinds = {addMesh(scene, teapot(48), addMaterial(scene, 0x3a6ea5)),
                                    addMesh(scene, mug(48), addMaterial(scene, 0xe7b23f)),
                                    addMesh(scene, bowl(64), addMaterial(scene, 0xd9694f)),
                                    addMesh(scene, goblet(48), addMaterial(scene, 0xaec3cf)),
                                    addMesh(scene, vase(64), addMaterial(scene, 0x6a4f8f)),
                                    addMesh(scene, bookStack(4, 2), addMaterial(scene, 0x4b7a5a)),
                                    addMesh(scene, candlestick(48), addMaterial(scene, 0xc9a24a))};
    const int onTable = std::min(count, 6);
    Dice dice(17);
    for (int i = 0; i < count; ++i) {
        const bool isOnTable = i < onTable;
        const double a = isOnTable ? 2 * kPi * i / onTable : 2.399963229728653 * i;
        const double r = isOnTable ? 0.36 : dice.uniform(1.45, 2.15);
        const double size = isOnTable ? 1 : dice.uniform(1.2, 2) * std::min(1.0, std::sqrt(60.0 / count));
        const Vec3d position{(isOnTable ? r : 1.25 * r) * std::cos(a), (isOnTable ? 0.73 - kSink : 0) - kSink,
                             r * std::sin(a)};
        addNode(scene, "thing " + std::to_string(i + 1), {kinds[std::size_t(i) % kinds.size()]},
                {position, dice.uniform(0, 360), {size, size, size}});
    }
}

void addViews(Scene& scene)
{
    const Light bulb = lamp(kBulb, "bulb");
    addView(scene, "overview", "the room from one corner, the lamp in the picture",
            lookAt({2.75, 2.05, 2.25}, {-0.55, 0.95, -0.5}, 62), {bulb});
    addView(scene, "corner", "from the opposite corner, wall, floor and ceiling",
            lookAt({-2.6, 1.7, 2.2}, {1.3, 1.15, -1.5}, 64), {bulb});
    addView(scene, "ceiling", "the ribs' fan of shadows on the ceiling", lookAt({1.9, 0.7, 1.7}, {-0.5, 2.3, -0.8}, 62),
            {bulb});
    addView(scene, "table", "the table from above a chair", lookAt({0.95, 1.45, 1.2}, {-0.15, 0.68, -0.15}, 54),
            {bulb});
    addView(scene, "low-wall", "a hand above the floor, looking at the shelf",
            lookAt({0.35, 0.12, 2.3}, {-0.8, 0.85, -2.6}, 58), {bulb});
    addView(scene, "plant", "leaves against the corner", lookAt({1.2, 1.5, -0.2}, {2.65, 0.8, -2.1}, 56), {bulb});
    addView(scene, "light-in-front", "the lamp between the eye and the wall",
            lookAt({0.35, 1.4, 2.4}, {-0.1, 1.25, -2.6}, 58), {bulb});
    addView(scene, "light-at-eye", "a lamp worn on the head", lookAt({2.6, 1.7, 1.9}, {-0.6, 0.9, -0.7}, 60),
            {spot({2.6, 1.7, 1.9}, {-0.6, 0.9, -0.7}, 110, "head-lamp")});
    addView(scene, "floor-lamp", "a light on the floor throws everything up the walls",
            lookAt({2.5, 1.7, 2.1}, {-0.7, 0.95, -0.7}, 62), {lamp({-0.9, 0.25, 1.35}, "floor-lamp")});
    addView(scene, "grazing", "a spot along the wall behind shelf and ladder",
            lookAt({0.6, 1.6, 2.2}, {-0.3, 1.1, -2.6}, 62),
            {spot({3.05, 2.2, -1.9}, {-1.2, 1.0, -2.6}, 70, "wall-spot")});
    addView(scene, "door", "a spot from the door's corner, everything before it",
            lookAt({-2.3, 1.9, 2.3}, {0.6, 0.75, -0.8}, 62),
            {spot({3.0, 2.4, 2.4}, {-0.4, 0.6, -0.5}, 100, "door-spot")});
    addView(scene, "two-lights", "the lamp and a cold spot", lookAt({2.6, 1.6, -0.2}, {-1.2, 0.95, 0.1}, 62),
            {tinted(bulb, {0.75, 0.62, 0.45}),
             tinted(spot({3.0, 2.4, -2.3}, {-1.0, 0.6, 0.5}, 80, "cold-spot"), {0.25, 0.33, 0.5})});
}

Scene build(std::span<const double> values)
{
    Scene scene = emptyScene("lamp");
    addRoom(scene);
    addFurniture(scene);
    addThings(scene, int(values[0]));
    addViews(scene);
    addPath(scene, LightKind::Point, 2,
            {{{2.75, 2.05, 2.25}, {-0.55, 0.95, -0.5}, kBulb},
             {{1.6, 1.9, 2.3}, {-0.4, 1.0, -0.6}, kBulb + Vec3d{0.04, 0, 0.02}},
             {{0.3, 1.7, 2.3}, {-0.1, 1.0, -0.6}, kBulb + Vec3d{-0.04, 0.01, 0.03}},
             {{-1.4, 1.6, 2.2}, {0.4, 1.0, -0.7}, kBulb + Vec3d{0, -0.02, -0.04}},
             {{-2.5, 1.7, 2.1}, {1.0, 1.0, -1.0}, kBulb}});
    return scene;
}

constexpr BuiltinParameter kParameters[] = {{"things", 24, 0, 1000, "small things on table and floor"}};

} // namespace

constinit const BuiltinScene kLamp = {"lamp", "a ribbed lamp in the middle of a full room at night", kParameters,
                                      build};

} // namespace lixel::builtin
