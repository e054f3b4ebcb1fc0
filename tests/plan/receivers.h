// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/shadow_plan.h"
#include "lixel/shared/lookup.h"
#include "plan/random_setups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

// Receivers of a random setup, the plans made for them, and the region that serves each.
namespace lixel::test {

inline bool isInView(const RandomSetup& setup, Vec3d pointLocal)
{
    const Vec4d c = clipFromLocal(setup.view, setup.originWorld) * point(pointLocal);
    return c.w > 0 && std::abs(c.x) <= c.w && std::abs(c.y) <= c.w && std::abs(c.z) <= c.w;
}

// Where floats of its position no longer say in which direction the light is.
inline bool isNextToLight(const RandomSetup& setup, Vec3d pointLocal)
{
    const double away = length(setup.light.positionWorld - setup.originWorld - pointLocal);
    return setup.light.kind != LightKind::Directional && away < (1.0 / 64) * (setup.radius + length(pointLocal));
}

// Points of the boxes that are in view, many on their faces, edges and corners, with normals towards the light.
inline ViewSamples anySamples(const RandomSetup& setup, Rng& rng)
{
    ViewSamples samples;
    samples.width = setup.view.width;
    samples.height = setup.view.height;
    samples.originWorld = setup.originWorld;
    for (int i = 0; i < 400 && samples.size() < 40; ++i) {
        const Box& box = setup.boxesWorld[std::size_t(rng.integer(0, int(setup.boxesWorld.size()) - 1))];
        const auto between = [&rng](double low, double high) {
            return rng.chance(0.3) ? (rng.chance(0.5) ? low : high) : rng.uniform(low, high);
        };
        const Vec3d world{between(box.min.x, box.max.x), between(box.min.y, box.max.y), between(box.min.z, box.max.z)};
        const Vec3d exact = world - setup.originWorld;
        const Vec3f p{float(exact.x), float(exact.y), float(exact.z)};
        if (!isInView(setup, toDouble(p)) || isNextToLight(setup, toDouble(p))) continue;
        const Vec3d n = towardsLight(setup.light, setup.originWorld, toDouble(p));
        if (!isLightFacing(setup.light, setup.originWorld, toDouble(p), n)) continue;
        const Vec3d pixel = pixelFromLocal(setup.view, setup.originWorld, toDouble(p));
        samples.pixel.push_back({float(pixel.x), float(pixel.y)});
        samples.positionLocal.push_back(p);
        samples.normal.push_back({float(n.x), float(n.y), float(n.z)});
        samples.triangle.push_back(kNoTriangle);
    }
    return samples;
}

// As far as a narrow rectangle has room for the reach; less a tenth of a lixel for the rounding of a map as narrow as they get.
inline double reachIn(int lixels, double reach) { return std::min(reach, 0.5 * lixels - 0.5) - 0.1; }

// Whether a receiver lies with the lookup's whole reach inside its region's map, in the floats that executors have.
inline void expectReachInside(const PlannedRegion& region, const LookupLayout& lookup,
                              const shared::LxReceiver& receiver)
{
    const LixelRectangle& r = region.rectangle;
    const auto x = float(reachIn(r.width(), lookup.reach)), y = float(reachIn(r.height(), lookup.reach));
    EXPECT_GE(receiver.lixel.x, float(r.x0) + x);
    EXPECT_LE(receiver.lixel.x, float(r.x1) - x);
    EXPECT_GE(receiver.lixel.y, float(r.y0) + y);
    EXPECT_LE(receiver.lixel.y, float(r.y1) - y);
}

inline shared::vec3 toShared(Vec3f a) { return {a.x, a.y, a.z}; }

// The region that serves a sample, by the very functions that executors use; nothing where none does.
inline const PlannedRegion* serving(const FramePlan& plan, Vec3f positionLocal, Vec3f normal,
                                    shared::LxReceiver& receiver)
{
    for (std::size_t r = 0; r < plan.regionTable.size(); ++r) {
        const shared::ShadowRegion& region = plan.regionTable[r];
        bool isHeld = true;
        for (int i = 0; i < int(region.place.z); ++i)
            isHeld = isHeld && shared::lxHolds(plan.halfSpaceTable[std::size_t(region.place.y) + std::size_t(i)],
                                               toShared(positionLocal));
        if (!isHeld) continue;
        const auto knot = [&](int i) { return plan.warpTable[std::size_t(i)]; };
        receiver = shared::lxReceive(region, toShared(positionLocal), toShared(normal), knot);
        if (receiver.isInside != 0) return &plan.lights[0].regions[r];
    }
    return nullptr;
}

// The plan of one light of a setup, from its technique's text.
inline FramePlan planOf(const RandomSetup& setup, const char* technique, LixelSize lixels = {512, 512})
{
    return planShadows({setup.view,
                        {&setup.light, 1},
                        setup.boxesWorld,
                        setup.originWorld,
                        std::get<MapTechnique>(*parseTechnique(technique)),
                        lixels});
}

// A technique's text as a part of a test's name.
inline std::string testName(const testing::TestParamInfo<const char*>& technique)
{
    std::string name;
    for (const char c : std::string_view(technique.param))
        name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
}

} // namespace lixel::test
