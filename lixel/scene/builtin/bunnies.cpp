// SPDX-License-Identifier: MIT
#include "lixel/scene/builtin/assemble.h"
#include "lixel/scene/builtin/scenes.h"
#include "lixel/scene/builtin/shapes.h"
#include "lixel/scene/builtin/textures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

// Bunnies and a ball bounce on a floor in front of a wall. The stage keeps its size; more bunnies are smaller ones.
namespace lixel::builtin {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kGravity = 9.81;          // m/s^2
constexpr double kPeriodSeconds = 4;       // after which everything repeats
constexpr double kHalfWidth = 6;           // of the floor, metres
constexpr double kFront = 4.6, kBack = -3; // z of the floor's front edge and of the wall
constexpr double kWallHeight = 4.2;
constexpr double kSink = 0.001; // how deep what stands or lands dips into the floor, metres
constexpr double kGoldenAngle = 2.399963229728653;
constexpr std::array<std::uint32_t, 8> kFur = {0xd9694f, 0xe3b23c, 0x6a9f58, 0x4c8fb5,
                                               0xb98cc4, 0xe8d8c0, 0x8c5a3c, 0x5fb3a5};

// One thing that jumps: a whole number of jumps in a period, so that height and duration agree with gravity.
struct Jumper
{
    int node = 0;
    Vec3d standing;
    double turnDegrees = 0, scale = 1;
    int jumps = 4;
    double phase = 0;
};

double heightAt(const Jumper& jumper, double time)
{
    const double duration = kPeriodSeconds / jumper.jumps;
    const double s = time / duration + jumper.phase, t = (s - std::floor(s)) * duration;
    return 0.5 * kGravity * t * (duration - t);
}

void move(Scene& scene, const std::vector<Jumper>& jumpers, double time)
{
    for (const Jumper& j : jumpers) {
        const double sway = 20 * std::sin(2 * kPi * (time / kPeriodSeconds + j.phase));
        const Vec3d position = j.standing + Vec3d{0, heightAt(j, time) - kSink, 0};
        scene.nodes[std::size_t(j.node)].parentFromNode =
            transformOf({position, j.turnDegrees + sway, {j.scale, j.scale, j.scale}});
    }
}

void addStage(Scene& scene)
{
    const int floor = addTextured(scene, tiles(0xcfc6b8, 0x9c9488, 4));
    const int wall = addTextured(scene, plaster(0xc7d0d6, 0.05));
    addStatic(scene, "floor", box({-kHalfWidth, -0.2, kBack - 0.1}, {kHalfWidth, 0, kFront}, 3), floor);
    addStatic(scene, "wall", box({-kHalfWidth - 0.05, -0.15, kBack - 0.25}, {kHalfWidth + 0.05, kWallHeight, kBack}, 3),
              wall);
    addPlane(scene, "floor", {0, 0, 0}, {0, 1, 0});
    addPlane(scene, "wall", {0, 0, kBack}, {0, 0, 1});
}

// Evenly over an ellipse, as a sunflower sets its seeds; the ball has the middle. Few stand closer to it.
std::vector<Jumper> addJumpers(Scene& scene, int count)
{
    const double size = std::min(1.0, std::sqrt(8.0 / count));
    const double reach = std::clamp(std::sqrt(count / 8.0), 0.75, 1.0);
    std::vector<int> bunnies;
    const Mesh shape = bunny();
    for (int i = 0; i < std::min(count, int(kFur.size())); ++i)
        bunnies.push_back(addMesh(scene, shape, addMaterial(scene, kFur[std::size_t(i)])));

    std::vector<Jumper> jumpers;
    for (int i = 0; i < count; ++i) {
        const double r = std::sqrt((i + 1.0) / (count + 0.5)), a = kGoldenAngle * i + 0.5;
        Jumper j;
        j.standing = {3.5 * reach * r * std::cos(a), 0, 0.3 + 2.35 * reach * r * std::sin(a)};
        j.turnDegrees = 137.5 * i + 200;
        j.scale = size;
        j.jumps = 4 + i % 3;
        j.phase = std::fmod(0.618034 * i, 1.0);
        j.node = addNode(scene, "bunny " + std::to_string(i + 1), {bunnies[std::size_t(i) % bunnies.size()]});
        jumpers.push_back(j);
    }
    Mesh ball;
    append(ball, sphere(0.45, 64), at({0, 0.45, 0}));
    Jumper j;
    j.node = addNode(scene, "ball", {addMesh(scene, ball, addTextured(scene, stripes(0xf2efe6, 0xc8443a, 3)))});
    j.standing = {0, 0, 0.3};
    j.phase = 0.2;
    j.scale = size;
    jumpers.push_back(j);
    return jumpers;
}

void addViews(Scene& scene)
{
    const Light morning = sun({-0.55, -0.75, -0.45});
    addView(scene, "overview", "the whole stage, sun over the right shoulder",
            lookAt({2.9, 2.6, 6.2}, {0.1, 0.95, -0.6}, 46), {morning});
    addView(scene, "front", "straight at the wall, sun high from the left", lookAt({0, 1.9, 6.6}, {0, 1.1, -0.4}, 44),
            {sun({0.5, -0.9, -0.55})});
    addView(scene, "left", "from the left along the wall, noon", lookAt({-5.8, 2.5, 3.6}, {0.2, 0.6, -0.8}, 44),
            {sun({0.25, -0.95, -0.3})});
    addView(scene, "above", "looking down on the floor, afternoon", lookAt({0.5, 7.2, 3.8}, {0, 0, 0.2}, 48),
            {sun({0.7, -0.7, -0.3})});
    addView(scene, "close-up", "among the bunnies, near the floor tiles",
            lookAt({0.2, 0.8, 3.3}, {0.95, 0.55, -0.6}, 50), {morning});
    addView(scene, "distant-lamp", "a point light 18 metres away", lookAt({-2.8, 2.4, 6.0}, {0.1, 0.9, -0.6}, 46),
            {lamp({8, 12, 11}, "distant-lamp")});
    addView(scene, "stage-spot", "one spot from the upper left on the middle of the stage",
            lookAt({2.0, 2.4, 6.2}, {0, 0.9, -0.6}, 46), {spot({-3.6, 5.6, 4.6}, {0.2, 0.3, -0.4}, 58)});
    addView(scene, "light-in-front", "the sun low in front of the camera, shadows run towards it",
            lookAt({-6.2, 2.1, 1.7}, {0.5, 0.5, 0.1}, 44), {sun({-0.9, -0.42, 0.12})});
    addView(scene, "grazing", "the sun seven degrees above the floor", lookAt({1.8, 2.9, 6.2}, {0, 0.5, -0.5}, 44),
            {sun({-0.97, -0.12, -0.25})});
    addView(scene, "low-wall", "the camera a hand above the floor, looking at the wall",
            lookAt({1.5, 0.14, 3.6}, {0.9, 0.75, -3}, 52), {sun({0.45, -0.6, -0.66})});
    addView(scene, "light-in-frustum", "a lamp that hangs in the picture above the bunnies",
            lookAt({-1.4, 2.6, 7.8}, {0.1, 1.7, -0.4}, 50), {lamp({0.6, 4.5, 1.2}, "hanging-lamp")});
    addView(scene, "light-at-eye", "a lamp worn on the head", lookAt({2.6, 2.0, 5.7}, {0, 0.8, -0.6}, 46),
            {spot({2.6, 2.0, 5.7}, {0, 0.8, -0.6}, 90, "head-lamp")});
    addView(scene, "three-lights", "sun, spot and distant lamp together", lookAt({0.6, 2.4, 6.6}, {0, 0.9, -0.6}, 46),
            {tinted(sun({-0.55, -0.75, -0.45}), {0.5, 0.47, 0.4}),
             tinted(spot({4.4, 5.2, 5.0}, {0, 0.4, -0.6}, 56), {0.45, 0.3, 0.2}),
             tinted(lamp({-8, 9, 11}, "distant-lamp"), {0.2, 0.28, 0.4})});
}

Scene build(std::span<const double> values)
{
    Scene scene = emptyScene("bunnies");
    addStage(scene);
    const std::vector<Jumper> jumpers = addJumpers(scene, int(values[0]));
    scene.animate = [jumpers](Scene& moved, double time) { move(moved, jumpers, time); };
    scene.animate(scene, 0);
    addViews(scene);
    addPath(scene, LightKind::Directional, 1,
            {{{3.0, 2.7, 6.6}, {0.1, 0.85, -0.6}, {-0.55, -0.75, -0.45}},
             {{0, 2.2, 7.2}, {0, 0.9, -0.4}, {-0.1, -0.85, -0.5}},
             {{-3.2, 1.9, 6.0}, {0, 0.8, -0.4}, {0.4, -0.7, -0.4}},
             {{-5.6, 2.4, 3.6}, {0.2, 0.7, -0.5}, {0.7, -0.45, -0.2}},
             {{-3.2, 3.4, 6.0}, {0, 0.6, -0.4}, {0.3, -0.8, -0.4}}});
    return scene;
}

constexpr BuiltinParameter kParameters[] = {{"count", 3, 1, 1000, "bunnies"}};

} // namespace

constinit const BuiltinScene kBunnies = {
    "bunnies", "bunnies and a ball bounce on a floor in front of a wall (animated)", kParameters, build};

} // namespace lixel::builtin
