// SPDX-License-Identifier: MIT
#include "lixel/scene/builtin/assemble.h"
#include "lixel/scene/builtin/dice.h"
#include "lixel/scene/builtin/scenes.h"
#include "lixel/scene/builtin/shapes.h"
#include "lixel/scene/builtin/textures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

// Thin things over flat ground under a low sun: a picket fence with a gate, a wire fence, a chain-link panel, a trellis
// with leaves, a bare tree and tufts of grass.
namespace lixel::builtin {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kHalf = 16;  // of the ground, metres
constexpr double kDip = 0.02; // posts and stems reach this far below the ground
constexpr int kBladesPerTuft = 40;

Mesh picket()
{
    const Vec2d outline[] = {{0.04, 0.42}, {0, 0.47}, {-0.04, 0.42}, {-0.04, -0.5}, {0.04, -0.5}};
    Mesh mesh;
    append(mesh, prism(outline, 0.018), at({0, 0.55, 0}));
    return mesh;
}

// Along x from 0 to `length`, two rails behind the pickets.
Mesh picketFence(double length)
{
    Mesh mesh;
    const int pickets = std::max(2, int(std::lround(length / 0.135)));
    const Mesh one = picket();
    for (int i = 0; i < pickets; ++i) append(mesh, one, at({length * (i + 0.5) / pickets, 0, 0}));
    for (double y : {0.28, 0.78}) append(mesh, boxAround({0.5 * length, y, -0.025}, {length, 0.07, 0.034}));
    for (double x : {0.03, length - 0.03}) append(mesh, boxAround({x, 0.55 - kDip, -0.085}, {0.09, 1.1, 0.09}));
    return mesh;
}

// Along x, posts every three metres, wires that sag between them.
Mesh wireFence(int spans)
{
    constexpr double kSpan = 3;
    Mesh mesh;
    for (int i = 0; i <= spans; ++i) append(mesh, cylinder(0.045, 1.25 + kDip, 20), at({kSpan * i, -kDip, 0}));
    for (double y : {0.25, 0.5, 0.75, 1.0, 1.18}) {
        std::vector<Vec3d> path;
        for (int i = 0; i <= 24 * spans; ++i) {
            const double t = double(i % 24) / 24, sag = 0.16 * t * (1 - t);
            path.push_back({kSpan * i / 24, y - sag, 0.047});
        }
        append(mesh, tube(path, 0.004, 0.004, 6));
    }
    return mesh;
}

Mesh chainLinkFrame(double width, double height)
{
    Mesh mesh;
    for (double x : {0.0, width}) append(mesh, cylinder(0.03, height + 0.08 + kDip, 20), at({x, -kDip, 0}));
    for (double y : {0.06, height}) append(mesh, rod({0, y, 0}, {width, y, 0}, 0.018, 12));
    return mesh;
}

Mesh chainLinkPanel(double width, double height)
{
    return surface(
        [=](double u, double v) {
            return Vec3d{u * width, 0.06 + v * (height - 0.06), 0};
        },
        1, 1, {width / 0.6, (height - 0.06) / 0.6});
}

// Two leaning families of laths in an arched frame, 1.6 wide and 2.2 high.
Mesh trellis()
{
    Mesh mesh;
    std::vector<Vec3d> frame = {{-0.8, -kDip, 0}};
    for (int i = 0; i <= 24; ++i)
        frame.push_back({-0.8 * std::cos(kPi * i / 24), 1.4 + 0.8 * std::sin(kPi * i / 24), 0});
    frame.push_back({0.8, -kDip, 0});
    append(mesh, tube(frame, 0.028, 0.028, 16));
    const auto roof = [](double x) { return 1.4 + std::sqrt(std::max(0.0, 0.64 - x * x)); };
    for (int i = -11; i <= 11; ++i) {
        const double x0 = 0.2 * i;
        for (double slope : {-1.0, 1.0}) {
            // The lath x = x0 + slope * (y - 1.1), where it is inside the frame.
            double low = 0.1, high = 2.2;
            const auto inside = [&](double y) {
                const double x = x0 + slope * (y - 1.1);
                return std::abs(x) < 0.8 && y < roof(x);
            };
            while (low < high && !inside(low)) low += 0.01;
            while (high > low && !inside(high)) high -= 0.01;
            if (high - low < 0.15) continue;
            append(mesh, rod({x0 + slope * (low - 1.1), low, 0.008 * slope},
                             {x0 + slope * (high - 1.1), high, 0.008 * slope}, 0.008, 8));
        }
    }
    return mesh;
}

// Leaves are single quads, bent along their middle.
Mesh leaves(int count, double width, double height, std::uint64_t seed)
{
    Dice dice(seed);
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
        const double size = dice.uniform(0.07, 0.12);
        const Mesh one = surface(
            [=](double u, double v) {
                return Vec3d{size * (u - 0.5), size * v, 0.25 * size * std::abs(u - 0.5)};
            },
            2, 1);
        const double x = dice.uniform(-0.5, 0.5) * width, y = dice.uniform(0, 1) * dice.uniform(0.4, 1) * height + 0.12;
        append(mesh, one,
               at({x, y, dice.uniform(0.03, 0.08)}) * turnedY(dice.uniform(-50, 50)) *
                   turned({1, 0, 0}, dice.uniform(-70, 10)) * turned({0, 0, 1}, dice.uniform(0, 360)));
    }
    return mesh;
}

