// SPDX-License-Identifier: MIT
#include "lixel/plan/shadow_plan.h"

#include "lixel/plan/fit/focused.h"
#include "lixel/plan/fit/light_frame.h"
#include "lixel/plan/fit/uniform.h"
#include "plan/random_setups.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <map>

namespace lixel {
namespace {

using test::anySetup;
using test::forEachCase;
using test::inputOf;
using test::RandomSetup;
using test::Rng;

bool isInView(const RandomSetup& setup, Vec3d pointLocal)
{
    const Vec4d c = clipFromLocal(setup.view, setup.originWorld) * point(pointLocal);
    return c.w > 0 && std::abs(c.x) <= c.w && std::abs(c.y) <= c.w && std::abs(c.z) <= c.w;
}

// Lit by the cone and range whatever its normal.
bool isReached(const RandomSetup& setup, Vec3d pointLocal)
{
    return isLightFacing(setup.light, setup.originWorld, pointLocal,
                         towardsLight(setup.light, setup.originWorld, pointLocal));
}

// Of the map's square, on the plane one unit before the light (points) or across it (directions): one over the determinant of
// the matrix that takes light-plane coordinates to NDC.
double areaOnLightPlane(const Fit& fit)
{
    const Vec3d x = xyz(fit.lightClipFromLocal.row(0)), y = xyz(fit.lightClipFromLocal.row(1)),
                w = xyz(fit.lightClipFromLocal.row(3));
    return 4 / std::abs(length(w) > 0 ? dot(w, cross(x, y)) : length(cross(x, y)));
}

Vec3d anyPointInScene(const RandomSetup& setup, Rng& rng)
{
    const Box& box = setup.boxesWorld[std::size_t(rng.integer(0, int(setup.boxesWorld.size()) - 1))];
    return Vec3d{rng.uniform(box.min.x, box.max.x), rng.uniform(box.min.y, box.max.y),
                 rng.uniform(box.min.z, box.max.z)} -
           setup.originWorld;
}

// Every receiver in view is inside the map, not beyond its far side, and every caster before it projects to the same place.
void expectCovers(const RandomSetup& setup, const Fit& fit, bool onlyInView, Rng& rng)
{
    int tried = 0;
    for (int i = 0; i < 200 && tried < 20; ++i) {
        const Vec3d p = anyPointInScene(setup, rng);
        if ((onlyInView && !isInView(setup, p)) || !isReached(setup, p)) continue;
        ++tried;
        const Vec4d c = fit.lightClipFromLocal * point(p);
        ASSERT_GT(c.w, 0);
        EXPECT_LE(std::abs(c.x / c.w), 1);
        EXPECT_LE(std::abs(c.y / c.w), 1);
        EXPECT_LE(c.z / c.w, 1);
        const Vec3d caster = p + rng.uniform(0, 0.5) * setup.radius * towardsLight(setup.light, setup.originWorld, p);
        const Vec4d q = fit.lightClipFromLocal * point(caster);
        if (q.w > 1e-6 * c.w) {
            EXPECT_NEAR(q.x / q.w, c.x / c.w, 1e-5 * c.w / q.w);
            EXPECT_NEAR(q.y / q.w, c.y / c.w, 1e-5 * c.w / q.w);
            EXPECT_LE(q.z / q.w, c.z / c.w + 1e-9);
        }
    }
}

void expectCoversOrRefuses(FitResult (*fitOf)(const FitInput&), bool onlyInView, double mostRefused)
{
    std::map<std::string, int> refusals;
    int cases = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        const RandomSetup setup = anySetup(rng);
        const FitResult fit = fitOf(inputOf(setup));
        ++cases;
        if (!fit) {
            ++refusals[std::string(nameOf(fit.error()))];
            return;
        }
        ASSERT_TRUE(isFinite(fit->lightClipFromLocal));
        expectCovers(setup, *fit, onlyInView, rng);
    });
    int refused = 0;
    for (const auto& [reason, count] : refusals) {
        std::printf("%s: %d of %d\n", reason.c_str(), count, cases);
        if (reason != "nothing-in-view") refused += count;
    }
    EXPECT_LE(refused, mostRefused * cases);
}

TEST(Focused, EveryReceiverInViewIsInsideTheMapWithItsCastersBeforeIt) { expectCoversOrRefuses(fitFocused, true, 0.1); }

TEST(Uniform, EveryReceiverIsInsideTheMapWithItsCastersBeforeIt) { expectCoversOrRefuses(fitUniform, false, 0.15); }

