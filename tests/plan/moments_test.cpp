// SPDX-License-Identifier: MIT
#include "lixel/shared/lookup/moments.h"

#include "lixel/plan/lookup/lookup.h"
#include "plan/lookup_maps.h"
#include "support/random_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace lixel {
namespace {

using namespace test;

constexpr std::array kStores{"vsm", "evsm2", "evsm4", "msm"};

shared::LxLookup howOf(const std::string& text)
{
    return lookupLayout(std::get<MapTechnique>(*parseTechnique(text))).how;
}

// Depths of 1 near to 0 far.
shared::vec4 meanMoments(const shared::LxLookup& how, const std::vector<float>& depths)
{
    shared::vec4 sum;
    for (const float depth : depths) sum = sum + shared::lxMomentsOf(how, depth);
    return (1.0f / float(depths.size())) * sum;
}

TEST(Moments, NeverLetLessLightThroughThanThereIs)
{
    forEachCase(kCases, [](Rng& rng) {
        std::vector<float> depths;
        const double low = rng.uniform(0, 0.9), high = rng.uniform(low, 1);
        for (int i = rng.integer(1, 25); i > 0; --i)
            depths.push_back(float(rng.chance(0.3) ? low : rng.uniform(low, high)));
        const auto receiver = float(rng.uniform(0, 1));
        const auto lit = [&](float depth) { return depth <= receiver + 1e-6f; };
        const double share = double(std::count_if(depths.begin(), depths.end(), lit)) / double(depths.size());
        for (const char* store : kStores) {
            const shared::LxLookup how = howOf(store);
            EXPECT_GE(shared::lxLitByMoments(how, meanMoments(how, depths), receiver), share - 2e-3) << store;
        }
    });
}

// Where there are two depths, the nearer with some share, their bounds are the share itself: of Chebyshev's at the farther one, of four
// moments anywhere between.
TEST(Moments, AreExactForTwoDepths)
{
    forEachCase(kCases, [](Rng& rng) {
        const int all = rng.integer(2, 25), near = rng.integer(1, all - 1);
        const auto far = float(rng.uniform(0, 0.6));
        const float nearer = far + float(rng.uniform(0.1, 0.35));
        std::vector<float> depths(std::size_t(all), far);
        std::fill_n(depths.begin(), near, nearer);
        const float share = 1 - float(near) / float(all);
        EXPECT_NEAR(shared::lxLitByMoments(howOf("vsm"), meanMoments(howOf("vsm"), depths), far), share, 2e-3);
        EXPECT_NEAR(shared::lxLitByMoments(howOf("evsm2"), meanMoments(howOf("evsm2"), depths), far), share, 2e-3);
        const float between = far + float(rng.uniform(0.2, 0.8)) * (nearer - far);
        // The replaced share a of four moments puts a E[q^2] / q(z)^2 at z, where q has the two depths as roots and E[q^2] of an even
        // spread is 16/5 at most.
        const float q = 4 * (between - far) * (nearer - between);
        EXPECT_NEAR(shared::lxLitByMoments(howOf("msm"), meanMoments(howOf("msm"), depths), between), share,
                    2e-3f + 3.2f * shared::LX_MOMENT_BIAS / (q * q));
    });
}

// Depths of bodies between the light and a floor, where a spot with a far side 100 times its near one has them.
TEST(Moments, UnderALampWhatIsMidwayShadowsTheFloor)
{
    shared::ShadowRegion region = plainRegion();
    region.projection.z = 1 - 1 / 100.0f;
    const auto depthAt = [](float distance) { return (100 / distance - 1) / 99; }; // 1 at a distance of 1, 0 at 100
    for (const char* store : kStores) {
        const float caster = depthAt(45), floor = depthAt(90);
        const auto map = [&](int x, int, int) { return x < 16 ? caster : floor; };
        const auto litAt = [&](float x) {
            return litBy(howOf(store), region, shared::lxReceive(region, {x, 0, floor}, {0, 0, 1}), map);
        };
        EXPECT_LT(litAt(-0.5f), 0.05f) << store;
        EXPECT_GT(litAt(0.5f), 0.95f) << store;
    }
}

TEST(Moments, APlaneAloneIsLit)
{
    forEachCase(kCases, [](Rng& rng) {
        const shared::LxLookup how =
            howOf(std::string(kStores[std::size_t(rng.integer(0, 3))]) + (rng.chance(0.5) ? "(5)" : ""));
        const double slope = rng.logUniform(1e-4, 0.02), angle = rng.uniform(0, 6.28);
        const double gx = slope * std::cos(angle), gy = slope * std::sin(angle);
        const double middle = rng.uniform(0.2, 0.8);
        shared::ShadowRegion region = plainRegion();
        region.projection.z = rng.chance(0.5) ? 0.0f : float(1 - rng.logUniform(1e-3, 1));
        const auto plane = [&](int x, int y, int) { return float(middle + gx * (x + 0.5 - 16) + gy * (y + 0.5 - 16)); };
        const double x = rng.uniform(-0.4, 0.4), y = rng.uniform(-0.4, 0.4); // of NDC: 8 lixels a unit
        const Vec3d n = normalized(Vec3d{-8 * gx, -8 * gy, 1});
        const auto r = shared::lxReceive(region, {float(x), float(y), float(middle + 8 * gx * x + 8 * gy * y)},
                                         {float(n.x), float(n.y), float(n.z)});
        EXPECT_GT(litBy(how, region, r, plane), 0.98f)
            << "bend " << region.projection.z << " store " << how.store << " slope " << slope;
    });
}

} // namespace
} // namespace lixel
