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