TEST(Focused, APointLightInTheVisibleBodyIsRefusedByName)
{
    forEachCase(test::kCases, [](Rng& rng) {
        RandomSetup setup = anySetup(rng);
        setup.light.kind = LightKind::Point;
        setup.light.range = INFINITY;
        const Vec3d p = anyPointInScene(setup, rng);
        if (!isInView(setup, p)) return;
        setup.light.positionWorld = p + setup.originWorld;
        const FitResult fit = fitFocused(inputOf(setup));
        ASSERT_FALSE(fit);
        EXPECT_EQ(fit.error(), FitFailure::ExtentNotInHemisphere);
    });
}

TEST(Focused, IsTheSameMapWhereverTheSceneStands)
{
    forEachCase(test::kCases, [](Rng& rng) {
        RandomSetup here = anySetup(rng);
        RandomSetup there = here;
        const Vec3d by{double(rng.integer(-4096, 4096)), double(rng.integer(-4096, 4096)),
                       double(rng.integer(-4096, 4096))};
        for (Box& box : there.boxesWorld) box = translated(box, by);
        there.view.anchorWorld = there.view.anchorWorld + by;
        there.light.positionWorld = there.light.positionWorld + by;
        there.originWorld = there.originWorld + by;
        const FitResult a = fitFocused(inputOf(here)), b = fitFocused(inputOf(there));
        if (a.hasValue() != b.hasValue() || !a) return; // a body that only touches the view may round either way
        // Rectangles of nearly equal area may change places: compare areas.
        if (here.radius > 1) { // smaller ones keep too few digits 4,096 units away
            EXPECT_NEAR(areaOnLightPlane(*b) / areaOnLightPlane(*a), 1, 1e-5);
        }
    });
}

TEST(Focused, OfAViewOfTheWholeSceneIsNoLargerThanUniform)
{
    forEachCase(test::kCases, [](Rng& rng) {
        RandomSetup setup = anySetup(rng);
        setup.light.kind = LightKind::Directional;
        const FitResult focused = fitFocused(inputOf(setup)), uniform = fitUniform(inputOf(setup));
        if (!focused || !uniform) return;
        EXPECT_LE(areaOnLightPlane(*focused), areaOnLightPlane(*uniform) * (1 + 1e-5));
    });
}

// As a point light in a room sees them; the search for a cone that is not there would otherwise take hours.
TEST(ConeAround, HalfAMillionDirectionsAllAroundHaveNoConeAndAreSoonKnown)
{
    Rng rng(7);
    std::vector<Vec3d> points, room;
    for (int i = 0; i < 500000; ++i) points.push_back(rng.logUniform(0.1, 10) * rng.onSphere());
    EXPECT_LT(coneAround(points, {}, room).cosHalfAngle, 0);
    // One direction behind all others is enough, wherever in the list it stands.
    for (Vec3d& p : points) p.z = std::abs(p.z);
    points[250000] = {0, 0, -1};
    EXPECT_LT(coneAround(points, {}, room).cosHalfAngle, 0.02);
}

TEST(ConeAround, HoldsEveryPointAndNoOtherAxisIsBetter)
{
    forEachCase(test::kCases, [](Rng& rng) {
        std::vector<Vec3d> points;
        const Vec3d apex = rng.inBox(1), towards = rng.onSphere();
        const double spread = rng.logUniform(1e-3, 1);
        Vec3d mean;
        for (int i = rng.integer(1, 30); i > 0; --i) {
            points.push_back(apex + rng.logUniform(0.1, 10) * normalized(towards + spread * rng.inBox(1)));
            mean = mean + normalized(points.back() - apex);
        }
        std::vector<Vec3d> room;
        const DirectionCone cone = coneAround(points, apex, room);
        double leastOfMean = 1;
        for (const Vec3d& p : points) {
            EXPECT_GE(dot(cone.axis, normalized(p - apex)), cone.cosHalfAngle - 1e-12);
            leastOfMean = std::min(leastOfMean, dot(normalized(mean), normalized(p - apex)));
        }
        if (leastOfMean > 0) {
            EXPECT_GE(cone.cosHalfAngle, leastOfMean - 1e-12);
        }
        for (int i = 0; i < 50 && cone.cosHalfAngle > 0; ++i) { // no other axis is better
            const Vec3d other = normalized(cone.axis + rng.logUniform(1e-3, 1) * rng.inBox(1));
            double leastOfOther = 1;
            for (const Vec3d& p : points) leastOfOther = std::min(leastOfOther, dot(other, normalized(p - apex)));
            EXPECT_LE(leastOfOther, cone.cosHalfAngle + 1e-12);
        }
    });
}

} // namespace
} // namespace lixel
