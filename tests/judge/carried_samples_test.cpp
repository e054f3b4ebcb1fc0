// SPDX-License-Identifier: MIT
#include "lixel/judge/carried_samples.h"

#include "support/random_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lixel {
namespace {

using test::forEachCase;
using test::kCases;
using test::Rng;

constexpr int kSide = 64;

// From afar, so that all of the unit ball is in it.
View viewFrom(Vec3d eyeWorld)
{
    const Vec3d up = std::abs(eyeWorld.y) > 0.9 * length(eyeWorld) ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    return perspectiveView(eyeWorld, {}, up, std::numbers::pi / 3, 0.5, 100, kSide, kSide);
}

LocalTriangles anyTriangles(Rng& rng, int count)
{
    LocalTriangles triangles;
    for (int i = 0; i < count; ++i) {
        const Vec3d a = rng.inBox(0.4);
        Vec3d b = a + rng.inBox(0.3), c = a + rng.inBox(0.3);
        if (length(cross(b - a, c - a)) < 1e-3) b = a + Vec3d{0.2, 0, 0}, c = a + Vec3d{0, 0.2, 0.1};
        for (const Vec3d& p : {a, b, c}) {
            triangles.indices.push_back(std::uint32_t(triangles.positionLocal.size()));
            triangles.positionLocal.push_back(toFloat(p));
        }
        triangles.material.push_back(0);
    }
    return triangles;
}

// A point of each triangle, on the side that the view looks at.
ViewSamples samplesOf(const LocalTriangles& triangles, const View& view, Rng& rng)
{
    ViewSamples samples;
    samples.width = view.width, samples.height = view.height;
    for (std::size_t t = 0; t < triangles.triangleCount(); ++t) {
        const auto corner = [&](std::size_t k) {
            return toDouble(triangles.positionLocal[triangles.indices[3 * t + k]]);
        };
        const double u = rng.uniform(0, 0.5), v = rng.uniform(0, 0.5);
        const Vec3d p = corner(0) + u * (corner(1) - corner(0)) + v * (corner(2) - corner(0));
        const Vec3d n = normalized(cross(corner(1) - corner(0), corner(2) - corner(0)));
        const bool isFront = dot(n, towardsEye(view, {}, p)) > 0;
        const Vec3d pixel = pixelFromLocal(view, {}, p);
        samples.pixel.push_back({float(pixel.x), float(pixel.y)});
        samples.positionLocal.push_back(toFloat(p));
        samples.normal.push_back(toFloat(isFront ? n : -n));
        samples.triangle.push_back(std::uint32_t(t));
    }
    return samples;
}

// A rotation about the origin, and a shift.
struct Motion
{
    Vec3d x, y, z, shift;
    Vec3d turned(Vec3d p) const { return p.x * x + p.y * y + p.z * z; }
    Vec3d operator()(Vec3d p) const { return turned(p) + shift; }
};

Motion anyMotion(Rng& rng)
{
    const Vec3d x = rng.onSphere();
    const Vec3d z = normalized(cross(x, std::abs(x.y) < 0.7 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0}));
    return {x, cross(z, x), z, rng.inBox(0.1)};
}

TEST(CarriedSamples, OfAStillSceneAndViewAreTheSamplesBitForBit)
{
    forEachCase(kCases, [](Rng& rng) {
        const View view = viewFrom(3.0 * rng.onSphere());
        const LocalTriangles triangles = anyTriangles(rng, 20);
        const ViewSamples samples = samplesOf(triangles, view, rng);
        const CarriedSamples carried = carry(samples, triangles, triangles, view);
        // Edge-on triangles may be taken for turned away, by rounding.
        for (std::size_t i = 0; i < carried.from.size(); ++i) {
            const std::size_t was = carried.from[i];
            EXPECT_EQ(carried.samples.positionLocal[i], samples.positionLocal[was]);
            EXPECT_EQ(carried.samples.normal[i], samples.normal[was]);
            EXPECT_EQ(carried.samples.triangle[i], samples.triangle[was]);
            EXPECT_NEAR(carried.samples.pixel[i].x, samples.pixel[was].x, 1e-4);
            EXPECT_NEAR(carried.samples.pixel[i].y, samples.pixel[was].y, 1e-4);
        }
        EXPECT_GE(carried.from.size(), samples.size() - 1);
    });
}

TEST(CarriedSamples, MoveRigidlyWithTheirTriangle)
{
    forEachCase(kCases, [](Rng& rng) {
        const View view = viewFrom({0, 0, 3});
        const LocalTriangles before = anyTriangles(rng, 20);
        const ViewSamples samples = samplesOf(before, view, rng);
        const Motion motion = anyMotion(rng);
        LocalTriangles now = before;
        for (Vec3f& p : now.positionLocal) p = toFloat(motion(toDouble(p)));
        const CarriedSamples carried = carry(samples, before, now, view);
        for (std::size_t i = 0; i < carried.from.size(); ++i) {
            const std::size_t was = carried.from[i];
            const Vec3d there = motion(toDouble(samples.positionLocal[was]));
            EXPECT_LT(length(toDouble(carried.samples.positionLocal[i]) - there), 1e-5);
            // Corners are floats: a small triangle's normal is less sure than its place.
            EXPECT_GT(dot(toDouble(carried.samples.normal[i]), motion.turned(toDouble(samples.normal[was]))), 0.999);
            EXPECT_GT(dot(toDouble(carried.samples.normal[i]), towardsEye(view, {}, there)), -1e-4);
        }
    });
}

