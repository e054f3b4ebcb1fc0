// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/fit/edge_rays.h"
#include "lixel/plan/fit/light_frame.h"
#include "plan/random_setups.h"

#include <algorithm>
#include <cmath>
#include <vector>

// Any surfaces, here and there before an eye and a light, and any map of the light plane that has them before it.
namespace lixel::test {

struct EdgeScene
{
    View view;
    Light light;
    Vec3d originWorld;
    std::vector<NeedSample> samples;
    LightFrame frame;
    EdgeRays rays;
};

// Surfaces are at least so far from edge-on to the eye and to the light.
inline constexpr double kLeastSlope = 0.1;

inline EdgeScene anyEdgeScene(Rng& rng, int most = 40, Vec3d centre = {})
{
    EdgeScene s;
    const double radius = rng.logUniform(0.1, 100);
    const Vec3d eye = centre + rng.uniform(1.5, 4) * radius * rng.onSphere();
    const int width = rng.integer(64, 1024), height = rng.integer(64, 1024);
    s.view = rng.chance(0.2) ? orthographicView(eye, centre, rng.onSphere(), 2 * radius, 0, 10 * radius, width, height)
                             : perspectiveView(eye, centre, rng.onSphere(), rng.uniform(0.3, 1.5), 0.01 * radius,
                                               100 * radius, width, height);
    s.light.kind = LightKind(rng.integer(0, 2));
    s.light.directionWorld = rng.onSphere();
    s.light.positionWorld = centre - rng.logUniform(2, 100) * radius * s.light.directionWorld;
    s.originWorld = centre + radius * rng.inBox(1);
    s.frame = lightFrame(s.light, s.originWorld, s.light.directionWorld);
    for (int i = rng.integer(1, most); i > 0; --i) {
        NeedSample sample;
        sample.pointLocal = centre - s.originWorld + radius * rng.inBox(0.7);
        const Vec3d toEye = normalized(towardsEye(s.view, s.originWorld, sample.pointLocal)),
                    toLight = towardsLight(s.light, s.originWorld, sample.pointLocal);
        do sample.normal = rng.onSphere();
        while (std::abs(dot(sample.normal, toEye)) < kLeastSlope ||
               std::abs(dot(sample.normal, toLight)) < kLeastSlope);
        sample.weight = rng.uniform(0.1, 2);
        const double angle = rng.uniform(0, 6.3);
        if (rng.chance(0.7)) sample.across = {std::cos(angle), std::sin(angle)};
        s.samples.push_back(sample);
    }
    s.rays.assign(s.view, s.originWorld, s.frame.framedFromLocal, s.samples);
    return s;
}

// Rows of about the size of the samples' image; w does not fall below a tenth of what it is along the frame's axis.
inline PlaneWarp anyMap(Rng& rng, const EdgeRays& rays)
{
    double size = 0;
    for (std::size_t i = 0; i < rays.size(); ++i)
        size = std::max(size, std::hypot(rays.ray[0][i], rays.ray[1][i]) / rays.ray[2][i]);
    const double tilt = rng.uniform(0, 0.9) / std::max(size, 1e-9), way = rng.uniform(0, 6.3),
                 turn = rng.uniform(0, 6.3);
    const Vec2d x{std::cos(turn), std::sin(turn)};
    const Vec2d y = Vec2d{-x.y, x.x} + rng.uniform(-0.5, 0.5) * x;
    const auto row = [&](Vec2d a, double scale) { return (scale / size) * Vec3d{a.x, a.y, size * rng.uniform(-1, 1)}; };
    return {row(x, rng.logUniform(0.1, 10)), row(rng.chance(0.5) ? y : -1.0 * y, rng.logUniform(0.1, 10)),
            rng.logUniform(0.1, 10) * Vec3d{tilt * std::cos(way), tilt * std::sin(way), 1}};
}

inline constexpr LixelMetric kAllMetrics[] = {LixelMetric::L2, LixelMetric::Lloyd, LixelMetric::Area,
                                              LixelMetric::Width};

} // namespace lixel::test
