// SPDX-License-Identifier: MIT
#include "lixel/plan/warp/importance.h"

#include "lixel/shared/importance.h"
#include "support/random_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace lixel {
namespace {

using test::forEachCase;
using test::Rng;

const auto kUnit = std::uint32_t(shared::LX_IMPORTANCE_UNIT);

// A floor under a lamp, seen from above by every pixel of a small picture, with a step up to its right half.
struct SteppedFloor
{
    View view = perspectiveView({0, 4, 0.001}, {0, 0, 0}, {0, 0, -1}, 1.0, 0.1, 100, 16, 16);
    Light lamp;
    ViewSamples seen;

    SteppedFloor()
    {
        lamp.kind = LightKind::Point;
        lamp.positionWorld = {0, 8, 0};
        seen.width = seen.height = 16;
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x) {
                seen.pixel.push_back({float(x) + 0.5f, float(y) + 0.5f});
                seen.positionLocal.push_back({float(x - 8) / 8, x < 8 ? 0.0f : 1.0f, float(8 - y) / 8});
                seen.normal.push_back({0, 1, 0});
                seen.triangle.push_back(kNoTriangle);
            }
    }

    std::vector<WeighedSample> weighed(const Importance& importance, const Observation* observed = nullptr) const
    {
        WarpOptions options;
        options.importance = importance;
        ImportanceScratch scratch;
        std::vector<WeighedSample> out;
        weighSamples({view, lamp, {}, &seen, {}, observed, 0}, options, scratch, out);
        return out;
    }
};

TEST(Importance, EverySampleThatFacesTheLightCountsAsOneAndNoOther)
{
    SteppedFloor floor;
    floor.seen.normal[7] = {0, -1, 0};
    const auto weighed = floor.weighed({true, 0, 0});
    ASSERT_EQ(weighed.size(), floor.seen.size() - 1);
    for (const WeighedSample& sample : weighed) EXPECT_EQ(sample.units, kUnit);
}

TEST(Importance, DistanceIsOneAtTheNearestSampleAndFallsAsThePictureShrinksThings)
{
    const SteppedFloor floor;
    const auto weighed = floor.weighed({true, kDistanceWeight, 0});
    std::uint32_t most = 0;
    for (const WeighedSample& sample : weighed) {
        most = std::max(most, sample.units);
        EXPECT_LE(sample.units, kUnit);
    }
    EXPECT_EQ(most, kUnit);
    const auto at = [&](std::size_t i) { return double(weighed[i].units) / kUnit; };
    const double onStep = length(toDouble(floor.seen.positionLocal[8 * 16 + 8]) - Vec3d{0, 4, 0});
    const double below = length(toDouble(floor.seen.positionLocal[8 * 16 + 7]) - Vec3d{0, 4, 0});
    EXPECT_NEAR(at(8 * 16 + 7) / at(8 * 16 + 8), onStep / below, 0.01);
}

TEST(Importance, EdgesAreWhereTheSurfaceBreaksOffBetweenNeighbours)
{
    const SteppedFloor floor;
    const auto weighed = floor.weighed({true, kEdgesWeight, 0});
    const auto away = std::uint32_t(shared::lxImportanceUnits(shared::LX_AWAY_FROM_EDGES));
    for (std::size_t i = 0; i < weighed.size(); ++i) {
        const std::size_t x = i % 16;
        EXPECT_EQ(weighed[i].units, x == 7 || x == 8 ? kUnit : away) << x;
    }
}

TEST(Importance, ProductsAreProductsAndTheGreatestIsTheGreatest)
{
    const SteppedFloor floor;
    const auto edges = floor.weighed({true, kEdgesWeight, 0}), normal = floor.weighed({true, kNormalWeight, 0}),
               both = floor.weighed({true, kEdgesWeight | kNormalWeight, 0}),
               either = floor.weighed({true, 0, kEdgesWeight | kNormalWeight});
    for (std::size_t i = 0; i < edges.size(); ++i) {
        EXPECT_EQ(either[i].units, std::max(edges[i].units, normal[i].units));
        const double product = double(edges[i].units) * normal[i].units / kUnit;
        EXPECT_NEAR(both[i].units, std::max(product, 1.0), 1.01);
    }
}

TEST(Importance, BoundariesAreSoughtWhereTheObservedPictureHadThem)
{
    const SteppedFloor floor;
    Observation observed;
    observed.view = floor.view;
    observed.grid = {16, 16};
    observed.samples = floor.seen;
    // The observed picture saw the floor where its view shows it.
    for (std::size_t i = 0; i < floor.seen.size(); ++i) {
        const Vec3d at = pixelFromLocal(floor.view, {}, toDouble(floor.seen.positionLocal[i]));
        observed.samples.pixel[i] = {float(at.x), float(at.y)};
    }
    observed.lit.assign(floor.seen.size(), 1);
    observed.atBoundary.assign(floor.seen.size(), 0);
    observed.atBoundary[8 * 16 + 2] = 1;
    const auto weighed = floor.weighed({true, kBoundariesWeight, 0}, &observed);
    const auto away = std::uint32_t(shared::lxImportanceUnits(shared::LX_AWAY_FROM_BOUNDARIES));
    EXPECT_EQ(weighed[8 * 16 + 2].units, kUnit);
    EXPECT_EQ(weighed[1 * 16 + 13].units, away);
    // Unknown boundaries leave the greatest of the others.
    const auto edges = floor.weighed({true, kEdgesWeight, 0}),
               either = floor.weighed({true, 0, kEdgesWeight | kBoundariesWeight});
    for (std::size_t i = 0; i < edges.size(); ++i) EXPECT_EQ(either[i].units, edges[i].units);
    // Of another light, and without an observation, nothing is known and all count alike.
    for (const WeighedSample& sample : floor.weighed({true, kBoundariesWeight, 0})) EXPECT_EQ(sample.units, kUnit);
}

TEST(Importance, MapsHoldAllThatWasCountedInAnyOrder)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const int columns = rng.integer(1, 40), rows = rng.integer(1, 40);
        std::vector<PlacedSample> samples;
        for (int i = rng.integer(0, 500); i > 0; --i)
            samples.push_back({float(rng.uniform(0, 1)), float(rng.uniform(0, 1)), std::uint32_t(rng.integer(1, 300))});
        std::vector<std::uint32_t> map, again;
        countSamples(samples, columns, rows, true, map);
        std::reverse(samples.begin(), samples.end());
        countSamples(samples, columns, rows, true, again);
        EXPECT_EQ(map, again);
        std::uint64_t all = 0;
        for (const PlacedSample& sample : samples) all += sample.units;
        EXPECT_EQ(std::accumulate(map.begin(), map.end(), std::uint64_t{0}), all);
        countSamples(samples, columns, rows, false, again);
        for (std::size_t i = 0; i < map.size(); ++i) EXPECT_LE(again[i], map[i]);
    });
}

// 16 bits, which the paper proposes to save memory, would overflow.
TEST(Importance, AMillionSamplesFitIntoOneLixel)
{
    const std::vector<PlacedSample> samples(1u << 20, PlacedSample{0.3f, 0.6f, kUnit});
    std::vector<std::uint32_t> map;
    countSamples(samples, 4, 4, true, map);
    EXPECT_EQ(map[2 * 4 + 1], (1u << 20) * kUnit);
}

} // namespace
} // namespace lixel
