// SPDX-License-Identifier: MIT
#include "lixel/scene/builtin/assemble.h"
#include "lixel/scene/builtin/dice.h"
#include "lixel/scene/builtin/scenes.h"
#include "lixel/scene/builtin/textures.h"
#include "lixel/scene/builtin/things.h"

#include <algorithm>
#include <cmath>

// A few dozen finely tessellated objects on and a little above a floor, in front of a low wall.
namespace lixel::builtin {

namespace {

constexpr double kHalf = 8.5;   // of the floor, metres
constexpr double kWall = -7.2;  // z of the wall
constexpr double kSink = 0.001; // of an object's size, into what it stands on
constexpr double kGoldenAngle = 2.399963229728653;

// A mesh about one metre high that stands on the origin, or floats this high above the floor.
struct Kind
{
    int mesh = 0;
    double above = 0;
};

Mesh scaledUp(const Mesh& mesh, double factor)
{
    Mesh larger;
    append(larger, mesh, scaling({factor, factor, factor}));
    return larger;
}

Mesh standing(const Mesh& mesh)
{
    float lowest = mesh.position.front().y;
    for (const Vec3f& p : mesh.position) lowest = std::min(lowest, p.y);
    Mesh lifted;
    append(lifted, mesh, at({0, -double(lowest), 0}));
    return lifted;
}

Mesh pileOfRings()
{
    Mesh mesh;
    double y = 0;
    for (double ring : {0.46, 0.38, 0.3, 0.22}) {
        append(mesh, torus(ring, 0.115, 96, 32), at({0, y + 0.115, 0}));
        y += 0.225;
    }
    return mesh;
}

Mesh chain()
{
    Mesh mesh;
    for (int i = 0; i < 4; ++i)
        append(mesh, torus(0.2, 0.05, 96, 32),
               at({0, 0.25 + 0.27 * i, 0}) * turnedY(90 * i + 10) * turned({1, 0, 0}, 90));
    return mesh;
}

Mesh clockwork()
{
    Mesh mesh = cylinder(0.06, 0.9, 96);
    append(mesh, gear(36, 0.5, 0.12), at({0, 0.04, 0}));
    append(mesh, gear(24, 0.36, 0.12), at({0, 0.3, 0}) * turnedY(4));
    append(mesh, gear(18, 0.26, 0.12), at({0, 0.56, 0}) * turnedY(9));
    for (int i = 0; i < 14; ++i) append(mesh, sphere(0.045, 40), turnedY(360.0 * i / 14) * at({0.4, 0.195, 0}));
    return mesh;
}

Mesh softPile()
{
    Mesh mesh = softBox({0.9, 0.36, 0.9}, 5, 112);
    append(mesh, softBox({0.68, 0.32, 0.68}, 6, 80), at({0.02, 0.357, 0}) * turnedY(24));
    append(mesh, softBox({0.46, 0.28, 0.46}, 4, 72), at({-0.02, 0.674, 0.02}) * turnedY(51));
    return mesh;
}

std::vector<Kind> addKinds(Scene& scene)
{
    const auto add = [&](const Mesh& mesh, int material, double above = 0) {
        return Kind{addMesh(scene, mesh, material), above};
    };
    return {add(standing(torusKnot(2, 3, 0.4, 0.12, 640, 24)), addMaterial(scene, 0xd9694f)),
            add(bunny(), addMaterial(scene, 0xe8d8c0)),
            add(scaledUp(teapot(96), 6), addMaterial(scene, 0x2f6f9f)),
            add(standing(sphere(0.5, 144)), addTextured(scene, checker(0xf2efe6, 0x3a3f47, 8))),
            add(spring(6, 0.34, 1.1, 0.055, 96, 24), addMaterial(scene, 0xc9a24a)),
            add(pileOfRings(), addTextured(scene, stripes(0x5fb3a5, 0xe9e4da, 12))),
            add(standing(torusKnot(3, 5, 0.38, 0.075, 768, 20)), addMaterial(scene, 0x6a9f58), 0.35),
            add(scaledUp(vase(88), 3.8), addMaterial(scene, 0x7a5aa0)),
            add(clockwork(), addMaterial(scene, 0x9aa3ab)),
            add(chain(), addMaterial(scene, 0xb4533c), 0.02),
            add(softPile(), addMaterial(scene, 0xe3b23c)),
            add(scaledUp(basket(72), 5), addMaterial(scene, 0x9a6a3a))};
}

void addObjects(Scene& scene, int count)
{
    const std::vector<Kind> kinds = addKinds(scene);
    Dice dice(3);
    const double crowd = std::min(1.0, std::sqrt(48.0 / count));
    for (int i = 0; i < count; ++i) {
        const Kind& kind = kinds[std::size_t(i) % kinds.size()];
        const double r = std::sqrt((i + 0.6) / count), a = kGoldenAngle * i;
        const double size = crowd * dice.uniform(0.8, 1.15);
        const Vec3d position{7.3 * r * std::cos(a), kind.above * size - (kind.above > 0 ? 0 : kSink * size),
                             0.3 + 6.4 * r * std::sin(a)};
        addNode(scene, "object " + std::to_string(i + 1), {kind.mesh},
                {position, dice.uniform(0, 360), {size, size, size}});
    }
}

void addViews(Scene& scene)
{
    const Light day = sun({-0.5, -0.75, -0.42});
    addView(scene, "overview", "all objects from above the front corner",
            lookAt({7.4, 6.0, 10.4}, {0.3, 0.1, -0.2}, 44), {day});
    addView(scene, "front", "from the front edge, sun from the left", lookAt({-0.5, 2.6, 10.2}, {0, 0.5, 0}, 46),
            {sun({0.62, -0.65, -0.42})});
    addView(scene, "among", "standing between the objects", lookAt({2.6, 1.5, 5.4}, {-0.6, 0.4, 0}, 50),
            {sun({0.55, -0.6, -0.55})});
    addView(scene, "above", "straight down but for a little", lookAt({0, 15, 2.5}, {0, 0, 0.1}, 54),
            {sun({0.6, -0.7, 0.35})});
    addView(scene, "distant-lamp", "a point light 25 metres away", lookAt({-5.6, 3.6, 8.6}, {0, 0.4, 0}, 48),
            {lamp({15, 15, 12}, "distant-lamp")});
    addView(scene, "spot", "one spot over the middle", lookAt({4.8, 4.4, 8.6}, {0, 0.3, 0}, 48),
            {spot({-3.5, 8.5, 3.5}, {0, 0, 0}, 62)});
    addView(scene, "light-in-front", "the sun low in front, long shadows come forward",
            lookAt({-9.2, 2.5, 2.0}, {0.5, 0.3, -0.3}, 46), {sun({-0.92, -0.36, -0.1})});
    addView(scene, "grazing", "the sun six degrees above the floor", lookAt({3.2, 4.2, 9.4}, {0, 0.2, 0}, 48),
            {sun({0.97, -0.105, -0.22})});
    addView(scene, "low-wall", "the camera a hand above the floor, looking at the wall",
            lookAt({-0.5, 0.15, 6.9}, {0.6, 0.8, -7.2}, 50), {sun({-0.45, -0.55, -0.7})});
    addView(scene, "light-in-frustum", "a lamp over the middle of the floor, in the picture",
            lookAt({1.5, 3.4, 11.0}, {0, 1.3, 0}, 50), {lamp({0.4, 4.0, 0.6}, "hanging-lamp")});
    addView(scene, "light-at-eye", "a lamp worn on the head", lookAt({5.6, 2.8, 7.2}, {0, 0.4, 0}, 48),
            {spot({5.6, 2.8, 7.2}, {0, 0.4, 0}, 92, "head-lamp")});
    addView(scene, "two-lights", "sun and spot together", lookAt({-4.6, 3.8, 8.2}, {0, 0.3, 0}, 48),
            {tinted(sun({0.55, -0.7, -0.45}), {0.62, 0.6, 0.52}),
             tinted(spot({5.5, 7.5, 3.5}, {0, 0, 0}, 66), {0.4, 0.28, 0.2})});
}

Scene build(std::span<const double> values)
{
    Scene scene = emptyScene("objects");
    addStatic(scene, "floor", box({-kHalf, -0.3, kWall}, {kHalf, 0, kHalf}, 4),
              addTextured(scene, tiles(0xb9b4aa, 0x8d887f, 4)));
    addStatic(scene, "wall", box({-kHalf, -0.29, kWall - 0.3}, {kHalf, 2.4, kWall + 0.001}, 2),
              addTextured(scene, bricks(0xa8644c, 0xc9bfb0, 12)));
    addPlane(scene, "floor", {0, 0, 0}, {0, 1, 0});
    addPlane(scene, "wall", {0, 0, kWall + 0.001}, {0, 0, 1});
    addObjects(scene, int(values[0]));
    addViews(scene);
    addPath(scene, LightKind::Directional, 2,
            {{{7.4, 6.0, 10.4}, {0.3, 0.1, -0.2}, {-0.5, -0.75, -0.42}},
             {{3.0, 4.0, 9.6}, {0, 0.3, 0}, {-0.2, -0.7, -0.6}},
             {{-1.5, 2.2, 7.2}, {0, 0.4, 0}, {0.3, -0.6, -0.6}},
             {{-6.0, 2.6, 5.0}, {0, 0.4, -0.2}, {0.6, -0.45, -0.4}},
             {{-9.0, 4.2, 1.0}, {0, 0.2, 0}, {0.7, -0.3, -0.1}}});
    return scene;
}

constexpr BuiltinParameter kParameters[] = {{"count", 48, 1, 2000, "objects"}};

} // namespace

constinit const BuiltinScene kObjects = {
    "objects", "a few dozen finely tessellated objects on a floor, over a million triangles", kParameters, build};

} // namespace lixel::builtin