// Each branch bends, thins and forks.
void addBranch(Mesh& mesh, Dice& dice, Vec3d from, Vec3d along, double length, double radius, int level)
{
    std::vector<Vec3d> path = {from};
    Vec3d way = along;
    for (int i = 1; i <= 6; ++i) {
        way = normalized(way + Vec3d{dice.uniform(-0.14, 0.14), 0.04, dice.uniform(-0.14, 0.14)});
        path.push_back(path.back() + (length / 6) * way);
    }
    const double end = level == 0 ? 0.25 * radius : 0.62 * radius;
    append(mesh, tube(path, radius, end, std::max(6, 5 + 2 * level)));
    if (level == 0) return;
    const int forks = dice.integer(3, 4);
    for (int i = 0; i < forks; ++i) {
        const std::size_t at = i == 0 ? 6 : std::size_t(dice.integer(3, 6));
        const double angle = 2 * kPi * (i + dice.uniform(0, 0.7)) / forks;
        const Vec3d side = anyPerpendicular(way), other = cross(way, side);
        const Vec3d turn = normalized(way + 0.75 * (std::cos(angle) * side + std::sin(angle) * other));
        addBranch(mesh, dice, path[at], turn, length * dice.uniform(0.55, 0.75), end * dice.uniform(0.6, 0.85),
                  level - 1);
    }
}

Mesh tree(std::uint64_t seed)
{
    Dice dice(seed);
    Mesh mesh;
    addBranch(mesh, dice, {0, -kDip, 0}, {0, 1, 0}, 1.7, 0.1, 4);
    return mesh;
}

// Blades are narrow strips that bend over and end in a point.
Mesh tuft(std::uint64_t seed)
{
    Dice dice(seed);
    Mesh mesh;
    for (int i = 0; i < kBladesPerTuft; ++i) {
        const double height = dice.uniform(0.1, 0.34), bend = dice.uniform(0.02, 0.2),
                     width = dice.uniform(0.004, 0.008);
        const Mesh blade = surface(
            [=](double u, double v) {
                const double half = v == 1 ? 0 : width * (1 - v * v);
                return Vec3d{half * (2 * u - 1), height * v - kDip, bend * v * v};
            },
            1, 5);
        const double r = 0.16 * std::sqrt(dice.uniform(0, 1)), a = dice.uniform(0, 360);
        append(mesh, blade, turnedY(a) * at({0, 0, r}) * turnedY(dice.uniform(-60, 60)));
    }
    return mesh;
}

