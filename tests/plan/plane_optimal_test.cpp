// SPDX-License-Identifier: MIT
// Plane-optimal maps against the paper: H. Chong, S. Gortler. A Lixel for every Pixel. 2004, section 2.
#include "lixel/plan/fit/plane_optimal.h"

#include "lixel/plan/light_image.h"
#include "plan/five_point_matrix.h"
#include "plan/plane_setups.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace lixel {
namespace {

using test::anyPixel;
using test::anyPlaneSetup;
using test::forEachCase;
using test::lightLocal;
using test::PlaneSetup;
using test::pointSeenAt;
using test::Rng;
using test::rowOf;

Expected<LightFrame, FitFailure> frameOf(const PlaneSetup& setup)
{
    return planeOptimalFrame(setup.view, setup.light, setup.originWorld, setup.planeLocal, setup.radius);
}

// What rounding of a plane's points may do to pixels, by how flat light and eye stand over it.
double allowed(const PlaneSetup& setup)
{
    const double light = std::abs(test::sineAbove(setup, lightLocal(setup)));
    const double eye = std::abs(test::sineAbove(setup, eyeLocal(setup.view, setup.originWorld)));
    return std::max(1e-8, 1e-13 * (setup.view.width + setup.view.height) / (std::min(1.0, light) * std::min(1.0, eye)));
}

// Into the view's own coordinates, where everything about it has all its digits; as if the world were about the eye.
void countFromEye(PlaneSetup& setup)
{
    const Vec3d eye = setup.view.anchorWorld;
    setup.planeLocal.offset += dot(setup.planeLocal.normal, eye - setup.originWorld);
    setup.light.positionWorld = setup.light.positionWorld - eye;
    for (Box& box : setup.boxesWorld) box = translated(box, -eye);
    setup.view.anchorWorld = setup.originWorld = {};
}

// Equations 3-6, and so all points of the plane.
TEST(PlaneOptimal, EveryPointOfThePlaneThatTheViewerSeesHasItsPixelAsItsPlaceInTheMap)
{
    int seen = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        const PlaneSetup setup = anyPlaneSetup(rng);
        const auto frame = frameOf(setup);
        if (!frame) return;
        for (int i = 0; i < 20; ++i) {
            const Vec2d pixel = anyPixel(setup.view, rng);
            const auto p = pointSeenAt(setup, pixel);
            if (!p) continue;
            ++seen;
            ASSERT_GT(dot(frame->framedFromLocal.row(3), point(*p)), 0);
            const Vec2d lixel = onLightPlane(*frame, *p);
            EXPECT_NEAR(lixel.x, pixel.x, allowed(setup));
            EXPECT_NEAR(lixel.y, pixel.y, allowed(setup));
        }
    });
    EXPECT_GT(seen, test::scaled(1000));
}

// Equation 1 and what follows from it.
TEST(PlaneOptimal, AllPointsOfALightRayHaveOneLixel)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const PlaneSetup setup = anyPlaneSetup(rng);
        const auto frame = frameOf(setup);
        if (!frame) return;
        const Vec4d l = lightLocal(setup);
        for (int i = 0; i < 20; ++i) {
            const Vec2d pixel = anyPixel(setup.view, rng);
            const auto p = pointSeenAt(setup, pixel, 10);
            if (!p) continue;
            // On both sides of the plane, and behind a light that is near, where w turns with the ray.
            const Vec4d towards = l - l.w * point(*p);
            const double away = length(xyz(towards)), onTheWay = l.w * 10 * setup.radius / away;
            const double s = rng.uniform(-1, 2) * (onTheWay > 1 ? 1 / l.w : 10 * setup.radius / away);
            if (std::abs(1 - s * l.w) < 0.05) continue; // at the light
            const Vec4d f = frame->framedFromLocal * (point(*p) + s * towards);
            EXPECT_EQ(f.w > 0, s * l.w < 1);
            EXPECT_NEAR(f.x / f.w, pixel.x, 30 * allowed(setup));
            EXPECT_NEAR(f.y / f.w, pixel.y, 30 * allowed(setup));
        }
    });
}

