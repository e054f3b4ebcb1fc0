// SPDX-License-Identifier: MIT
#include "lixel/plan/partition/cascades.h"
#include "lixel/plan/partition/cube.h"
#include "lixel/plan/shadow_plan.h"
#include "plan/ordinary_setups.h"
#include "plan/receivers.h"

#include <gtest/gtest.h>

namespace lixel {
namespace {

using test::forEachCase;
using test::inputOf;
using test::ordinarySetup;
using test::planOf;
using test::RandomSetup;
using test::Rng;

bool holds(const CellPlanes& planes, Vec3d p)
{
    return std::all_of(planes.begin(), planes.end(), [&](const Plane& plane) { return plane.signedDistance(p) >= 0; });
}

TEST(Pssm, OneCascadeIsThePlainFit)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const RandomSetup setup = ordinarySetup(rng);
        for (const char* fit : {"focused", "lispsm", "tsm", "psm"}) {
            const FramePlan one = planOf(setup, (std::string("pssm(1)+") + fit).c_str()), plain = planOf(setup, fit);
            ASSERT_EQ(one.regionTable.size(), plain.regionTable.size());
            EXPECT_TRUE(one.halfSpaceTable.empty());
            for (std::size_t i = 0; i < plain.lights[0].regions.size(); ++i) {
                EXPECT_EQ(one.lights[0].regions[i].lightClipFromLocal, plain.lights[0].regions[i].lightClipFromLocal);
                EXPECT_EQ(one.lights[0].regions[i].rectangle, plain.lights[0].regions[i].rectangle);
            }
        }
    });
}

TEST(Pssm, SplitsGoFromEvenToLogarithmic)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const RandomSetup setup = ordinarySetup(rng);
        const FitInput input = inputOf(setup);
        const ViewDepth depth = viewDepth(setup.view, setup.originWorld);
        const auto splitsOf = [&](double lambda) {
            const CellsResult cells = splitPssm(input, 4, lambda);
            std::vector<double> splits;
            if (!cells) return splits;
            for (const Cell& cell : *cells)
                for (const Plane& plane : cell.servesLocal) splits.push_back(depth.offset + plane.offset);
            return splits;
        };
        const std::vector<double> even = splitsOf(0), practical = splitsOf(0.5), logarithmic = splitsOf(1);
        if (even.empty()) return;
        ASSERT_EQ(even.size(), 3u);
        EXPECT_NEAR(even[2] - even[1], even[1] - even[0], 1e-9 * even[2]);
        EXPECT_NEAR(logarithmic[2] / logarithmic[1], logarithmic[1] / logarithmic[0], 1e-9);
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(practical[i], 0.5 * (even[i] + logarithmic[i]), 1e-9 * even[2]);
    });
}

TEST(Sdsm, SplitsAreLogarithmicBetweenTheDepthsOfTheSamples)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const RandomSetup setup = ordinarySetup(rng);
        FitInput input = inputOf(setup);
        const ViewDepth depth = viewDepth(setup.view, setup.originWorld);
        std::vector<Vec3d> seen;
        double near = INFINITY, far = 0;
        for (int i = 0; i < 10; ++i) {
            const double z = rng.logUniform(0.5, 100);
            const Vec3d eye = setup.view.anchorWorld - setup.originWorld;
            seen.push_back(eye + z * depth.forward + cross(depth.forward, rng.inBox(1)));
            near = std::min(near, depth.of(seen.back()));
            far = std::max(far, depth.of(seen.back()));
        }
        input.hasViewSamples = true;
        input.seenLocal = seen;
        const CellsResult cells = splitSdsm(input, 3);
        ASSERT_TRUE(cells);
        ASSERT_EQ(cells->size(), 3u);
        for (std::size_t i = 0; i < 2; ++i)
            EXPECT_NEAR(depth.offset + (*cells)[i].servesLocal[0].offset,
                        near * std::pow(far / near, double(i + 1) / 3), 1e-9 * far);
        EXPECT_EQ(splitSdsm(inputOf(setup), 3).error(), FitFailure::NoViewSamples);
    });
}

TEST(Cube, EveryDirectionBelongsToOneFaceAndEveryFaceHoldsWhatItServes)
{
    forEachCase(test::kCases, [](Rng& rng) {
        RandomSetup setup = ordinarySetup(rng);
        setup.light.kind = rng.chance(0.5) ? LightKind::Point : LightKind::Spot;
        const CellsResult cells = splitCube(inputOf(setup));
        ASSERT_TRUE(cells);
        ASSERT_EQ(cells->size(), 6u);
        for (int i = 0; i < 20; ++i) {
            const Vec3d p = setup.light.positionWorld - setup.originWorld + rng.logUniform(0.1, 100) * rng.onSphere();
            int serving = 0;
            for (const Cell& cell : *cells) {
                serving += holds(cell.servesLocal, p);
                EXPECT_TRUE(!holds(cell.servesLocal, p) || holds(cell.holdsLocal, p));
            }
            EXPECT_EQ(serving, 1);
        }
    });
}

TEST(Cube, OfDirectionalLightsIsOneRegion)
{
    forEachCase(test::kCases, [](Rng& rng) {
        RandomSetup setup = ordinarySetup(rng);
        setup.light.kind = LightKind::Directional;
        const FramePlan cube = planOf(setup, "cube"), whole = planOf(setup, "focused");
        ASSERT_EQ(cube.lights[0].regions.size(), whole.lights[0].regions.size());
        if (!whole.lights[0].regions.empty()) {
            EXPECT_EQ(cube.lights[0].regions[0].lightClipFromLocal, whole.lights[0].regions[0].lightClipFromLocal);
        }
    });
}

} // namespace
} // namespace lixel