void addFences(Scene& scene, int spans)
{
    const int white = addMaterial(scene, 0xf0ede4), wood = addTextured(scene, planks(0x8d6b48, 0x6b4d32, 3)),
              steel = addMaterial(scene, 0x868d92);
    const int section = addMesh(scene, picketFence(3), white);
    for (int i = 0; i < spans; ++i) {
        const int place = i / 2; // counted from the gate, on either side
        const double x = i % 2 == 0 ? 0.9 + 3.16 * place : -3.9 - 3.16 * place;
        addNode(scene, "picket fence " + std::to_string(i + 1), {section}, {{x, 0, 0}});
    }
    addNode(scene, "gate", {addMesh(scene, picketFence(1.5), white)}, {{-0.72, 0, 0.02}, 58});
    addStatic(scene, "wire fence", wireFence(3), wood);
    scene.nodes.back().parentFromNode = transformOf({{-10.6, 0, 3.0}, 10});
    const int frame = addMesh(scene, chainLinkFrame(2.6, 1.9), steel),
              links = addMesh(scene, chainLinkPanel(2.6, 1.9), addMasked(scene, chainLink(0x8f979c, 6, 0.13)));
    for (int i = 0; i < 3; ++i)
        addNode(scene, "chain link " + std::to_string(i + 1), {frame, links}, {{2.2 + 2.75 * i, 0, -3.4}});
    addNode(scene, "trellis",
            {addMesh(scene, trellis(), wood),
             addMesh(scene, leaves(260, 1.5, 1.8, 8), addMasked(scene, leaf(0x5f8f3e, 0x9fbf6a)))},
            {{-3.2, 0, -2.6}, 18});
    addNode(scene, "tree", {addMesh(scene, tree(21), addMaterial(scene, 0x6d5a48))}, {{-5.6, 0, -4.4}});
}

void addGrass(Scene& scene, int tufts)
{
    std::vector<int> kinds;
    const std::array<std::uint32_t, 4> greens = {0x6f9440, 0x86a84c, 0x5b7f38, 0x9aab55};
    for (std::size_t i = 0; i < greens.size(); ++i) {
        kinds.push_back(addMesh(scene, tuft(30 + i), addMaterial(scene, greens[i])));
        scene.materials.back().doubleSided = true;
    }
    Dice dice(5);
    for (int i = 0; i < tufts; ++i) {
        // Thicker along the fence; the way through the gate stays clear.
        const bool nearFence = i % 3 != 0;
        double x = dice.uniform(-12, 12), z = nearFence ? dice.uniform(-0.5, 0.6) : dice.uniform(-7, 8);
        if (std::abs(x) < 1.25) x += x < 0 ? -1.6 : 1.6;
        const double size = dice.uniform(0.7, 1.3);
        addNode(scene, "grass " + std::to_string(i + 1), {kinds[std::size_t(i) % kinds.size()]},
                {{x, 0, z}, dice.uniform(0, 360), {size, size, size}});
    }
}