// Equations 1 and 7-10, with the sign that Figure 5 asks for.
TEST(PlaneOptimal, TheClosedFormIsThePapersSolutionOfFivePoints)
{
    int compared = 0, straddling = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        PlaneSetup setup = anyPlaneSetup(rng);
        countFromEye(setup);
        const auto frame = frameOf(setup);
        if (!frame) return;
        const double w = setup.view.width, h = setup.view.height;
        const std::array<Vec4d, 4> corners{test::seenAt(setup, {0, 0}), test::seenAt(setup, {0, h}),
                                           test::seenAt(setup, {w, h}), test::seenAt(setup, {w, 0})};
        const auto solved =
            test::fivePointMatrix(corners, w, h, lightLocal(setup), setup.radius, rng.uniform(0.2, 0.8));
        if (!solved) return;
        const Vec4d viewW = setup.view.clipFromAnchored.row(3);
        int before = 0;
        for (const Vec4d& c : corners) before += dot(viewW, c) * c.w > 0;
        straddling += before > 0 && before < 4;
        // The paper leaves the factor, and so its sign, open.
        const Mat4d& ours = frame->framedFromLocal;
        const double factor = dot(ours.row(3), ours.row(3)) / dot(ours.row(3), solved->row(3));
        for (const int row : {0, 1, 3}) {
            const Vec4d a = ours.row(row), apart = a - factor * solved->row(row);
            EXPECT_LT(std::sqrt(dot(apart, apart)), 10 * allowed(setup) * std::sqrt(dot(a, a))) << "row " << row;
        }
        ++compared;
    });
    std::printf("%d compared, %d of them with a quad that spans infinity\n", compared, straddling);
    EXPECT_GT(compared, test::scaled(1000));
    EXPECT_GT(straddling, test::scaled(100));
}

TEST(PlaneOptimal, APlaneTurnedOverIsTheSamePlane)
{
    forEachCase(test::kCases, [](Rng& rng) {
        PlaneSetup setup = anyPlaneSetup(rng);
        const auto a = frameOf(setup);
        setup.planeLocal = {-setup.planeLocal.normal, -setup.planeLocal.offset};
        const auto b = frameOf(setup);
        ASSERT_EQ(a.hasValue(), b.hasValue());
        if (!a) return;
        EXPECT_EQ(a->framedFromLocal, b->framedFromLocal);
    });
}

// Figure 3: the light-image plane is parallel to the plane through the light and the line pi, where the plane of interest meets
// the plane through the eye parallel to the viewer's image.
TEST(PlaneOptimal, TheLightImageIsParallelToThePlaneThroughTheLightAndPi)
{
    forEachCase(test::kCases, [](Rng& rng) {
        PlaneSetup setup = anyPlaneSetup(rng);
        countFromEye(setup);
        const auto frame = frameOf(setup);
        if (!frame) return;
        const Vec4d w = frame->framedFromLocal.row(3), plane = rowOf(setup.planeLocal),
                    eye = setup.view.clipFromAnchored.row(3), l = lightLocal(setup);
        const double terms = std::sqrt(dot(l, l) * dot(plane, plane) * dot(eye, eye));
        const auto expectHolds = [&](Vec4d p) { EXPECT_LT(std::abs(dot(w, p)), 1e-13 * terms * std::sqrt(dot(p, p))); };
        expectHolds(l);
        for (int i = 0; i < 4; ++i) { // points of pi: in the plane, in the eye's, and in any third
            const Vec3d third = rng.onSphere();
            const Vec4d pi = test::meet(plane, eye, {third.x, third.y, third.z, setup.radius * rng.uniform(-1, 1)});
            if (dot(pi, pi) > 0) expectHolds(pi);
        }
    });
}

// Figure 4.
TEST(PlaneOptimal, AMinersLampHasAnImageParallelToTheViewersForEveryPlaneAndAffineToItOnEveryOther)
{
    int tried = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        PlaneSetup setup = anyPlaneSetup(rng);
        if (!(setup.view.eyeAnchored.w > 0)) return;
        countFromEye(setup);
        const Vec4d w = setup.view.clipFromAnchored.row(3);
        const Vec3d beside = normalized(cross(xyz(w), rng.onSphere()));
        setup.light.directionWorld = beside;
        setup.light.positionWorld = setup.radius * rng.logUniform(1e-3, 1e3) * beside;
        const auto frame = frameOf(setup);
        if (!frame) return;
        const Vec4d ours = frame->framedFromLocal.row(3), apart = ours - (dot(ours, w) / dot(w, w)) * w;
        EXPECT_GT(dot(ours, w), 0);
        EXPECT_LT(std::sqrt(dot(apart, apart)), allowed(setup) * std::sqrt(dot(ours, ours)));

        // On any other plane a step of the picture is the same step of the map, wherever it is taken.
        PlaneSetup other = setup;
        other.planeLocal = test::anyPlane(setup, rng);
        for (int i = 0; i < 5; ++i) {
            const Vec2d a = anyPixel(setup.view, rng), b = anyPixel(setup.view, rng);
            const auto pa = pointSeenAt(other, a), pb = pointSeenAt(other, b), pm = pointSeenAt(other, 0.5 * (a + b));
            if (!pa || !pb || !pm) continue;
            const Vec2d la = onLightPlane(*frame, *pa), lb = onLightPlane(*frame, *pb), lm = onLightPlane(*frame, *pm);
            ++tried;
            EXPECT_LT(length(0.5 * (la + lb) - lm),
                      10 * allowed(setup) * (1 + (length(la) + length(lb)) / setup.view.width));
        }
    });
    EXPECT_GT(tried, test::scaled(100));
}

