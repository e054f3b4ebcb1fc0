// SPDX-License-Identifier: MIT
#include "interior.h"

#include "picture_interest.h"

#include "lixel/base/median.h"
#include "lixel/scene/framing.h"
#include "lixel/trace/parallel.h"
#include "lixel/trace/trace_scene.h"
#include "lixel/trace/trace_view_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace lixel::app {
namespace {

constexpr int kRaysASide = 24;          // of each of the six faces that a place is looked at through
constexpr double kLeastEnclosed = 0.95; // share of directions that meet a surface; streets and cars stay below
constexpr double kLeastFront = 0.9;     // share of these that meet its front side
constexpr double kLeastRoom = 0.1;      // share of the places that are inside
constexpr double kOpenAbove = 0.1;      // share of the upward face that sees the sky
constexpr double kTooNear = 0.08;       // of the scene's length
constexpr double kFovy = 1.1;

// What is tried: places in a grid, as shares of the scene's size, and at each of them directions.
constexpr double kEyeHeights[] = {0.15, 0.3, 0.45};
constexpr double kAlong[] = {-0.4, -0.2, 0, 0.2, 0.4}, kAcross[] = {-0.25, 0, 0.25};
constexpr int kDirectionsAround = 8;
constexpr double kSlopes[] = {0, -0.2};
constexpr int kTrialWidth = 40, kTrialHeight = 30; // pixels

// What is seen from a place in all directions.
struct Surroundings
{
    double enclosed = 0, front = 0, openAbove = 0;
    double toCeiling = 0; // median height of what is above; 0 where nothing is
};

constexpr std::array<Vec3d, 6> kDirections{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};

bool showsFront(const TraceScene& scene, std::uint32_t triangle, Vec3d normalTowardsEye)
{
    const Corners c = scene.corners(triangle);
    return dot(cross(c[1] - c[0], c[2] - c[0]), normalTowardsEye) > 0;
}

double medianHeight(const ViewSamples& samples, Vec3d eyeWorld)
{
    if (samples.size() == 0) return 0;
    std::vector<double> heights;
    for (const Vec3f& p : samples.positionLocal) heights.push_back(p.y + samples.originWorld.y - eyeWorld.y);
    return median(std::move(heights));
}

Surroundings lookAround(const TraceScene& scene, Vec3d eyeWorld, double near)
{
    Surroundings out;
    std::size_t hits = 0, front = 0;
    for (const Vec3d& d : kDirections) {
        const Vec3d up = d.y != 0 ? Vec3d{0, 0, 1} : Vec3d{0, 1, 0};
        const View view =
            perspectiveView(eyeWorld, eyeWorld + d, up, 1.5707963267948966, near, INFINITY, kRaysASide, kRaysASide);
        const ViewSamples samples = traceViewSamples(scene, view);
        for (std::size_t i = 0; i < samples.size(); ++i)
            front += showsFront(scene, samples.triangle[i], toDouble(samples.normal[i]));
        hits += samples.size();
        if (!(d.y > 0)) continue;
        out.toCeiling = medianHeight(samples, eyeWorld);
        out.openAbove = 1 - double(samples.size()) / (kRaysASide * kRaysASide);
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
    light.positionWorld = eyeWorld + Vec3d{0, 0.7 * around.toCeiling, 0};
    light.directionWorld = normalized(forward + Vec3d{0, -0.6, 0});
    light.coneAngle = 1.9;
    return light;
}

std::vector<Vec3d> places(const Box& sceneWorld)
{
    const Vec3d size = sceneWorld.max - sceneWorld.min, centre = sceneWorld.centre();
    const bool isLongInX = size.x >= size.z;
    std::vector<Vec3d> all;
    for (const double height : kEyeHeights)
        for (const double along : kAlong)
            for (const double across : kAcross)
                all.push_back({centre.x + (isLongInX ? along : across) * size.x, sceneWorld.min.y + height * size.y,
                               centre.z + (isLongInX ? across : along) * size.z});
    return all;
}

InteriorShot shotFrom(Vec3d eyeWorld, Vec3d forward, const Surroundings& around)
{
    InteriorShot shot{{}, lightFor(around, eyeWorld, forward)};
    shot.camera.name = "inside";
    shot.camera.eyeWorld = eyeWorld;
    shot.camera.targetWorld = eyeWorld + forward;
    shot.camera.fovy = kFovy;
    return shot;
}

struct Trial
{
    bool isInside = false;
    double interest = 0;
    InteriorShot shot; // the most interesting, where interest > 0
};

Trial tryPlace(const TraceScene& scene, const Box& sceneWorld, Vec3d eyeWorld)
{
    const Vec3d size = sceneWorld.max - sceneWorld.min;
    const double near = 1e-4 * sceneWorld.diagonal(), tooNear = kTooNear * std::max(size.x, size.z);
    const Surroundings around = lookAround(scene, eyeWorld, near);
    Trial best;
    best.isInside = around.enclosed >= kLeastEnclosed && around.front >= kLeastFront;
    for (int d = 0; best.isInside && d < kDirectionsAround; ++d)
        for (const double slope : kSlopes) {
            const double angle = 2 * std::numbers::pi * d / kDirectionsAround;
            const InteriorShot shot = shotFrom(eyeWorld, {std::cos(angle), slope, std::sin(angle)}, around);
            const View view = perspectiveView(eyeWorld, shot.camera.targetWorld, shot.camera.up, kFovy, near, INFINITY,
                                              kTrialWidth, kTrialHeight);
            const double interest = pictureInterest(scene, view, eyeWorld, shot.light, tooNear);
            if (interest > best.interest) best.interest = interest, best.shot = shot;
        }
    return best;
}

} // namespace

std::optional<InteriorShot> interiorShot(const TraceScene& scene, const Box& sceneWorld)
{
    const std::vector<Vec3d> eyes = places(sceneWorld);
    std::vector<Trial> trials(eyes.size());
    forEachBlock(eyes.size(), 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) trials[i] = tryPlace(scene, sceneWorld, eyes[i]);
    });
    const auto inside = std::count_if(trials.begin(), trials.end(), [](const Trial& t) { return t.isInside; });
    if (double(inside) < kLeastRoom * double(trials.size())) return std::nullopt;
    const auto best = std::max_element(trials.begin(), trials.end(),
                                       [](const Trial& a, const Trial& b) { return a.interest < b.interest; });
    if (!(best->interest > 0)) return std::nullopt;
    return best->shot;
}

} // namespace lixel::app
