// SPDX-License-Identifier: MIT
#include "lixel/scene/builtin/assemble.h"
#include "lixel/scene/builtin/dice.h"
#include "lixel/scene/builtin/scenes.h"
#include "lixel/scene/builtin/textures.h"

#include "lixel/scene/builtin/shapes.h"

#include <algorithm>
#include <cmath>
#include <string>

// Balls on a floor, the same picture with any number of triangles but for how round they are: what grows with triangles alone
// is seen here.
namespace lixel::builtin {

namespace {

constexpr int kCount = 40;
constexpr double kHalf = 6; // of the floor, metres
constexpr double kGoldenAngle = 2.399963229728653;
constexpr double kSink = 0.001; // of a ball's size, into the floor

// About as many triangles as asked for: a ball of n segments has n * (n - 2), n being even.
int segmentsFor(double triangles)
{
    const double ofOne = (triangles - 12) / kCount;
    const int half = int(std::lround((1 + std::sqrt(1 + std::max(ofOne, 0.0))) / 2));
    return 2 * std::max(half, 2);
}

void addBalls(Scene& scene, int segments)
{
    const int meshes[] = {addMesh(scene, sphere(0.5, segments), addMaterial(scene, 0xd9694f)),
                          addMesh(scene, sphere(0.5, segments), addMaterial(scene, 0x2f6f9f)),
                          addMesh(scene, sphere(0.5, segments), addMaterial(scene, 0xe3b23c)),
                          addMesh(scene, sphere(0.5, segments), addTextured(scene, checker(0xf2efe6, 0x3a3f47, 8)))};
    Dice dice(11);
    for (int i = 0; i < kCount; ++i) {
        const double r = 5.2 * std::sqrt((i + 0.6) / kCount), a = kGoldenAngle * i, size = dice.uniform(0.55, 1.1);
        const double height = dice.chance(0.25) ? dice.uniform(0.8, 2) : (0.5 - kSink) * size;
        addNode(scene, "ball " + std::to_string(i + 1), {meshes[i % 4]},
                {{r * std::cos(a), height, r * std::sin(a)}, dice.uniform(0, 360), {size, size, size}});
    }
}

void addViews(Scene& scene)
{
    const Light day = sun({-0.5, -0.75, -0.42});
    addView(scene, "overview", "all balls from above the front corner", lookAt({5.4, 4.6, 8.2}, {0, 0.1, 0}, 46),
            {day});
    addView(scene, "front", "from the front edge, sun from the left", lookAt({-0.4, 2.1, 8}, {0, 0.4, 0}, 48),
            {sun({0.62, -0.65, -0.42})});
    addView(scene, "above", "straight down but for a little", lookAt({0, 11, 1.8}, {0, 0, 0.1}, 56),
            {sun({0.6, -0.7, 0.35})});
    addView(scene, "distant-lamp", "a point light 20 metres away", lookAt({-4.4, 3, 6.8}, {0, 0.3, 0}, 48),
            {lamp({12, 12, 10}, "distant-lamp")});
    addView(scene, "spot", "one spot over the middle", lookAt({3.8, 3.6, 7}, {0, 0.3, 0}, 48),
            {spot({-2.6, 7, 2.6}, {0, 0, 0}, 66)});
    addView(scene, "light-in-front", "the sun low in front, long shadows come forward",
            lookAt({-7.2, 3.8, 1.6}, {0.3, 0, -0.3}, 46), {sun({-0.92, -0.36, -0.1})});
    addView(scene, "grazing", "the sun six degrees above the floor", lookAt({2.6, 3.6, 7.6}, {0, 0.2, 0}, 48),
            {sun({0.97, -0.105, -0.22})});
    addView(scene, "light-at-eye", "a lamp worn on the head", lookAt({4.6, 2.6, 6}, {0, 0.4, 0}, 48),
            {spot({4.6, 2.6, 6}, {0, 0.4, 0}, 92, "head-lamp")});
    addView(scene, "two-lights", "sun and spot together", lookAt({-3.8, 3.2, 6.6}, {0, 0.3, 0}, 48),
            {tinted(sun({0.55, -0.7, -0.45}), {0.62, 0.6, 0.52}),
             tinted(spot({4.4, 6, 2.8}, {0, 0, 0}, 66), {0.4, 0.28, 0.2})});
}

Scene build(std::span<const double> values)
{
    Scene scene = emptyScene("balls");
    addStatic(scene, "floor", box({-kHalf, -0.3, -kHalf}, {kHalf, 0, kHalf}, 3),
              addTextured(scene, tiles(0xb9b4aa, 0x8d887f, 4)));
    addPlane(scene, "floor", {0, 0, 0}, {0, 1, 0});
    addBalls(scene, segmentsFor(values[0]));
    addViews(scene);
    addPath(scene, LightKind::Directional, 2,
            {{{5.4, 4.6, 8.2}, {0, 0.1, 0}, {-0.5, -0.75, -0.42}},
             {{2.4, 3.2, 8.4}, {0, 0.3, 0}, {-0.2, -0.7, -0.6}},
             {{-1.2, 2.4, 8}, {0, 0.4, 0}, {0.3, -0.6, -0.6}},
             {{-5, 3, 6.4}, {0, 0.4, -0.2}, {0.6, -0.45, -0.4}}});
    return scene;
}

constexpr BuiltinParameter kParameters[] = {
    {"triangles", 100'000, 500, 20'000'000, "triangles of all balls together, about"}};

} // namespace

constinit const BuiltinScene kBalls = {"balls", "forty balls on a floor, of a thousand triangles or of ten million",
                                       kParameters, build};

} // namespace lixel::builtin
