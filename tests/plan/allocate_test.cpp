// SPDX-License-Identifier: MIT
#include "lixel/plan/allocate.h"

#include "support/random_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace lixel {
namespace {

using test::forEachCase;
using test::Rng;

std::int64_t areaOf(const LixelRectangle& r) { return std::int64_t(r.width()) * r.height(); }

bool overlap(const LixelRectangle& a, const LixelRectangle& b)
{
    return a.layer == b.layer && a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

TEST(CutRectangle, PiecesFillTheWholeWithoutOverlapAndHaveAboutTheirShares)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const int most = rng.chance(0.5) ? 2000 : 7;
        const LixelRectangle whole{3, 5, 3 + rng.integer(1, most), 5 + rng.integer(1, most), 1};
        std::vector<double> shares(std::size_t(rng.integer(1, 32)));
        for (double& share : shares) share = rng.uniform(0.05, 1);
        const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
        std::vector<LixelRectangle> pieces(shares.size());
        const bool hasRoom = areaOf(whole) >= std::int64_t(shares.size());
        const bool isCut = cutRectangle(whole, shares, pieces);
        EXPECT_EQ(isCut, hasRoom);
        if (!isCut) return;
        std::int64_t filled = 0;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const LixelRectangle& p = pieces[i];
            EXPECT_TRUE(p.x0 >= whole.x0 && p.y0 >= whole.y0 && p.x1 <= whole.x1 && p.y1 <= whole.y1 && p.layer == 1);
            EXPECT_GE(areaOf(p), 1);
            filled += areaOf(p);
            for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(p, pieces[j]));
            if (whole.width() > 500 && whole.height() > 500) {
                EXPECT_NEAR(double(areaOf(p)) / double(areaOf(whole)) / (shares[i] / sum), 1, 0.1);
            }
        }
        EXPECT_EQ(filled, areaOf(whole));
    });
}

TEST(SharesByNeed, NoOtherSharesHaveALowerPredictedError)
{
    forEachCase(test::kCases, [](Rng& rng) {
        std::vector<double> needs(std::size_t(rng.integer(1, 8)));
        for (double& need : needs) need = rng.logUniform(0.3, 3);
        std::vector<double> shares = needs;
        sharesByNeed(shares);
        EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1, 1e-12);
        const auto errorOf = [&](const std::vector<double>& s) {
            double sum = 0;
            for (std::size_t i = 0; i < s.size(); ++i) sum += needs[i] / std::sqrt(s[i]);
            return sum;
        };
        for (int i = 0; i < 20; ++i) {
            std::vector<double> other = shares;
            for (double& s : other) s *= std::exp(rng.uniform(-0.3, 0.3));
            const double sum = std::accumulate(other.begin(), other.end(), 0.0);
            for (double& s : other) s /= sum;
            EXPECT_LE(errorOf(shares), errorOf(other) * (1 + 1e-12));
        }
    });
}

TEST(SharesByNeed, AreEvenWhereNoNeedIsKnownAndNoneIsStarved)
{
    std::vector<double> none(4, 0.0), one{1e9, 0, 0, 0};
    sharesByNeed(none);
    sharesByNeed(one);
    for (const double share : none) EXPECT_EQ(share, 0.25);
    for (const double share : one) EXPECT_GT(share, 0.25 / 40);
}

TEST(PackRectangles, GivenSizesDoNotOverlapAndAreAboutAsWideAsHigh)
{
    forEachCase(test::kCases, [](Rng& rng) {
        std::vector<LixelSize> sizes(std::size_t(rng.integer(1, 20)));
        for (LixelSize& size : sizes) size = {rng.integer(1, 500), rng.integer(1, 500)};
        std::vector<LixelRectangle> rectangles(sizes.size());
        const LixelSize used = packRectangles(sizes, 2, rectangles);
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            EXPECT_EQ(rectangles[i].width(), sizes[i].width);
            EXPECT_EQ(rectangles[i].height(), sizes[i].height);
            EXPECT_TRUE(rectangles[i].x0 >= 0 && rectangles[i].y0 >= 0 && rectangles[i].x1 <= used.width &&
                        rectangles[i].y1 <= used.height && rectangles[i].layer == 2);
            for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(rectangles[i], rectangles[j]));
        }
    });
}

} // namespace
} // namespace lixel