void addViews(Scene& scene)
{
    const Light evening = sun({-0.5, -0.26, 0.83});
    addView(scene, "overview", "the whole yard, long shadows towards the camera",
            lookAt({4.6, 2.3, 6.6}, {-0.9, 0.5, -1.0}, 46), {evening});
    addView(scene, "pickets", "the picket fence and its comb of shadows", lookAt({5.4, 1.5, 3.1}, {1.8, 0.25, 0.5}, 46),
            {evening});
    addView(scene, "wires", "wires and the lines they draw on the lawn",
            lookAt({-2.6, 1.5, 5.6}, {-5.2, 0.45, 2.2}, 48), {sun({0.35, -0.4, 0.85})});
    addView(scene, "chain-link", "through and under the chain-link panels",
            lookAt({7.6, 1.5, -0.7}, {4.6, 0.45, -3.0}, 50), {sun({0.2, -0.42, 0.88})});
    addView(scene, "trellis", "laths and leaves from close by", lookAt({-1.5, 1.4, 0.9}, {-3.1, 0.8, -2.3}, 50),
            {sun({0.45, -0.38, 0.8})});
    addView(scene, "tree", "the tree's twigs on the grass", lookAt({-1.0, 3.4, 1.6}, {-4.6, 0.7, -3.4}, 52),
            {sun({0.75, -0.55, 0.35})});
    addView(scene, "above", "from above, noon", lookAt({0.4, 8.5, 5.4}, {-0.4, 0, -0.6}, 50),
            {sun({0.35, -0.85, 0.3})});
    addView(scene, "light-in-front", "against the setting sun", lookAt({1.4, 1.2, 6.2}, {-0.4, 0.5, -0.6}, 50),
            {sun({0.1, -0.16, 0.98})});
    addView(scene, "grazing", "the sun four degrees above the ground", lookAt({3.4, 2.6, 6.0}, {0, 0.2, 0}, 48),
            {sun({-0.93, -0.07, 0.35})});
    addView(scene, "low-wall", "a hand above the ground, along the lawn at the fence",
            lookAt({2.3, 0.13, 3.3}, {1.5, 0.42, 0}, 50), {sun({0.42, -0.3, -0.85})});
    addView(scene, "light-in-frustum", "a lantern on the lawn, in the picture",
            lookAt({2.8, 1.7, 6.2}, {0, 0.8, 0}, 52), {lamp({0.1, 1.35, 1.5}, "lantern")});
    addView(scene, "light-at-eye", "a lamp worn on the head", lookAt({2.7, 1.7, 4.8}, {0.5, 0.5, -0.4}, 50),
            {spot({2.7, 1.7, 4.8}, {0.5, 0.5, -0.4}, 96, "head-lamp")});
    addView(scene, "headlights", "two spots from behind the fence", lookAt({1.6, 1.9, 6.4}, {0.2, 0.4, 0}, 50),
            {tinted(spot({-0.7, 0.9, -6.2}, {0.2, 0.3, 0}, 80, "left-headlight"), {0.65, 0.6, 0.5}),
             tinted(spot({0.7, 0.9, -6.2}, {0.6, 0.3, 0}, 80, "right-headlight"), {0.5, 0.55, 0.65})});
}

Scene build(std::span<const double> values)
{
    Scene scene = emptyScene("fence");
    addStatic(scene, "ground", box({-kHalf, -0.4, -kHalf}, {kHalf, 0, kHalf}, 5),
              addTextured(scene, plaster(0x8aa05e, 0.1)));
    addStatic(scene, "path", box({-0.62, -0.1, -7.5}, {0.62, 0.025, 7.5}, 1.24),
              addTextured(scene, tiles(0xc2b7a3, 0x8f8675, 2)));
    addPlane(scene, "floor", {0, 0, 0}, {0, 1, 0});
    addPlane(scene, "fence", {0, 0, 0.009}, {0, 0, 1});
    addFences(scene, int(values[1]));
    addGrass(scene, int(values[0]));
    addViews(scene);
    addPath(scene, LightKind::Directional, 2,
            {{{4.6, 2.3, 6.6}, {-0.9, 0.5, -1.0}, {-0.5, -0.26, 0.83}},
             {{2.6, 1.8, 6.4}, {-0.4, 0.4, -0.5}, {-0.25, -0.22, 0.92}},
             {{0.3, 1.5, 6.4}, {-0.9, 0.4, -0.6}, {0.05, -0.18, 0.95}},
             {{-2.2, 1.7, 7.0}, {-1.6, 0.4, -0.6}, {0.4, -0.2, 0.9}}});
    return scene;
}

constexpr BuiltinParameter kParameters[] = {{"tufts", 360, 0, 20000, "tufts of grass, of 40 blades each"},
                                            {"sections", 6, 0, 200, "three-metre sections of picket fence"}};

} // namespace

constinit const BuiltinScene kFence = {
    "fence", "fences, wires, a trellis, a tree and grass over ground under a low sun", kParameters, build};

} // namespace lixel::builtin
