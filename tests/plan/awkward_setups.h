// SPDX-License-Identifier: MIT
#pragma once

#include "plan/host_cameras.h"
#include "plan/random_setups.h"

#include <cmath>

// Set-ups that random numbers never meet: scenes of one box, flat, thin as a line or a single point, at round coordinates; any
// projective camera, along the axes too; lights along and across the line of sight, at the eye, in, at the corner of or in the plane of
// a box, and a million scenes away.
namespace lixel::test {

inline Box awkwardBox(Rng& rng, Vec3d centre, double radius, bool isOnlyOne)
{
    const auto side = [&] {
        if (rng.chance(0.25)) return 0.0;
        return radius * (rng.chance(0.5) ? 0.25 * rng.integer(1, 4) : rng.uniform(0, 1));
    };
    const auto step = [&] { return 0.25 * radius * rng.integer(-2, 2); };
    Vec3d middle = centre;
    if (!isOnlyOne) middle = centre + (rng.chance(0.5) ? Vec3d{step(), step(), step()} : radius * rng.inBox(0.5));
    const Vec3d half = 0.5 * Vec3d{side(), side(), side()};
    return {middle - half, middle + half};
}

inline Camera awkwardCamera(Rng& rng, Vec3d centre, double radius)
{
    constexpr Vec3d kAxes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    Camera camera = anyCamera(rng, kLenses[rng.integer(0, 4)], rng.chance(0.4), centre, radius);
    if (rng.chance(0.3)) {
        const int axis = rng.integer(0, 5);
        camera.eyeWorld = centre - rng.integer(1, 3) * radius * kAxes[axis];
        camera.rotation = eyeFromWorldRotation(kAxes[axis], kAxes[(axis + 2) % 6]);
    }
    if (rng.chance(0.1)) {
        camera.near = 1e-3 * radius;
        camera.obliqueAt = 2 * camera.near;
    }
    return camera;
}

inline Light awkwardLight(Rng& rng, const Camera& camera, const Box& box, Vec3d centre, double radius)
{
    const Vec3d eye = camera.eyeWorld, right = xyz(camera.rotation.row(0)), forward = -xyz(camera.rotation.row(2));
    const Vec3d directions[] = {{0, -1, 0},
                                {1, 0, 0},
                                {0, 0, -1},
                                forward,
                                -forward,
                                right,
                                normalized(right + 1e-9 * forward),
                                rng.onSphere(),
                                normalized(Vec3d{1, 1, 1}),
                                normalized(Vec3d{1, 0, 1})};
    Light light;
    light.kind = LightKind(rng.integer(0, 2));
    light.directionWorld = directions[rng.integer(0, 9)];
    const Vec3d positions[] = {eye,
                               eye + 1e-7 * radius * rng.onSphere(),
                               eye + 0.5 * radius * right,
                               eye + radius * forward,
                               eye - radius * forward,
                               box.centre(),
                               box.corners()[std::size_t(rng.integer(0, 7))],
                               box.max + Vec3d{0, radius, 0},
                               {box.max.x + radius, box.max.y, box.centre().z},
                               box.centre() - radius * light.directionWorld,
                               centre + radius * rng.onSphere(),
                               centre - 1e6 * radius * light.directionWorld};
    light.positionWorld = positions[rng.integer(0, 11)];
    light.coneAngle = rng.uniform(0.05, 3.1);
    if (rng.chance(0.2)) light.range = radius * rng.uniform(0.5, 3);
    return light;
}

inline RandomSetup awkwardSetup(Rng& rng)
{
    RandomSetup setup;
    const auto whole = [&] { return double(rng.integer(-3, 3)); };
    const bool isFar = rng.chance(0.2);
    const Vec3d centre = isFar ? 1e5 * rng.onSphere() : Vec3d{whole(), whole(), whole()};
    setup.radius = rng.chance(0.5) ? 4 : rng.logUniform(1e-3, 1e4);
    const int count = rng.chance(0.5) ? 1 : rng.integer(2, 12);
    for (int i = 0; i < count; ++i) setup.boxesWorld.push_back(awkwardBox(rng, centre, setup.radius, count == 1));
    const Camera camera = awkwardCamera(rng, centre, setup.radius);
    const Vec3d eye = camera.eyeWorld;
    setup.view = lixelView(camera);
    setup.light = awkwardLight(rng, camera, setup.boxesWorld[0], centre, setup.radius);
    // At round places, but near the eye as hosts must have it.
    setup.originWorld = rng.chance(0.5) ? Vec3d{} : Vec3d{std::round(eye.x), std::round(eye.y), std::round(eye.z)};
    if (rng.chance(0.3) || length(setup.originWorld - eye) > 100 * setup.radius) setup.originWorld = eye;
    return setup;
}

} // namespace lixel::test
