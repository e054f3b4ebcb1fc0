// SPDX-License-Identifier: MIT
#include "lixel/scene/builtin/assemble.h"
#include "lixel/scene/builtin/scenes.h"
#include "lixel/scene/builtin/shapes.h"
#include "lixel/scene/builtin/textures.h"

#include <array>
#include <cmath>
#include <numbers>

// A long hall of square bays under groin vaults. Its left arcade (-x) is open to the sun behind a thin railing, the
// right one has curtains, an aisle and a wall with windows; the near end is open, the far end has a window behind a
// grille. The hall runs from z = 0 towards -z.
namespace lixel::builtin {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kBay = 6, kHalf = kBay / 2; // columns stand at x = +-kHalf, z = -k * kBay
constexpr double kSpring = 4, kTop = 7.4;    // where vaults start and where walls end
constexpr double kWallX = 6.2;               // inner side of the aisle's wall
constexpr double kRib = 0.32;                // how far arches stay inside the vault's own circle
constexpr double kGround = -0.35;
constexpr int kArcSteps = 48;

// Points of the half circle of that radius about (0, kSpring), from -x to +x; its ends exactly level.
std::vector<Vec2d> arc(double radius)
{
    std::vector<Vec2d> points;
    for (int i = 0; i <= kArcSteps; ++i) {
        const double a = kPi * (1 - double(i) / kArcSteps);
        points.push_back({radius * std::cos(a), kSpring + (i == 0 || i == kArcSteps ? 0 : radius * std::sin(a))});
    }
    return points;
}

// The wall over an arch, up to the roof and a little into it.
Mesh spandrel(double depth, double top)
{
    const std::vector<Vec2d> lower = arc(kHalf - kRib);
    std::vector<Vec2d> upper;
    for (std::size_t i = 0; i < lower.size(); ++i) upper.push_back({kHalf * (2.0 * double(i) / kArcSteps - 1), top});
    return band(lower, upper, depth, 2);
}

// One bay of a groin vault, centred: two barrels of radius kHalf cross, and each of the four webs is a piece of one of
// them.
Mesh groinVault()
{
    Mesh vault;
    for (int quarter = 0; quarter < 4; ++quarter) {
        const Mesh web = surface(
            [](double u, double v) {
                const double a = kPi * u, z = u == 0.5 ? 0 : kHalf * std::cos(a);
                const double fromGroin = std::abs(z);
                return Vec3d{fromGroin + v * (kHalf - fromGroin),
                             kSpring + (u == 0 || u == 1 ? 0 : kHalf * std::sin(a)), z};
            },
            kArcSteps, 12, {3, 1});
        append(vault, web, turnedY(90 * quarter));
    }
    return vault;
}

Mesh column()
{
    const Vec2d points[] = {{0, 0.2},     {0.36, 0.2},  {0.38, 0.24}, {0.36, 0.3},  {0.31, 0.34},
                            {0.31, 0.34}, {0.305, 1.6}, {0.265, 3.5}, {0.265, 3.5}, {0.29, 3.53},
                            {0.27, 3.56}, {0.27, 3.6},  {0.36, 3.78}, {0.36, 3.78}, {0, 3.78}};
    Mesh mesh = lathe(smoothProfile(points, 6), 48, {4, 1});
    append(mesh, boxAround({0, 0.1, 0}, {0.86, 0.21, 0.86}));
    append(mesh, boxAround({0, 3.887, 0}, {0.8, 0.234, 0.8}));
    return mesh;
}

// From z = -from to z = -to along x = 0.
Mesh railing(double from, double to)
{
    Mesh mesh;
    append(mesh, rod({0, 1.0, -from}, {0, 1.0, -to}, 0.025, 16));
    append(mesh, rod({0, 0.12, -from}, {0, 0.12, -to}, 0.014, 12));
    const int bars = int(std::floor((to - from) / 0.13));
    for (int i = 1; i < bars; ++i) {
        const double z = -from - (to - from) * i / bars;
        append(mesh, rod({0, -0.002, z}, {0, 0.99, z}, 0.008, 8));
    }
    return mesh;
}

// A hanging cloth along z, gathered more at the top.
Mesh curtain(double width, double bottom, double top)
{
    return surface(
        [=](double u, double v) {
            const double fold = 0.05 + 0.04 * (1 - v), gather = 1 - 0.06 * std::sin(kPi * v);
            const double wave =
                std::sin(2 * kPi * 9 * u + 0.8 * std::sin(7 * u)) + 0.3 * std::sin(2 * kPi * 4 * u + 3 * v);
            return Vec3d{fold * wave, bottom + v * (top - bottom), width * gather * (u - 0.5)};
        },
        216, 24, {1, 1});
}

Mesh chandelier()
{
    Mesh mesh = torus(0.75, 0.03, 96, 16);
    append(mesh, torus(0.45, 0.02, 64, 12), at({0, 0.22, 0}));
    for (int i = 0; i < 12; ++i) {
        const Mat4d turn = turnedY(30 * i);
        append(mesh, cylinder(0.025, 0.16, 16), turn * at({0.75, 0.02, 0}));
        if (i % 3 == 0) append(mesh, rod({0.75, 0, 0}, {0, 1.2, 0}, 0.008, 8), turn);
        if (i % 3 == 0) append(mesh, rod({0.45, 0.22, 0}, {0.01, 1.19, 0}, 0.006, 8), turn);
    }
    append(mesh, rod({0, 1.19, 0}, {0, 2.3, 0}, 0.012, 10));
    return mesh;
}

Mesh bench()
{
    Mesh mesh = boxAround({0, 0.43, 0}, {0.42, 0.07, 1.9});
    for (double z : {-0.7, 0.7}) append(mesh, boxAround({0, 0.2, z}, {0.34, 0.402, 0.16}));
    return mesh;
}

void addShell(Scene& scene, int bays, int stone)
{
    const double length = kBay * bays, xMid = 0.5 * (kWallX - kHalf), xSpan = kWallX + kHalf + 2.2;
    addStatic(scene, "ground", box({-45, kGround - 0.4, -length - 45}, {45, kGround, 45}, 6),
              addTextured(scene, plaster(0x7f9a5c, 0.12)));
    addStatic(scene, "floor", box({xMid - 0.5 * xSpan, kGround - 0.1, -length - 0.8}, {xMid + 0.5 * xSpan, 0, 1.2}, 3),
              addTextured(scene, checker(0xe6dfd0, 0xb56f5a, 4)));
    addStatic(scene, "roof", box({-kHalf - 0.7, kTop - 0.01, -length - 0.7}, {kWallX + 0.7, kTop + 0.35, 0.7}, 3),
              addMaterial(scene, 0xa5583f));
    addPlane(scene, "floor", {0, 0, 0}, {0, 1, 0});
    addPlane(scene, "wall", {kWallX, 0, 0}, {-1, 0, 0});

    // The far wall, its window and the grille before it; it reaches a little under floor level and into the roof.
    const int plasterWall = addTextured(scene, plaster(0xe2d3b8, 0.05));
    Mesh farWall;
    append(farWall,
           wallWithHole({{-kHalf - 0.35, -0.1}, {kWallX + 0.3, kTop + 0.1}}, {{-1.1, 1.2}, {1.1, 5.2}}, 0.5, 2),
           at({0, 0, -length - 0.35}));
    addStatic(scene, "far wall", farWall, plasterWall);
    Mesh grille;
    append(grille,
           surface(
               [](double u, double v) {
                   return Vec3d{-1.15 + 2.3 * u, 1.15 + 4.1 * v, 0};
               },
               1, 1, {2.3 / 1.2, 4.1 / 1.2}),
           at({0, 0, -length - 0.3}));
    addStatic(scene, "grille", grille, addMasked(scene, chainLink(0x3b3f45, 5, 0.16)));

    // Outer wall of the aisle: one piece with a window in each bay, pilasters over the gaps between the pieces.
    Mesh walls, pilasters;
    const Mesh piece =
        wallWithHole({{-kHalf + 0.01, -0.1}, {kHalf - 0.01, kTop + 0.1}}, {{-0.7, 1.9}, {0.7, 4.6}}, 0.4, 2);
    for (int k = 0; k < bays; ++k) append(walls, piece, at({kWallX + 0.2, 0, -kBay * (k + 0.5)}) * turnedY(90));
    for (int k = 0; k <= bays; ++k)
        append(pilasters, boxAround({kWallX + 0.2, 0.5 * kTop, -kBay * k}, {0.64, kTop + 0.22, 0.7}));
    addStatic(scene, "aisle wall", walls, plasterWall);
    addStatic(scene, "pilasters", pilasters, stone);
}

void addArches(Scene& scene, int bays, int stone)
{
    const int vault = addMesh(scene, groinVault(), addTextured(scene, plaster(0xefe6d2, 0.03)));
    const int over = addMesh(scene, spandrel(0.46, kTop), stone),
              pillar = addMesh(scene, column(), addTextured(scene, plaster(0xd9c9a8, 0.06)));
    const int rib = addMesh(scene, band(arc(kHalf - kRib), arc(kHalf + 0.02), 0.42, 2), stone);
    const int end = addMesh(scene, spandrel(0.44, kTop + 0.05), stone);
    for (int k = 0; k <= bays; ++k) {
        const std::string number = " " + std::to_string(k + 1);
        for (double x : {-kHalf, kHalf}) addNode(scene, "column" + number, {pillar}, {{x, 0, -kBay * k}});
        addNode(scene, "rib" + number, {k == 0 ? end : rib}, {{0, 0, -kBay * k}});
        if (k == bays) break;
        addNode(scene, "vault" + number, {vault}, {{0, 0, -kBay * (k + 0.5)}});
        for (double x : {-kHalf, kHalf}) addNode(scene, "arcade" + number, {over}, {{x, 0, -kBay * (k + 0.5)}, 90});
    }
}

void addFittings(Scene& scene, int bays)
{
    const int iron = addMaterial(scene, 0x43484e), wood = addTextured(scene, planks(0x8b5e3a, 0x5f3f26, 5));
    const std::array<int, 2> cloth = {addMaterial(scene, 0xa33b34), addMaterial(scene, 0x2f5d7c)};
    const int rail = addMesh(scene, railing(0.38, kBay - 0.38), iron), seat = addMesh(scene, bench(), wood);
    const int rodMesh = addMesh(scene, rod({0, 3.62, -0.2}, {0, 3.62, -kBay + 0.2}, 0.03, 16), iron);
    const std::array<int, 2> drapes = {addMesh(scene, curtain(1.9, 0.12, 3.6), cloth[0]),
                                       addMesh(scene, curtain(1.9, 0.12, 3.6), cloth[1])};
    const int light = addMesh(scene, chandelier(), addMaterial(scene, 0xb08d45));
    for (int k = 0; k < bays; ++k) {
        const double start = -kBay * k, middle = start - 0.5 * kBay;
        const std::string number = " " + std::to_string(k + 1);
        if (k % 3 != 1) addNode(scene, "railing" + number, {rail}, {{-kHalf, 0, start}});
        addNode(scene, "curtain rod" + number, {rodMesh}, {{kHalf, 0, start}});
        const int drape = drapes[std::size_t(k % 2)];
        addNode(scene, "curtain" + number, {drape}, {{kHalf, 0, start - 1.35}});
        addNode(scene, "curtain" + number, {drape}, {{kHalf, 0.01, start - kBay + 1.35}});
        addNode(scene, "bench" + number, {seat}, {{kWallX - 0.55, 0, middle}});
        if (k % 2 == 0) addNode(scene, "chandelier" + number, {light}, {{0, 4.75, middle}});
    }
}

void addViews(Scene& scene, double length)
{
    const double mid = -0.5 * length;
    const Light afternoon = sun({0.8, -0.52, -0.3});
    addView(scene, "overview", "down the hall, sun through the open arcade",
            lookAt({0.9, 1.75, 0.4}, {-0.1, 2.3, -8}, 58), {afternoon});
    addView(scene, "aisle", "along the aisle behind the curtains", lookAt({4.9, 1.7, -0.6}, {4.1, 1.8, -8}, 56),
            {sun({0.84, -0.48, -0.25})});
    addView(scene, "curtains", "across the hall at the curtains",
            lookAt({-2.2, 1.8, mid + 4.2}, {3, 1.5, mid - 1.2}, 56), {sun({0.75, -0.62, -0.3})});
    addView(scene, "vaults", "up into the vaults, low sun", lookAt({-1.2, 1.2, mid + 7}, {0.6, 5.4, mid - 1}, 60),
            {sun({0.96, -0.16, -0.25})});
    addView(scene, "outside", "the open arcade from the lawn", lookAt({-12.5, 3.2, 4.5}, {0.5, 2.4, mid + 4.5}, 46),
            {sun({0.62, -0.7, -0.35})});
    addView(scene, "railing", "the railing and its shadow from close by",
            lookAt({-1.0, 1.15, -0.4}, {-2.9, 0.45, -3.6}, 50), {sun({0.78, -0.55, 0.3})});
    addView(scene, "light-in-front", "from the aisle against the low sun",
            lookAt({2.6, 2.0, mid + 3.2}, {-3.2, 0.55, mid - 0.6}, 56), {sun({0.88, -0.4, 0.25})});
    addView(scene, "grazing", "the sun through the open end, skimming the floor",
            lookAt({-1.4, 1.7, 0.6}, {0.6, 1.2, -8}, 56), {sun({0.12, -0.11, -0.98})});
    addView(scene, "low-wall", "a hand above the floor, looking at the aisle's wall",
            lookAt({-1.2, 0.13, mid + 0.4}, {6.2, 1.3, mid - 1.5}, 56), {sun({0.86, -0.38, -0.3})});
    addView(scene, "light-in-frustum", "a lamp in the picture, in the middle of the hall",
            lookAt({-0.7, 1.8, -0.6}, {0, 2.6, -8}, 60), {lamp({0.2, 3.3, -6.5}, "hanging-lamp")});
    addView(scene, "light-at-eye", "a lamp worn on the head", lookAt({-0.5, 1.8, -1}, {1.4, 1.8, -9}, 56),
            {spot({-0.5, 1.8, -1}, {1.4, 1.8, -9}, 100, "head-lamp")});
    addView(scene, "two-lights", "sun and a spot from the vault", lookAt({1.4, 2.1, -0.2}, {-0.4, 1.6, -8}, 56),
            {tinted(afternoon, {0.75, 0.68, 0.55}), tinted(spot({0, 6.3, -3.2}, {0.3, 0, -9}, 70), {0.35, 0.42, 0.6})});
}

Scene build(std::span<const double> values)
{
    const int bays = int(values[0]);
    Scene scene = emptyScene("colonnade");
    const int stone = addTextured(scene, plaster(0xcdbb98, 0.07));
    addShell(scene, bays, stone);
    addArches(scene, bays, stone);
    addFittings(scene, bays);
    addViews(scene, kBay * bays);
    addPath(scene, LightKind::Directional, 2,
            {{{0.9, 1.75, 0.4}, {-0.1, 2.3, -8}, {0.8, -0.52, -0.3}},
             {{0.4, 1.8, -3}, {0.3, 2.3, -11}, {0.82, -0.52, -0.1}},
             {{-0.4, 1.8, -6}, {1.2, 2.1, -13}, {0.84, -0.44, 0.05}},
             {{-1.2, 1.9, -8}, {3, 1.9, -13}, {0.86, -0.36, 0.2}},
             {{-1.8, 1.9, -8.5}, {3.4, 1.7, -11}, {0.88, -0.3, 0.3}}});
    return scene;
}

constexpr BuiltinParameter kParameters[] = {{"bays", 5, 2, 60, "bays of the hall, six metres each"}};

} // namespace

constinit const BuiltinScene kColonnade = {
    "colonnade", "a long vaulted hall with columns, curtains and thin railings, open to the sun", kParameters, build};

} // namespace lixel::builtin
