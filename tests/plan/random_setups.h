// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/box.h"
#include "lixel/base/light.h"
#include "lixel/base/view.h"
#include "lixel/plan/fit/fit.h"
#include "support/random_cases.h"

#include <vector>

// Random scenes of boxes with a view and a light, of any scale and anywhere: what fits are tried on.
namespace lixel::test {

struct RandomSetup
{
    std::vector<Box> boxesWorld;
    View view;
    Light light;
    Vec3d originWorld;
    double radius = 1;

    Box sceneLocal() const
    {
        Box scene;
        for (const Box& box : boxesWorld) scene.include(box);
        return translated(scene, -originWorld);
    }
};

// What a fit of the whole of it is given; all share one scratch.
inline FitInput inputOf(const RandomSetup& setup)
{
    static FitScratch scratch;
    return {setup.view, setup.light, setup.originWorld, setup.boxesWorld, setup.sceneLocal(), scratch};
}

inline Light anyLight(Rng& rng, Vec3d centre, double radius)
{
    Light light;
    light.kind = LightKind(rng.integer(0, 2));
    light.directionWorld = rng.onSphere();
    const double distance = radius * (rng.chance(0.5) ? rng.logUniform(0.1, 10) : rng.logUniform(1, 1e6));
    light.positionWorld = centre - distance * light.directionWorld;
    light.coneAngle = rng.uniform(0.2, 2.8);
    if (rng.chance(0.3)) light.range = distance * rng.uniform(0.5, 3);
    return light;
}

inline View anyView(Rng& rng, Vec3d centre, double radius)
{
    const Vec3d eye = centre + radius * rng.logUniform(0.05, 5) * rng.onSphere();
    const Vec3d target = centre + 0.5 * radius * rng.onSphere();
    const double near = radius * rng.logUniform(1e-3, 1e-1);
    const double far = rng.chance(0.5) ? INFINITY : radius * rng.logUniform(1, 30);
    const int width = rng.integer(64, 1024), height = rng.integer(64, 1024);
    if (rng.chance(0.2))
        return orthographicView(eye, target, rng.onSphere(), radius * rng.uniform(0.2, 3), 0,
                                std::isinf(far) ? 10 * radius : far, width, height);
    return perspectiveView(eye, target, rng.onSphere(), rng.uniform(0.3, 2), near, far, width, height);
}

inline RandomSetup anySetup(Rng& rng)
{
    RandomSetup setup;
    const Vec3d centre = rng.chance(0.3) ? 1e5 * rng.onSphere() : rng.inBox(1);
    setup.radius = rng.logUniform(1e-3, 1e4);
    for (int i = rng.integer(1, 12); i > 0; --i) {
        Box box;
        const Vec3d middle = centre + setup.radius * rng.inBox(0.5);
        box.include(middle - setup.radius * Vec3d{rng.uniform(0, 0.3), rng.uniform(0, 0.3), rng.uniform(0, 0.3)});
        box.include(middle + setup.radius * Vec3d{rng.uniform(0, 0.3), rng.uniform(0, 0.3), rng.uniform(0, 0.3)});
        setup.boxesWorld.push_back(box);
    }
    setup.view = anyView(rng, centre, setup.radius);
    setup.light = anyLight(rng, centre, setup.radius);
    setup.originWorld = setup.view.anchorWorld + 0.1 * setup.radius * rng.inBox(1);
    return setup;
}

} // namespace lixel::test