TEST(PlaneOptimal, ALightOrAnEyeInThePlaneIsRefusedByName)
{
    forEachCase(test::kCases, [](Rng& rng) {
        PlaneSetup setup = anyPlaneSetup(rng);
        const Vec3d n = rng.onSphere();
        PlaneSetup lightIn = setup;
        const Vec4d l = lightLocal(setup);
        if (setup.light.kind == LightKind::Directional) {
            const Vec3d beside = normalized(cross(xyz(l), n));
            lightIn.planeLocal = planeThrough(setup.sceneLocal().centre(), beside);
        } else {
            lightIn.planeLocal = planeThrough((1 / l.w) * xyz(l), n);
        }
        const auto a = frameOf(lightIn);
        ASSERT_FALSE(a);
        EXPECT_EQ(a.error(), FitFailure::LightInPlane);

        if (setup.view.eyeAnchored.w > 0)
            setup.planeLocal = planeThrough(setup.view.anchorWorld - setup.originWorld, n);
        else
            setup.planeLocal =
                planeThrough(setup.sceneLocal().centre(), normalized(cross(xyz(setup.view.eyeAnchored), n)));
        const auto b = frameOf(setup);
        ASSERT_FALSE(b);
        if (b.error() != FitFailure::LightInPlane) {
            EXPECT_EQ(b.error(), FitFailure::EyeInPlane);
        }
    });
}

TEST(PlaneOptimal, APlaneBetweenEyeAndLightIsRefusedByName)
{
    int refused = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        const PlaneSetup setup = anyPlaneSetup(rng);
        const Vec4d pi = rowOf(setup.planeLocal);
        const double eye = dot(pi, eyeLocal(setup.view, setup.originWorld)), light = dot(pi, lightLocal(setup));
        const FitResult fit = fitPlaneOptimal(test::inputOf(setup, Twist::Tight, false), {});
        if (eye * light > 0) {
            if (!fit) {
                EXPECT_NE(fit.error(), FitFailure::PlaneFacesAway);
            }
            return;
        }
        ASSERT_FALSE(fit);
        refused += fit.error() == FitFailure::PlaneFacesAway;
    });
    EXPECT_GT(refused, test::scaled(100));
}

TEST(PlaneOptimal, TheRectangleOfWholePixelsIsTheLeastThatHoldsABody)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const PlaneSetup setup = anyPlaneSetup(rng);
        const auto frame = frameOf(setup);
        if (!frame) return;
        std::vector<Vec3d> points;
        Vec2d low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
        const Vec2d middle = anyPixel(setup.view, rng);
        const double spread = rng.logUniform(1e-3, 1);
        for (int i = rng.integer(1, 12); i > 0; --i) {
            const Vec2d pixel = middle + spread * (anyPixel(setup.view, rng) - middle);
            if (const auto p = pointSeenAt(setup, pixel)) {
                points.push_back(*p);
                low = {std::min(low.x, pixel.x), std::min(low.y, pixel.y)};
                high = {std::max(high.x, pixel.x), std::max(high.y, pixel.y)};
            }
        }
        if (points.empty() || allowed(setup) > 1e-7) return;
        const auto r = wholePixelsAround({*frame, points, points}, 32768);
        ASSERT_TRUE(r);
        const double slack = 2e-6;
        EXPECT_LE(r->x0, low.x + slack);
        EXPECT_LE(r->y0, low.y + slack);
        EXPECT_GE(r->x1, high.x - slack);
        EXPECT_GE(r->y1, high.y - slack);
        EXPECT_GT(r->x0 + 1, low.x - slack);
        EXPECT_GT(r->y0 + 1, low.y - slack);
        EXPECT_LT(r->x1 - 1, high.x + slack);
        EXPECT_LT(r->y1 - 1, high.y + slack);
    });
}

} // namespace
} // namespace lixel
