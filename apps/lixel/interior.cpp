// SPDX-License-Identifier: MIT
#include "interior.h"

#include "lixel/scene/framing.h"
#include "lixel/trace/trace_scene.h"
#include "lixel/trace/trace_view_samples.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lixel::app {
namespace {

constexpr int kRaysASide = 24;                 // of each of the six faces that a place is looked at through
constexpr double kLeastEnclosed = 0.75;        // share of directions that meet a surface
constexpr double kLeastFront = 0.7;            // share of these that meet its front side
constexpr double kOpenAbove = 0.1;             // share of the upward face that sees the sky
constexpr double kEyeHeights[] = {0.12, 0.25}; // of the scene's height
constexpr double kLeastFree = 0.08;            // of the scene's length: what the camera must have before it
constexpr double kAlong[] = {-0.4, -0.3, -0.2, 0.0, 0.2, 0.3, 0.4};

// What is seen from a place in all directions.
struct Surroundings
{
    double enclosed = 0, front = 0, openAbove = 0;
    std::array<double, 6> distance{}; // median along +x, -x, +y, -y, +z, -z; 0 where nothing is met
};

constexpr std::array<Vec3d, 6> kDirections{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};

bool showsFront(const TraceScene& scene, std::uint32_t triangle, Vec3d normalTowardsEye)
{
    const Corners c = scene.corners(triangle);
    return dot(cross(c[1] - c[0], c[2] - c[0]), normalTowardsEye) > 0;
}

Surroundings lookAround(const TraceScene& scene, Vec3d eyeWorld, double near)
{
    Surroundings out;
    std::size_t hits = 0, front = 0;
    for (std::size_t face = 0; face < 6; ++face) {
        const Vec3d d = kDirections[face], up = d.y != 0 ? Vec3d{0, 0, 1} : Vec3d{0, 1, 0};
        const View view =
            perspectiveView(eyeWorld, eyeWorld + d, up, 1.5707963267948966, near, INFINITY, kRaysASide, kRaysASide);
        const ViewSamples samples = traceViewSamples(scene, view);
        std::vector<double> depths;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            front += showsFront(scene, samples.triangle[i], toDouble(samples.normal[i]));
            depths.push_back(dot(d, toDouble(samples.positionLocal[i]) + samples.originWorld - eyeWorld));
        }
        hits += samples.size();
        std::nth_element(depths.begin(), depths.begin() + std::ptrdiff_t(depths.size() / 2), depths.end());
        if (!depths.empty()) out.distance[face] = depths[depths.size() / 2];
        if (face == 2) out.openAbove = 1 - double(samples.size()) / (kRaysASide * kRaysASide);
    }
    out.enclosed = double(hits) / (6 * kRaysASide * kRaysASide);
    out.front = hits > 0 ? double(front) / double(hits) : 0;
    return out;
}

Light lightFor(const Surroundings& around, Vec3d eyeWorld, Vec3d forward)
{
    Light light;
    if (around.openAbove > kOpenAbove) {
        light.name = "sun";
        light.directionWorld = normalized(0.3 * forward + Vec3d{0.25 * forward.z, -1, -0.25 * forward.x});
        return light;
    }
    light.name = "spot";
    light.kind = LightKind::Spot;
    light.positionWorld = eyeWorld + Vec3d{0, 0.7 * around.distance[2], 0};
    light.directionWorld = normalized(forward + Vec3d{0, -0.6, 0});
    light.coneAngle = 1.9;
    return light;
}

} // namespace

std::optional<InteriorShot> interiorShot(const TraceScene& scene, const Box& sceneWorld)
{
    const Vec3d size = sceneWorld.max - sceneWorld.min, centre = sceneWorld.centre();
    const bool isLongInX = size.x >= size.z;
    const Vec3d axis = isLongInX ? Vec3d{size.x, 0, 0} : Vec3d{0, 0, size.z};
    std::optional<InteriorShot> best;
    double longest = kLeastFree * length(axis);
    for (const double height : kEyeHeights)
        for (const double along : kAlong) {
            const Vec3d eye = Vec3d{centre.x, sceneWorld.min.y + height * size.y, centre.z} + along * axis;
            const Surroundings around = lookAround(scene, eye, 1e-4 * sceneWorld.diagonal());
            if (around.enclosed < kLeastEnclosed || around.front < kLeastFront) continue;
            for (const std::size_t face : {std::size_t(isLongInX ? 0 : 4), std::size_t(isLongInX ? 1 : 5)}) {
                if (around.distance[face] <= longest) continue;
                longest = around.distance[face];
                Camera camera;
                camera.name = "inside";
                camera.eyeWorld = eye;
                camera.targetWorld = eye + kDirections[face];
                camera.fovy = 1.1;
                best = InteriorShot{camera, lightFor(around, eye, kDirections[face])};
            }
        }
    return best;
}

} // namespace lixel::app
