// SPDX-License-Identifier: MIT
#include "lixel/scene/builtin/things.h"

#include "lixel/scene/builtin/dice.h"

#include <algorithm>
#include <numbers>

namespace lixel::builtin {

namespace {

constexpr double kPi = std::numbers::pi;

int stepsFor(int segments) { return std::max(2, segments / 8); }

Mesh turnedSmooth(std::initializer_list<Vec2d> points, int segments)
{
    return lathe(smoothProfile(std::span(points.begin(), points.size()), stepsFor(segments)), segments);
}

// Part of a ring in the plane x, y: handles.
Mesh handle(Vec2d centre, Vec2d radii, double fromDegrees, double toDegrees, double thickness, int segments)
{
    std::vector<Vec3d> path;
    for (int i = 0; i <= segments; ++i) {
        const double a = (fromDegrees + (toDegrees - fromDegrees) * i / segments) * kPi / 180;
        path.push_back({centre.x + radii.x * std::cos(a), centre.y + radii.y * std::sin(a), 0});
    }
    return tube(path, thickness, thickness, std::max(8, segments / 2));
}

} // namespace

Mesh teapot(int segments)
{
    Mesh mesh = turnedSmooth({{0, 0},
                              {0.06, 0},
                              {0.06, 0},
                              {0.095, 0.04},
                              {0.105, 0.07},
                              {0.09, 0.105},
                              {0.062, 0.122},
                              {0.062, 0.122},
                              {0.03, 0.134},
                              {0.01, 0.138},
                              {0.014, 0.15},
                              {0.01, 0.158},
                              {0, 0.16}},
                             segments);
    std::vector<Vec3d> spout;
    for (int i = 0; i <= segments / 2; ++i) {
        const double t = 2.0 * i / segments;
        spout.push_back({0.08 + 0.09 * t, 0.045 + 0.075 * t * t * (1.7 - 0.7 * t), 0});
    }
    append(mesh, tube(spout, 0.022, 0.009, std::max(8, segments / 2)));
    append(mesh, handle({-0.09, 0.072}, {0.055, 0.042}, 62, 298, 0.0075, segments / 2));
    return mesh;
}

Mesh mug(int segments)
{
    Mesh mesh = turnedSmooth({{0, 0},
                              {0.036, 0},
                              {0.036, 0},
                              {0.04, 0.01},
                              {0.04, 0.05},
                              {0.041, 0.097},
                              {0.039, 0.1},
                              {0.037, 0.097},
                              {0.036, 0.05},
                              {0.035, 0.012},
                              {0.03, 0.008},
                              {0, 0.008}},
                             segments);
    append(mesh, handle({0.042, 0.05}, {0.026, 0.03}, -78, 78, 0.005, segments / 2));
    return mesh;
}

Mesh bowl(int segments)
{
    return turnedSmooth({{0, 0},
                         {0.045, 0},
                         {0.045, 0},
                         {0.05, 0.012},
                         {0.09, 0.04},
                         {0.118, 0.086},
                         {0.116, 0.09},
                         {0.113, 0.086},
                         {0.085, 0.044},
                         {0.045, 0.02},
                         {0, 0.016}},
                        segments);
}

Mesh plate(int segments)
{
    return turnedSmooth({{0, 0},
                         {0.07, 0},
                         {0.07, 0},
                         {0.085, 0.008},
                         {0.128, 0.019},
                         {0.13, 0.022},
                         {0.126, 0.023},
                         {0.085, 0.012},
                         {0.07, 0.006},
                         {0, 0.006}},
                        segments);
}

Mesh vase(int segments)
{
    return turnedSmooth({{0, 0},
                         {0.045, 0},
                         {0.045, 0},
                         {0.07, 0.05},
                         {0.085, 0.11},
                         {0.06, 0.2},
                         {0.032, 0.25},
                         {0.048, 0.297},
                         {0.046, 0.3},
                         {0.043, 0.297},
                         {0.028, 0.25},
                         {0.055, 0.2},
                         {0.078, 0.11},
                         {0.06, 0.05},
                         {0, 0.02}},
                        segments);
}

Mesh candlestick(int segments)
{
    Mesh mesh = turnedSmooth({{0, 0},
                              {0.06, 0},
                              {0.06, 0.006},
                              {0.03, 0.016},
                              {0.012, 0.03},
                              {0.016, 0.07},
                              {0.008, 0.1},
                              {0.014, 0.13},
                              {0.03, 0.145},
                              {0.032, 0.15},
                              {0.028, 0.152},
                              {0, 0.152}},
                             segments);
    append(mesh, cylinder(0.011, 0.168, segments), at({0, 0.151, 0}));
    append(mesh, rod({0, 0.315, 0}, {0.001, 0.33, 0}, 0.001, 6));
    return mesh;
}

Mesh goblet(int segments)
{
    return turnedSmooth({{0, 0},
                         {0.036, 0},
                         {0.036, 0.003},
                         {0.008, 0.012},
                         {0.0055, 0.05},
                         {0.006, 0.09},
                         {0.03, 0.115},
                         {0.04, 0.15},
                         {0.036, 0.198},
                         {0.035, 0.2},
                         {0.0342, 0.198},
                         {0.0382, 0.15},
                         {0.028, 0.117},
                         {0, 0.102}},
                        segments);
}

Mesh apple(int segments)
{
    Mesh mesh = turnedSmooth({{0, 0.008},
                              {0.012, 0.003},
                              {0.022, 0.002},
                              {0.036, 0.022},
                              {0.041, 0.045},
                              {0.034, 0.068},
                              {0.018, 0.075},
                              {0.006, 0.07},
                              {0, 0.064}},
                             segments);
    append(mesh, rod({0, 0.06, 0}, {0.006, 0.086, 0.002}, 0.0013, 6));
    return mesh;
}

Mesh pear(int segments)
{
    Mesh mesh = turnedSmooth({{0, 0.004},
                              {0.014, 0},
                              {0.034, 0.016},
                              {0.038, 0.036},
                              {0.028, 0.062},
                              {0.017, 0.084},
                              {0.012, 0.1},
                              {0, 0.106}},
                             segments);
    append(mesh, rod({0, 0.1, 0}, {0.005, 0.125, 0}, 0.0014, 6));
    return mesh;
}

Mesh basket(int ribs)
{
    Mesh mesh;
    append(mesh, cylinder(0.085, 0.006, 2 * ribs));
    const auto radius = [](double y) { return 0.08 + 0.35 * y; };
    for (int i = 0; i < ribs; ++i)
        append(mesh, rod({radius(0.003), 0.003, 0}, {radius(0.12), 0.12, 0}, 0.0025, 6), turnedY(360.0 * i / ribs));
    for (int k = 1; k <= 4; ++k)
        append(mesh, torus(radius(0.03 * k), k == 4 ? 0.005 : 0.003, 2 * ribs, 8), at({0, 0.03 * k, 0}));
    return mesh;
}

Mesh spring(int turns, double radius, double height, double wire, int segmentsPerTurn, int sides)
{
    std::vector<Vec3d> path;
    const int n = turns * segmentsPerTurn;
    for (int i = 0; i <= n; ++i) {
        const double a = 2 * kPi * i / segmentsPerTurn;
        path.push_back({radius * std::cos(a), wire + (height - 2 * wire) * i / n, -radius * std::sin(a)});
    }
    return tube(path, wire, wire, sides);
}

Mesh gear(int teeth, double radius, double thickness)
{
    std::vector<Vec2d> outline;
    for (int i = 0; i < teeth; ++i)
        for (const auto& [share, r] : {std::pair{0.0, 0.86}, {0.12, 1.0}, {0.4, 1.0}, {0.52, 0.86}, {0.76, 0.86}}) {
            const double a = 2 * kPi * (i + share) / teeth;
            outline.push_back({r * radius * std::cos(a), r * radius * std::sin(a)});
        }
    Mesh mesh;
    append(mesh, prism(outline, thickness), at({0, 0.5 * thickness, 0}) * turned({1, 0, 0}, -90));
    return mesh;
}

Mesh bookStack(int books, std::uint64_t seed)
{
    Dice dice(seed);
    Mesh mesh;
    double y = 0;
    for (int i = 0; i < books; ++i) {
        const double thickness = dice.uniform(0.022, 0.045), w = dice.uniform(0.13, 0.17), d = dice.uniform(0.19, 0.24);
        append(mesh, boxAround({0, y + 0.5 * thickness, 0}, {w, thickness, d}),
               at({dice.uniform(-0.008, 0.008), 0, dice.uniform(-0.008, 0.008)}) * turnedY(dice.uniform(-14, 14)));
        y += thickness - 0.0003;
    }
    return mesh;
}

Mesh chair()
{
    Mesh mesh;
    append(mesh, softBox({0.42, 0.04, 0.42}, 8, 48), at({0, 0.43, 0}));
    for (double x : {-0.17, 0.17}) {
        append(mesh, rod({1.1 * x, 0, 0.19}, {x, 0.45, 0.16}, 0.016, 12));
        append(mesh, rod({1.1 * x, 0, -0.19}, {x, 0.45, -0.17}, 0.016, 12));
        append(mesh, rod({x, 0.4501, -0.18}, {1.08 * x, 0.9, -0.24}, 0.014, 12));
    }
    for (double y : {0.6, 0.72, 0.84})
        append(mesh, rod({-0.18, y, -0.18 - 0.133 * (y - 0.45)}, {0.18, y, -0.18 - 0.133 * (y - 0.45)}, 0.012, 12));
    append(mesh, rod({-0.178, 0.2, 0.17}, {0.178, 0.2, 0.17}, 0.01, 12));
    append(mesh, rod({-0.178, 0.2, -0.18}, {0.178, 0.2, -0.18}, 0.01, 12));
    return mesh;
}

Mesh tableFrame(double width, double depth, double height)
{
    const double x = 0.5 * width - 0.09, z = 0.5 * depth - 0.09, under = height - 0.035;
    Mesh mesh;
    append(mesh, boxAround({0, height - 0.0175, 0}, {width, 0.035, depth}));
    for (double sx : {-x, x})
        for (double sz : {-z, z})
            append(mesh,
                   turnedSmooth({{0, 0},
                                 {0.02, 0},
                                 {0.02, 0},
                                 {0.024, 0.12},
                                 {0.018, 0.2},
                                 {0.03, 0.36},
                                 {0.032, under + 0.01},
                                 {0.032, under + 0.01},
                                 {0, under + 0.01}},
                                40),
                   at({sx, 0, sz}));
    for (double sz : {-z, z}) append(mesh, boxAround({0, under - 0.04, sz}, {2 * x, 0.09, 0.02}));
    for (double sx : {-x, x}) append(mesh, boxAround({sx, under - 0.041, 0}, {0.02, 0.09, 2 * z}));
    return mesh;
}

} // namespace lixel::builtin
