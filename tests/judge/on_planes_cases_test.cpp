// SPDX-License-Identifier: MIT
#include "lixel/judge/on_planes.h"

#include "support/random_cases.h"

#include <gtest/gtest.h>

namespace lixel {
namespace {

using test::forEachCase;
using test::kCases;
using test::Rng;

void add(ViewSamples& samples, Vec3d world, Vec3d normal)
{
    samples.positionLocal.push_back(toFloat(world - samples.originWorld));
    samples.normal.push_back(toFloat(normal));
    samples.pixel.push_back({});
    samples.triangle.push_back(kNoTriangle);
}

TEST(OnPlanes, SamplesOfAPlaneAreOnItAndThoseBesideItOrTurnedAreNot)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const Vec3d n = rng.onSphere(), u = anyPerpendicular(n), v = cross(n, u), at = 100 * rng.inBox(1);
        const NamedPlane plane{"p", at, rng.chance(0.5) ? n : -n, {}};
        ViewSamples samples;
        samples.originWorld = at + 5 * rng.inBox(1);
        for (int i = 0; i < 20; ++i) {
            const Vec3d on = at + rng.uniform(-10, 10) * u + rng.uniform(-10, 10) * v;
            add(samples, on, n);
            add(samples, on, -n);
            add(samples, on + rng.logUniform(1e-3, 1) * n, n);
            add(samples, on, normalized(n + 0.01 * u));
        }
        const std::vector<int> planeOf = planeOfSamples(samples, {&plane, 1});
        for (std::size_t i = 0; i < planeOf.size(); ++i) EXPECT_EQ(planeOf[i], i % 4 < 2 ? 0 : kOnNoPlane);
    });
}

TEST(OnPlanes, TheFirstPlaneThatHoldsASampleHasItAndPolygonsEnd)
{
    const std::vector<Vec3d> square{{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}};
    std::vector<Vec3d> turned(square.rbegin(), square.rend());
    const std::vector<NamedPlane> planes{{"rug", {0, 0, 0}, {0, 1, 0}, square}, {"floor", {3, 0, 4}, {0, -1, 0}, {}}};
    std::vector<NamedPlane> other = planes;
    other[0].polygonWorld = turned;
    ViewSamples samples;
    add(samples, {0.5, 0, -0.5}, {0, 1, 0});
    add(samples, {1.5, 0, 0}, {0, 1, 0});
    add(samples, {0, 1, 0}, {0, 1, 0});
    const std::vector<int> expected{0, 1, kOnNoPlane};
    EXPECT_EQ(planeOfSamples(samples, planes), expected);
    EXPECT_EQ(planeOfSamples(samples, other), expected);
    EXPECT_EQ(planeOfSamples(samples, {}), std::vector<int>(3, kOnNoPlane));
}

TEST(OnPlanes, CountsAddUpToThoseOfAllLightFacingSamples)
{
    forEachCase(kCases, [](Rng& rng) {
        std::vector<int> planeOf;
        std::vector<Zone> zones;
        std::vector<float> visibility, exact;
        std::int64_t facing = 0, wrong = 0;
        for (int i = 0; i < 100; ++i) {
            planeOf.push_back(rng.integer(kOnNoPlane, 2));
            zones.push_back(rng.chance(0.3) ? Zone::FacingAway : rng.chance(0.5) ? Zone::EdgeBand : Zone::Interior);
            visibility.push_back(float(rng.integer(0, 4)) / 4);
            exact.push_back(float(rng.integer(0, 1)));
            if (zones.back() == Zone::FacingAway) continue;
            ++facing;
            wrong += (visibility.back() >= 0.5f) != (exact.back() == 1);
        }
        const auto counts = scoreOfPlanes(planeOf, 3, zones, visibility, exact);
        ASSERT_EQ(counts.size(), 4u);
        std::int64_t samples = 0, misclassified = 0;
        for (const ZoneScore& count : counts) samples += count.samples, misclassified += count.misclassified;
        EXPECT_EQ(samples, facing);
        EXPECT_EQ(misclassified, wrong);
    });
}

} // namespace
} // namespace lixel
