// SPDX-License-Identifier: MIT
#include "lixel/plan/lookup/lookup.h"
#include "plan/lookup_maps.h"
#include "support/random_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

// C. Pagot, J. Comba, M. Oliveira. Multiple-Depth Shadow Maps. 2004, sections 2.2 and 4. The paper's depths grow away from the light.
namespace lixel {
namespace {

using namespace test;

shared::LxLookup howOf(const std::string& text)
{
    return lookupLayout(std::get<MapTechnique>(*parseTechnique(text))).how;
}

// A receiver that faces the light, amidst the plain region, at a depth of 0 to 100.
shared::LxReceiver receiverAt(double depth, shared::vec3 normal = {0, 0, 1})
{
    return shared::lxReceive(plainRegion(), {0.01f, 0.01f, float(1 - depth / 100)}, normal);
}

// A map of its depths of 0 to 100 around the receiver, row by row; what is beyond is as far as can be.
template <std::size_t N>
auto mapOf(const std::array<double, N>& depths)
{
    const int side = int(std::lround(std::sqrt(double(N))));
    return [depths, side](int x, int y, int) {
        const int i = x - 16 + side / 2, j = y - 16 + side / 2;
        return i >= 0 && i < side && j >= 0 && j < side ? float(1 - depths[std::size_t(j * side + i)] / 100) : 0.0f;
    };
}

TEST(MultipleDepths, Figure2NineTapsOfWhichFiveShadow)
{
    const auto map = mapOf<9>({50.2, 50.0, 50.0, 50.1, 1.2, 1.1, 1.3, 1.4, 1.2});
    EXPECT_FLOAT_EQ(1 - litByPcf(plainRegion(), receiverAt(49.8), 3, map), 5.0f / 9);
}

// With two depths a lixel is lit, half in shadow, or in shadow.
TEST(MultipleDepths, Figure4TwoDepthsDecideBetweenThreeShades)
{
    const auto map = mapOf<9>({60, 60, 60, 60, 20, 60, 60, 60, 60});
    const shared::LxLookup how = howOf("depths(2,max)");
    EXPECT_EQ(litBy(how, plainRegion(), receiverAt(10), map), 1.0f);
    EXPECT_EQ(litBy(how, plainRegion(), receiverAt(40), map), 0.5f);
    EXPECT_EQ(litBy(how, plainRegion(), receiverAt(80), map), 0.0f);
}

// By the words of section 4.2, a depth d behind the nearest of all, Z_n, is all in shadow, whatever the others are. By the count of those
// before it, of depths .9, .5 and .2 one shadows d = .3.
TEST(MultipleDepths, TheShareIsTheNumberOfNearerDepthsNotWhetherOneIs)
{
    const auto map = mapOf<9>({50, 50, 20, 50, 50, 50, 50, 50, 90});
    EXPECT_FLOAT_EQ(1 - litBy(howOf("depths(3,minmax)"), plainRegion(), receiverAt(30), map), 1.0f / 3);
}

// A map of random steps that 16 bits hold exactly: 65535 is 15 times 4369.
struct RandomMap
{
    std::array<float, 16 * 16> depths{};
    explicit RandomMap(Rng& rng)
    {
        const int levels = rng.integer(1, 12);
        for (float& depth : depths) depth = float(rng.integer(0, levels)) / 15;
    }
    float operator()(int x, int y, int) const
    {
        EXPECT_TRUE(x >= 8 && x < 24 && y >= 8 && y < 24);
        return depths[std::size_t((y - 8) * 16 + x - 8)];
    }
};

shared::LxReceiver anyReceiver(Rng& rng)
{
    const auto at = [&] { return float(rng.uniform(-1, 1)); };
    const Vec3d n = normalized(Vec3d{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.logUniform(0.05, 20)});
    return shared::lxReceive(plainRegion(), {at(), at(), float(rng.uniform(0.03, 0.97))},
                             {float(n.x), float(n.y), float(n.z)});
}

const std::vector<std::string> kDepthStores{
    "depths(2,max)", "depths(2,min)",  "depths(3)",          "depths(4)",      "depths(5)",        "depths(6,q=25)",
    "depths(7)",     "depths(8,q=25)", "depths(2,min,q=25)", "depths(4,q=25)", "depths(4,bits=16)"};
const std::vector<std::string> kKernels{"pcf(1)",  "pcf(4)",         "pcf(9)",          "pcf(16)",
                                        "pcf(25)", "pcf(9,rotated)", "pcf(16,jittered)"};

template <typename T>
const T& anyOf(const std::vector<T>& all, Rng& rng)
{
    return all[std::size_t(rng.integer(0, int(all.size()) - 1))];
}

// Whether all lixels of the neighbourhood of every tap, each at its own place, say the same.
bool doAllAgree(const shared::LxLookup& how, const shared::LxReceiver& r, const RandomMap& map, shared::uint seed)
{
    const shared::ShadowRegion region = plainRegion();
    std::set<bool> verdicts;
    for (int tap = 0; tap < how.side * how.side; ++tap) {
        const shared::vec2 offset = shared::lxTap(how, tap % how.side, tap / how.side, seed);
        const shared::vec2 corner = shared::lxCornerWithin(how, region, r.lixel.x + offset.x, r.lixel.y + offset.y);
        for (int j = -how.around; j <= how.around; ++j)
            for (int i = -how.around; i <= how.around; ++i) {
                const int x = int(corner.x) + i, y = int(corner.y) + j;
                if (x < 8 || y < 8 || x >= 24 || y >= 24) continue;
                verdicts.insert(map(x, y, 0) > shared::lxShadowingDepth(r, {float(x) + 0.5f, float(y) + 0.5f}));
            }
    }
    return verdicts.size() == 1;
}

// As sections 2.1 and 2.2 have it: the share of the taps whose lixel is no nearer to the light than the receiver's plane is there.
TEST(MultipleDepths, OneDepthIsTheClassicTest)
{
    std::set<float> outcomes;
    forEachCase(kCases, [&](Rng& rng) {
        const std::string kernel = anyOf(kKernels, rng);
        const shared::LxLookup one = howOf("depths(1)+" + kernel);
        EXPECT_EQ(toString(*parseTechnique("depths(1)+" + kernel)), toString(*parseTechnique(kernel)));
        const RandomMap map(rng);
        const shared::LxReceiver r = anyReceiver(rng);
        const auto seed = shared::uint(rng.integer(0, 1 << 30));
        int lit = 0;
        for (int tap = 0; tap < one.side * one.side; ++tap) {
            const shared::vec2 offset = shared::lxTap(one, tap % one.side, tap / one.side, seed);
            const int x = std::clamp(int(std::floor(r.lixel.x + offset.x)), 8, 23);
            const int y = std::clamp(int(std::floor(r.lixel.y + offset.y)), 8, 23);
            lit += map(x, y, 0) <= shared::lxShadowingDepth(r, {float(x) + 0.5f, float(y) + 0.5f});
        }
        const float share = litBy(one, plainRegion(), r, map, seed);
        EXPECT_FLOAT_EQ(share, float(lit) / float(one.side * one.side)) << kernel;
        outcomes.insert(share);
    });
    EXPECT_GT(outcomes.size(), 30u);
}

TEST(MultipleDepths, MoreDepthsChangeNothingWhereAllNeighboursAgree)
{
    int agreeing = 0;
    forEachCase(kCases, [&](Rng& rng) {
        const std::string kernel = anyOf(kKernels, rng);
        const shared::LxLookup how = howOf(anyOf(kDepthStores, rng) + "+" + kernel), one = howOf(kernel);
        const RandomMap map(rng);
        const shared::LxReceiver r = anyReceiver(rng);
        const auto seed = shared::uint(rng.integer(0, 1 << 30));
        if (!doAllAgree(how, r, map, seed)) return;
        ++agreeing;
        EXPECT_EQ(litBy(how, plainRegion(), r, map, seed), litBy(one, plainRegion(), r, map, seed));
    });
    EXPECT_GT(agreeing, scaled(kCases) / 50);
}

TEST(MultipleDepths, TheFarthestNeverDarkensAndTheNearestNeverLightens)
{
    forEachCase(kCases, [](Rng& rng) {
        const std::string kernel = anyOf(kKernels, rng), q = rng.chance(0.5) ? ",q=25" : "";
        const RandomMap map(rng);
        const shared::LxReceiver r = anyReceiver(rng);
        const float one = litBy(howOf(kernel), plainRegion(), r, map, 7);
        EXPECT_GE(litBy(howOf("depths(2,max" + q + ")+" + kernel), plainRegion(), r, map, 7), one);
        EXPECT_LE(litBy(howOf("depths(2,min" + q + ")+" + kernel), plainRegion(), r, map, 7), one);
    });
}

TEST(MultipleDepths, TheOrderInWhichDepthsAreStoredIsNothing)
{
    forEachCase(kCases, [](Rng& rng) {
        const std::string store =
            anyOf<std::string>({"depths(3)", "depths(3,q=25)", "depths(4)", "depths(4,q=25)"}, rng);
        const shared::LxLookup how = howOf(store + "+" + anyOf(kKernels, rng));
        const RandomMap map(rng);
        const shared::LxReceiver r = anyReceiver(rng);
        struct Shuffled : FunctionMap<RandomMap>
        {
            std::vector<int> order; // of all but the lixel's own, which comes first
            shared::LxWords words(int x, int y, int layer) const
            {
                shared::LxWords sorted = FunctionMap<RandomMap>::words(x, y, layer), out = sorted;
                for (std::size_t i = 0; i < order.size(); ++i) out.words[i + 1] = sorted.words[order[i]];
                return out;
            }
        };
        Shuffled shuffled{{how, plainRegion().rectangle, 0, map}, {}};
        for (int i = 1; i < how.depths; ++i) shuffled.order.push_back(i);
        for (int i = how.depths - 2; i > 0; --i)
            std::swap(shuffled.order[std::size_t(i)], shuffled.order[std::size_t(rng.integer(0, i))]);
        EXPECT_EQ(shared::lxVisibility(how, plainRegion(), r, 7u, shuffled), litBy(how, plainRegion(), r, map, 7));
    });
}

// Table 1: n k + 1.
TEST(MultipleDepths, OutcomesAreSharesOfNTimesKAndAllAreReached)
{
    for (const char* store : {"depths(1)", "depths(2,max)", "depths(2,min)", "depths(3)", "depths(4)", "depths(8)"})
        for (const int side : {1, 2, 3}) {
            const shared::LxLookup how = howOf(std::string(store) + "+pcf(" + std::to_string(side * side) + ")");
            const int most = how.depths * side * side;
            std::set<int> outcomes;
            forEachCase(4000, [&](Rng& rng) {
                RandomMap map(rng);
                const double share = rng.uniform(0, 1); // of lixels before the receiver
                for (float& depth : map.depths)
                    depth = rng.chance(share) ? float(rng.uniform(0.6, 0.9)) : float(rng.uniform(0.1, 0.4));
                const float lit = litBy(how, plainRegion(), receiverAt(50), map);
                const int outcome = int(std::lround(lit * float(most)));
                EXPECT_NEAR(lit * float(most), float(outcome), 1e-4);
                outcomes.insert(outcome);
            });
            EXPECT_LE(int(outcomes.size()), most + 1);
            if (how.depths <= 3) {
                EXPECT_EQ(int(outcomes.size()), most + 1) << store << " " << side;
            }
        }
}

TEST(MultipleDepths, StoredDepthsAreNeverNearerThanTheyWereAndNearlyAsFar)
{
    forEachCase(kCases, [](Rng& rng) {
        std::array<float, 256> depths{};
        for (float& depth : depths) depth = rng.chance(0.1) ? 0.0f : float(rng.logUniform(1e-4, 1));
        const auto map = [&](int x, int y, int) { return depths[std::size_t((y - 8) * 16 + x - 8)]; };
        const shared::LxLookup how = howOf(anyOf(kDepthStores, rng));
        const int x = rng.integer(8, 23), y = rng.integer(8, 23);
        const float bend = rng.chance(0.5) ? 0.0f : float(1 - rng.logUniform(1e-6, 1));
        const FunctionMap<decltype(map)> lixels{how, plainRegion().rectangle, bend, map};
        const shared::LxWords words = lixels.words(x, y, 0);
        std::set<int> places;
        shared::uint left = shared::lxPlacesOf(how, words);
        for (int i = 0; i < how.depths; ++i) {
            const shared::LxStored stored = shared::lxStoredAt(how, bend, words, i, left);
            if (i > 0) left &= left - 1;
            if (how.store == shared::LX_STORE_DEPTHS16 && i > 0 && stored.place == shared::kLxOwnPlace) continue;
            const shared::vec2 offset = shared::lxOffsetOfPlace(stored.place);
            const float depth = map(x + int(offset.x), y + int(offset.y), 0);
            EXPECT_LE(stored.depth, depth);
            if (how.store == shared::LX_STORE_DEPTHS16) {
                EXPECT_GE(shared::lxEvenDepth(bend, stored.depth), shared::lxEvenDepth(bend, depth) - 1.03f / 65535);
            } else {
                EXPECT_GE(stored.depth, depth - depth / 262144);
            }
            EXPECT_LE(std::max(std::abs(offset.x), std::abs(offset.y)), float(how.around));
            places.insert(stored.place);
        }
        EXPECT_TRUE(places.contains(shared::kLxOwnPlace));
        const bool isAmidst = x >= 10 && y >= 10 && x < 22 && y < 22;
        if (isAmidst && how.selection == shared::LX_SELECT_SORTED) {
            EXPECT_EQ(int(places.size()), how.depths);
        }
    });
}

TEST(MultipleDepths, SortedDepthsHaveEqualNumbersOfNeighboursBetweenThem)
{
    // Nine lixels at depths 1 to 9, the middle one nearest: of four groups (1 2) (3 4) (5 6) (7 8 9) its own stands for the first.
    const auto map = mapOf<9>({9, 2, 8, 3, 1, 7, 4, 6, 5});
    const shared::LxLookup how = howOf("depths(4)");
    const FunctionMap<std::decay_t<decltype(map)>> lixels{how, plainRegion().rectangle, 0, map};
    const shared::LxWords words = lixels.words(16, 16, 0);
    std::set<int> depths;
    for (int i = 0; i < 4; ++i)
        depths.insert(int(std::lround(100 - 100 * shared::lxStoredAt(how, 0, words, i, 0).depth)));
    EXPECT_EQ(depths, (std::set<int>{1, 3, 5, 8}));
}

} // namespace
} // namespace lixel
