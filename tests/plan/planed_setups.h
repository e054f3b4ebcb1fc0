// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/plane.h"
#include "plan/receivers.h"

#include <string>
#include <string_view>
#include <vector>

// Planes of interest of random setups: faces of its boxes and planes anywhere, in either orientation, with and without polygons.
namespace lixel::test {

// A side of a box, its polygon the whole side.
inline NamedPlane sideOf(const Box& box, int axis, bool isMax, bool isTurned, bool hasPolygon)
{
    const auto at = [](Vec3d& v, int i) -> double& { return i == 0 ? v.x : i == 1 ? v.y : v.z; };
    Vec3d normal, corner = isMax ? box.max : box.min;
    at(normal, axis) = isTurned ? -1 : 1;
    NamedPlane plane{"", corner, normal, {}};
    if (!hasPolygon) return plane;
    for (const auto& [u, v] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        Vec3d low = box.min, high = box.max, p = corner;
        const int b = (axis + 1) % 3, c = (axis + 2) % 3;
        at(p, b) = at(u ? high : low, b);
        at(p, c) = at(v ? high : low, c);
        plane.polygonWorld.push_back(p);
    }
    return plane;
}

// A convex polygon of a plane about a point of it, its corners either way round.
inline void addPolygon(NamedPlane& plane, double size, Rng& rng)
{
    const Vec3d u = anyPerpendicular(plane.normalWorld), v = cross(plane.normalWorld, u);
    const int corners = rng.integer(3, 12); // more than eight are enclosed
    const double way = rng.chance(0.5) ? 1 : -1;
    for (int i = 0; i < corners; ++i) {
        const double angle = way * 6.283185307179586 * (i + rng.uniform(0, 0.9)) / corners;
        plane.polygonWorld.push_back(plane.pointWorld + size * (std::cos(angle) * u + 0.6 * std::sin(angle) * v));
    }
}

inline NamedPlane anyNamedPlane(const RandomSetup& setup, Rng& rng)
{
    const Box& box = setup.boxesWorld[std::size_t(rng.integer(0, int(setup.boxesWorld.size()) - 1))];
    if (rng.chance(0.7)) return sideOf(box, rng.integer(0, 2), rng.chance(0.5), rng.chance(0.5), rng.chance(0.3));
    const Vec3d normal = rng.chance(0.3) ? Vec3d{0, rng.chance(0.5) ? 1.0 : -1.0, 0} : rng.onSphere();
    NamedPlane plane{"", box.centre() + 0.3 * setup.radius * rng.inBox(1), normal, {}};
    if (rng.chance(0.4)) addPolygon(plane, rng.uniform(0.1, 1) * setup.radius, rng);
    return plane;
}

// Two to eight planes, or as many as asked, named a, b, c and so on. The first box of ordinary setups is a floor, whose top is `a`.
inline std::vector<NamedPlane> anyPlanes(const RandomSetup& setup, Rng& rng, bool isOrdinary = false, int count = 8)
{
    std::vector<NamedPlane> planes;
    for (int i = 0; i < count; ++i) {
        planes.push_back(anyNamedPlane(setup, rng));
        if (isOrdinary && i == 0) planes.back() = sideOf(setup.boxesWorld[0], 1, true, rng.chance(0.5), false);
        planes.back().name = std::string(1, char('a' + i));
    }
    return planes;
}

// As if some lights had been looked up at these samples, with shadows that end anywhere.
inline Observation anyObservation(const RandomSetup& setup, const ViewSamples& samples, Rng& rng)
{
    Observation observed;
    observed.samples = samples;
    observed.view = setup.view;
    const bool isLookedUp = rng.chance(0.8);
    for (std::size_t i = 0; isLookedUp && i < samples.size(); ++i) {
        observed.lit.push_back(std::uint32_t(rng.bits()));
        observed.atBoundary.push_back(rng.chance(0.3) ? std::uint32_t(rng.bits()) : 0);
    }
    return observed;
}

// Of a light and a scene that have nothing to do with those of now.
inline RememberedMap anyMap(Rng& rng)
{
    RememberedMap map{{}, {}, rng.integer(0, 4)};
    for (int row = 0; row < 4; ++row)
        map.lightClipFromLocal.setRow(row,
                                      {rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)});
    return map;
}

// What is asked of a setup: planes, and of view samples and of an observation what the technique needs or luck gives.
struct PlanedCase
{
    std::vector<NamedPlane> planes;
    std::vector<LightMemory> before;
    Observation observed;

    void giveTo(PlanInput& input, const RandomSetup& setup, const ViewSamples& samples, Rng& rng, bool isOrdinary)
    {
        planes = anyPlanes(setup, rng, isOrdinary);
        input.planes = planes;
        input.seen = rng.chance(0.7) || needsViewSamples(input.technique) ? &samples : nullptr;
        input.seenIsAll = input.seen && rng.chance(0.5);
        const auto first = firstPassOf(input.technique, input.lixels);
        if (!first) return;
        observed = anyObservation(setup, samples, rng);
        if (rng.chance(0.6)) input.observed = &observed;
        if (rng.chance(0.5)) input.lixelsSpent = std::int64_t(first->lixels.width) * first->lixels.height;
        if (rng.chance(0.5)) {
            const Plane plane = planeThrough(planes[0].pointWorld - setup.originWorld, planes[0].normalWorld);
            before = {{{{plane, rng.chance(0.5)}}, {anyMap(rng)}}};
        } else if (rng.chance(0.5)) {
            before = rememberedBy(planShadows(input));
        }
        input.before = before;
    }
};

inline constexpr const char* kPlaneTechniques[] = {"planes(a)",
                                                   "planes(a,b)",
                                                   "planes(b,a,twist=line)+else(lispsm)",
                                                   "planes(a,b,c,d,e,f,g,h,twist=none)",
                                                   "planes(a,b)+else(pssm(3)+focused)",
                                                   "planes(a,b)+plane-optimal(desired-view)",
                                                   "planes(a,b)+else(cube)+allocation=share",
                                                   "planes(a,b,c)+plane-optimal+else(psm)+pcf(9)",
                                                   "planes(c,d)+focused+else(focused)",
                                                   "planes(auto)",
                                                   "planes(auto,twist=line)+else(focused)+pcf(9)"};

inline constexpr const char* kSceneTechniques[] = {"scene-optimal",
                                                   "scene-optimal(metric=l2,search=paper)",
                                                   "scene-optimal(metric=l2,slack=0,shear)",
                                                   "scene-optimal(metric=lloyd,update=1,weight=0)+else(cube)",
                                                   "scene-optimal(metric=area,keep=none)+else(lispsm)+pcf(9)",
                                                   "pssm(3)+scene-optimal",
                                                   "cube+scene-optimal+else(cube)",
                                                   "planes(a)+scene-optimal"};

// Whether more is asked than a view, a light and boxes.
inline bool wantsMore(const MapTechnique& technique)
{
    return std::holds_alternative<PlanesPartition>(technique.partition) || sceneOptimalOf(technique);
}

} // namespace lixel::test
