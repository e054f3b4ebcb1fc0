// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/psm.h"

#include "lixel/plan/fit/along_view.h"
#include "lixel/plan/fit/focused.h"
#include "lixel/plan/fit/visible_body.h"
#include "plan/ordinary_setups.h"

#include <gtest/gtest.h>

namespace lixel {
namespace {

using test::forEachCase;
using test::inputOf;
using test::ordinarySetup;
using test::RandomSetup;
using test::Rng;

// How far two rows are from being multiples of each other, against their lengths.
double differenceInDirection(Vec4d a, Vec4d b)
{
    const Vec4d unitA = (1 / std::sqrt(dot(a, a))) * a, unitB = (1 / std::sqrt(dot(b, b))) * b;
    const Vec4d apart = dot(a, b) < 0 ? unitA + unitB : unitA - unitB;
    return std::sqrt(dot(apart, apart));
}

// A light of its kind that comes from behind the viewer (1), from in front (-1) or from the plane through the eye (0), above the floor.
void bringLight(RandomSetup& setup, int from, Rng& rng)
{
    const Vec3d forward = viewDepth(setup.view, setup.originWorld).forward;
    Vec3d aside = normalized(cross(forward, {0, 1, 0}));
    aside = normalized(rng.uniform(-1, 1) * aside + rng.uniform(0.2, 1) * cross(aside, forward));
    const double along = from * rng.uniform(0.1, 0.8);
    const Vec3d towards = normalized(std::sqrt(1 - along * along) * aside - along * forward);
    setup.light.directionWorld = -towards;
    if (setup.light.kind != LightKind::Directional)
        setup.light.positionWorld = setup.view.anchorWorld + rng.uniform(5, 50) * towards;
    if (setup.light.kind == LightKind::Spot) // at a place before the camera
        setup.light.directionWorld =
            normalized(setup.view.anchorWorld + rng.uniform(2, 15) * forward - setup.light.positionWorld);
}

bool isPerspective(const Fit& fit) { return length(xyz(fit.lightClipFromLocal.row(3))) > 0; }

// After the view's perspective the eye lies at infinity, and so does a light there: the map is a parallel one across the line of
// sight, hence each lixel the same number of pixels large.
TEST(Psm, UnderTheMinersLampTheLightImageIsParallelToTheViewers)
{
    forEachCase(test::kCases, [](Rng& rng) {
        RandomSetup setup = ordinarySetup(rng);
        setup.light.kind = LightKind::Point;
        setup.light.range = INFINITY;
        setup.light.positionWorld = setup.view.anchorWorld;
        const FitResult fit = fitPsm(inputOf(setup), PsmShift::None);
        if (!fit) return;
        const Mat4d view = clipFromLocal(setup.view, setup.originWorld);
        EXPECT_LT(differenceInDirection(fit->lightClipFromLocal.row(3), view.row(3)), 1e-9);
        std::vector<Vec3d> points;
        findVisiblePoints(inputOf(setup), points);
        // Pixels to lixels is one affine map: found from three points, it holds for the others.
        const auto pixel = [&](std::size_t i) { return pixelFromLocal(setup.view, setup.originWorld, points[i]); };
        const auto lixel = [&](std::size_t i) { return project(fit->lightClipFromLocal, points[i]); };
        const Vec3d p0 = pixel(0), l0 = lixel(0);
        for (std::size_t a = 1; a + 2 < points.size(); ++a) {
            const Vec3d p1 = pixel(a) - p0, p2 = pixel(a + 1) - p0, q = pixel(a + 2) - p0;
            const double area = p1.x * p2.y - p1.y * p2.x;
            if (std::abs(area) < 100) continue;
            const double s = (q.x * p2.y - q.y * p2.x) / area, t = (p1.x * q.y - p1.y * q.x) / area;
            if (std::abs(s) + std::abs(t) > 100) continue;
            const Vec3d expected = l0 + s * (lixel(a) - l0) + t * (lixel(a + 1) - l0), found = lixel(a + 2);
            EXPECT_NEAR(found.x, expected.x, 1e-6);
            EXPECT_NEAR(found.y, expected.y, 1e-6);
        }
    });
}

// A light in the plane through the eye is at infinity after the perspective; one a little before or behind it is nearly the same.
TEST(Psm, NothingHappensAsALightPassesFromBeforeTheViewerToBehind)
{
    forEachCase(test::kCases, [](Rng& rng) {
        RandomSetup setup = ordinarySetup(rng);
        const ViewDepth depth = viewDepth(setup.view, setup.originWorld);
        setup.light.kind = LightKind::Directional;
        Vec3d aside = rng.onSphere();
        aside.y = std::abs(aside.y) + 0.2;
        aside = normalized(aside - dot(aside, depth.forward) * depth.forward);
        const auto fitFrom = [&](double forward) {
            setup.light.directionWorld = -normalized(aside + forward * depth.forward);
            return fitPsm(inputOf(setup), PsmShift::None);
        };
        const FitResult before = fitFrom(1e-9), exactly = fitFrom(0), behind = fitFrom(-1e-9);
        if (!before || !exactly || !behind) return;
        std::vector<Vec3d> points;
        findVisiblePoints(inputOf(setup), points);
        const DepthSpan depths = seenDepths(inputOf(setup), depth, points);
        if (depths.farthest < 1.01 * depths.nearest) return; // a sliver, narrower than floats resolve
        // Rectangles of equal area may change places; areas in the map do not.
        const auto areas = [&](const FitResult& fit) {
            double sum = 0;
            for (std::size_t i = 0; i + 2 < points.size(); ++i) {
                const Vec3d a = project(fit->lightClipFromLocal, points[i]),
                            b = project(fit->lightClipFromLocal, points[i + 1]) - a,
                            c = project(fit->lightClipFromLocal, points[i + 2]) - a;
                sum += std::abs(b.x * c.y - b.y * c.x);
            }
            return sum;
        };
        EXPECT_NEAR(areas(before) / areas(exactly), 1, 1e-4);
        EXPECT_NEAR(areas(behind) / areas(exactly), 1, 1e-4);
    });
}

TEST(Psm, WhereverTheLightComesFromWhatIsSeenIsInsideAndDepthGrowsAlongItsRays)
{
    for (const int from : {1, 0, -1}) {
        SCOPED_TRACE(from);
        int tried = 0, ofPerspective = 0;
        forEachCase(test::kCases, [&](Rng& rng) {
            RandomSetup setup = ordinarySetup(rng);
            bringLight(setup, from, rng);
            const FitResult fit = fitPsm(inputOf(setup), rng.chance(0.5) ? PsmShift::Casters : PsmShift::None);
            if (!fit) return;
            const Mat4d& clip = fit->lightClipFromLocal;
            tried += setup.light.kind == LightKind::Directional;
            ofPerspective += setup.light.kind == LightKind::Directional && isPerspective(*fit);
            std::vector<Vec3d> points;
            findVisiblePoints(inputOf(setup), points);
            const bool isParallel = setup.light.kind == LightKind::Directional;
            for (const Vec3d& p : points) {
                const Vec4d c = clip * point(p);
                ASSERT_GT(c.w, 0);
                EXPECT_LE(std::max(std::abs(c.x), std::abs(c.y)), c.w);
                EXPECT_LE(c.z, c.w);
                const Vec3d towards = towardsLight(setup.light, setup.originWorld, p);
                const double most =
                    isParallel ? 2 * setup.radius : length(setup.light.positionWorld - setup.originWorld - p);
                const Vec3d here = project(clip, p);
                double last = here.z;
                for (const double part : {0.1, 0.3, 0.6, 0.9}) { // behind the eye and beyond, too
                    const Vec3d q = p + part * most * towards;
                    ASSERT_GT((clip * point(q)).w, 0);
                    const Vec3d there = project(clip, q);
                    EXPECT_NEAR(there.x, here.x, 1e-6 / (1 - part));
                    EXPECT_NEAR(there.y, here.y, 1e-6 / (1 - part));
                    EXPECT_LT(there.z, last);
                    last = there.z;
                }
            }
        });
        EXPECT_GT(tried, test::scaled(test::kCases) / 10);
        EXPECT_GT(ofPerspective, tried / 2); // not by giving the perspective up
    }
}

// How much the map's w differs over what is seen: how strong the perspective is.
double strength(const Fit& fit, std::span<const Vec3d> points)
{
    double least = INFINITY, most = 0;
    for (const Vec3d& p : points) {
        const double w = (fit.lightClipFromLocal * point(p)).w;
        least = std::min(least, w), most = std::max(most, w);
    }
    return most / least;
}

// A caster on the way of the light to a receiver is put behind the viewer.
TEST(Psm, CastersBehindTheViewerAreInTheMapAndTheShiftForThemWeakensThePerspective)
{
    int tried = 0, weaker = 0, stronger = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        RandomSetup setup = ordinarySetup(rng);
        bringLight(setup, 1, rng);
        const ViewDepth depth = viewDepth(setup.view, setup.originWorld);
        std::vector<Vec3d> points;
        findVisiblePoints(inputOf(setup), points);
        if (points.empty()) return;
        const Vec3d receiver = points[std::size_t(rng.integer(0, int(points.size()) - 1))];
        const Vec3d towards = towardsLight(setup.light, setup.originWorld, receiver);
        const bool isParallel = setup.light.kind == LightKind::Directional;
        const double most =
            isParallel ? 10 * setup.radius : length(setup.light.positionWorld - setup.originWorld - receiver);
        const double toEye = depth.of(receiver) / -dot(depth.forward, towards); // how far on the plane of the eye is
        if (!(toEye > 0 && toEye < 0.9 * most)) return;
        const Vec3d caster = receiver + std::min(0.95 * most, toEye * rng.uniform(1.05, 2)) * towards;
        if (!(depth.of(caster) < 0)) return;
        const Vec3d half{0.05, 0.05, 0.05};
        setup.boxesWorld.push_back({caster + setup.originWorld - half, caster + setup.originWorld + half});

        const FitResult shifted = fitPsm(inputOf(setup), PsmShift::Casters),
                        unshifted = fitPsm(inputOf(setup), PsmShift::None);
        ASSERT_EQ(shifted.hasValue(), unshifted.hasValue());
        if (!shifted) return;
        ++tried;
        for (const FitResult* fit : {&shifted, &unshifted}) {
            const Vec4d c = (*fit)->lightClipFromLocal * point(caster);
            ASSERT_GT(c.w, 0);
            EXPECT_LE(std::max(std::abs(c.x), std::abs(c.y)), c.w * (1 + 1e-6));
            EXPECT_GE(c.z, -c.w);
            EXPECT_LT(c.z / c.w, project((*fit)->lightClipFromLocal, receiver).z);
        }
        if (!isParallel) return; // w of lights at a point is a depth, too
        findVisiblePoints(inputOf(setup), points);
        const double with = strength(*shifted, points), without = strength(*unshifted, points);
        weaker += with < 0.99 * without;
        stronger += with > 1.01 * without; // where only the unshifted camera has to leave a light beside the picture
    });
    EXPECT_GT(tried, test::scaled(test::kCases) / 10);
    EXPECT_GT(weaker, tried / 20);
    EXPECT_LT(stronger, tried / 100);
}

TEST(Psm, OfAParallelViewIsFocused)
{
    forEachCase(test::kCases, [](Rng& rng) {
        RandomSetup setup = ordinarySetup(rng);
        const Vec3d eye = setup.view.anchorWorld;
        setup.view = orthographicView(eye, eye + Vec3d{1, -0.4, 0.3}, {0, 1, 0}, 0.5 * setup.radius, 0,
                                      4 * setup.radius, 512, 512);
        const FitResult psm = fitPsm(inputOf(setup), PsmShift::Casters), focused = fitFocused(inputOf(setup));
        ASSERT_EQ(psm.hasValue(), focused.hasValue());
        if (psm) {
            EXPECT_EQ(psm->lightClipFromLocal, focused->lightClipFromLocal);
        }
    });
}

} // namespace
} // namespace lixel