TEST(CarriedSamples, LeaveOutWhatIsOutsideTheViewOrTurnedAway)
{
    forEachCase(kCases, [](Rng& rng) {
        const LocalTriangles triangles = anyTriangles(rng, 10);
        const ViewSamples samples = samplesOf(triangles, viewFrom({0, 0, 3}), rng);
        const Vec3d eye = rng.inBox(2);
        const View now = perspectiveView(eye, eye + rng.onSphere(), {0.3, 0.9, 0.1}, 0.6, 0.1, 2.5, kSide, kSide);
        const CarriedSamples carried = carry(samples, triangles, triangles, now);
        std::vector<bool> isThere(samples.size(), false);
        for (const std::uint32_t i : carried.from) isThere[i] = true;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const Vec3d p = toDouble(samples.positionLocal[i]);
            const Vec4d clip = clipFromLocal(now, {}) * point(p);
            const double inside = clip.w - std::max({std::abs(clip.x), std::abs(clip.y), std::abs(clip.z)});
            const double facing = dot(toDouble(samples.normal[i]), towardsEye(now, {}, p));
            if (std::abs(inside) < 1e-9 || std::abs(facing) < 1e-9) continue; // rounding decides
            EXPECT_EQ(isThere[i], inside > 0 && facing > 0) << inside << " " << facing;
        }
    });
}

// Triangles without area are left out of a scene's list, which shifts the numbers of all that follow.
TEST(CarriedSamples, FindTheirTriangleAgainWhenOthersComeAndGo)
{
    forEachCase(kCases, [](Rng& rng) {
        const View view = viewFrom({0, 0, 3});
        const LocalTriangles all = anyTriangles(rng, 12);
        const auto some = [&] {
            LocalTriangles out = all;
            out.indices.clear(), out.material.clear();
            std::vector<std::uint32_t> numbers;
            for (std::uint32_t t = 0; t < 12; ++t) {
                if (rng.chance(0.3)) continue;
                for (std::size_t k = 0; k < 3; ++k) out.indices.push_back(all.indices[3 * t + k]);
                out.material.push_back(0);
                numbers.push_back(t);
            }
            return std::pair(out, numbers);
        };
        const auto [before, numbersBefore] = some();
        const auto [now, numbersNow] = some();
        const ViewSamples samples = samplesOf(before, view, rng);
        const CarriedSamples carried = carry(samples, before, now, view);
        std::size_t common = 0;
        for (const std::uint32_t t : numbersBefore) common += std::ranges::find(numbersNow, t) != numbersNow.end();
        EXPECT_LE(carried.from.size(), common);
        EXPECT_GE(carried.from.size() + 1, common); // an edge-on one
        for (std::size_t i = 0; i < carried.from.size(); ++i)
            EXPECT_EQ(numbersNow[carried.samples.triangle[i]], numbersBefore[samples.triangle[carried.from[i]]]);
    });
}

TEST(CarriedSamples, WithoutATriangleStayWhereTheyAre)
{
    const View view = viewFrom({0, 0, 3});
    ViewSamples samples;
    samples.width = samples.height = kSide;
    samples.pixel = {{32, 32}};
    samples.positionLocal = {{0, 0, 0}};
    samples.normal = {{0, 0, 1}};
    samples.triangle = {kNoTriangle};
    const CarriedSamples carried = carry(samples, {}, {}, view);
    ASSERT_EQ(carried.from.size(), 1u);
    EXPECT_EQ(carried.samples.positionLocal, samples.positionLocal);
    EXPECT_EQ(carried.samples.triangle, samples.triangle);
    EXPECT_EQ(carry(samples, {}, {}, viewFrom({0, 0, -3})).from.size(), 0u) << "seen from behind";
}

TEST(CarriedSamples, AreKeptAndJoinedInOrder)
{
    Rng rng(1);
    const View view = viewFrom({0, 0, 3});
    const LocalTriangles triangles = anyTriangles(rng, 9);
    const ViewSamples samples = samplesOf(triangles, view, rng);
    const CarriedSamples carried = carry(samples, triangles, triangles, view);
    std::vector<float> isKept(carried.from.size(), 0.0f);
    isKept[1] = 1, isKept[4] = 0.5f;
    const CarriedSamples kept = keepOnly(carried, isKept);
    EXPECT_EQ(kept.from, (std::vector{carried.from[1], carried.from[4]}));
    const ViewSamples both = joined(samples, kept.samples);
    ASSERT_EQ(both.size(), samples.size() + 2);
    EXPECT_EQ(both.positionLocal[samples.size()], samples.positionLocal[carried.from[1]]);
    EXPECT_EQ(both.positionLocal.back(), samples.positionLocal[carried.from[4]]);
    EXPECT_EQ(both.triangle.size(), both.size());
    EXPECT_EQ(both.pixel.size(), both.size());
    EXPECT_EQ(both.normal.size(), both.size());
}

} // namespace
} // namespace lixel
