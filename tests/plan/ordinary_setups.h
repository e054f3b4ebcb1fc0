// SPDX-License-Identifier: MIT
#pragma once

#include "plan/random_setups.h"

#include <algorithm>
#include <cmath>
#include <numbers>

// Ordinary set-ups: a floor of 20 to 400 metres with 1 to 60 boxes of up to 8 metres on it, a camera at eye level (1.2 to 2.2
// metres) within it that looks up or down by 20 degrees at most, and a light: the sun from 8 to 85 degrees above the horizon and from
// any side; a spot inside the scene, 2 to 12 metres up, a cone of 20 to 120 degrees towards a place on the floor before the camera;
// a lamp above all the boxes. Lamps amidst what they light need `cube`: no one perspective map holds more than half a sphere.
namespace lixel::test {

inline Light ordinaryLight(Rng& rng, Vec3d eye, Vec3d forward, double half, double highest)
{
    Light light;
    light.kind = LightKind(rng.integer(0, 2));
    const double around = rng.uniform(0, 2 * std::numbers::pi);
    if (light.kind == LightKind::Directional) {
        const double up = rng.uniform(8, 85) * std::numbers::pi / 180;
        light.directionWorld = -Vec3d{std::cos(up) * std::cos(around), std::sin(up), std::cos(up) * std::sin(around)};
        return light;
    }
    const double away = rng.uniform(0, 0.3 * half);
    light.positionWorld = {std::clamp(eye.x + away * std::cos(around), -half, half), rng.uniform(2, 12),
                           std::clamp(eye.z + away * std::sin(around), -half, half)};
    if (light.kind == LightKind::Point)
        light.positionWorld.y = highest + std::max(1.0, 0.05 * half) + rng.uniform(0, 10);
    const Vec3d ahead = eye + rng.uniform(2, 15) * normalized({forward.x, 0, forward.z});
    light.directionWorld = normalized(Vec3d{ahead.x, 0, ahead.z} - light.positionWorld);
    light.coneAngle = rng.uniform(20, 120) * std::numbers::pi / 180;
    return light;
}

inline RandomSetup ordinarySetup(Rng& rng)
{
    RandomSetup setup;
    const double half = rng.logUniform(10, 200);
    setup.radius = half;
    setup.boxesWorld.push_back({{-half, -0.2, -half}, {half, 0, half}});
    double highest = 0;
    for (int i = rng.integer(1, 60); i > 0; --i) {
        const Vec3d at{rng.uniform(-half, half), 0, rng.uniform(-half, half)};
        const Vec3d size{rng.uniform(0.3, 4), rng.uniform(0.3, 8), rng.uniform(0.3, 4)};
        setup.boxesWorld.push_back({at, at + size});
        highest = std::max(highest, size.y);
    }
    const Vec3d eye{rng.uniform(-0.9, 0.9) * half, rng.uniform(1.2, 2.2), rng.uniform(-0.9, 0.9) * half};
    const double yaw = rng.uniform(0, 2 * std::numbers::pi), pitch = rng.uniform(-20, 20) * std::numbers::pi / 180;
    const Vec3d forward{std::cos(pitch) * std::cos(yaw), std::sin(pitch), std::cos(pitch) * std::sin(yaw)};
    setup.view = perspectiveView(eye, eye + forward, {0, 1, 0}, rng.uniform(40, 75) * std::numbers::pi / 180,
                                 rng.logUniform(0.01, 0.3), rng.chance(0.5) ? INFINITY : 4 * half, 1024, 768);
    setup.light = ordinaryLight(rng, eye, forward, half, highest);
    setup.originWorld = {std::round(eye.x), std::round(eye.y), std::round(eye.z)};
    return setup;
}

} // namespace lixel::test
