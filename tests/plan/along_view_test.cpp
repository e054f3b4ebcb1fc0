// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/along_view.h"

#include "lixel/plan/fit/focused.h"
#include "lixel/plan/fit/lispsm.h"
#include "lixel/plan/fit/tsm.h"
#include "plan/ordinary_setups.h"

#include <gtest/gtest.h>

namespace lixel {
namespace {

using test::forEachCase;
using test::ordinarySetup;
using test::RandomSetup;
using test::Rng;

// An ordinary set-up with all that fits along the view start from.
struct Start
{
    RandomSetup setup;
    FitScratch scratch;
    std::optional<FramedBody> body;
    DepthSpan depths;
    std::optional<LineOfSight> line;

    FitInput input()
    {
        return {setup.view, setup.light, setup.originWorld, setup.boxesWorld, setup.sceneLocal(), scratch};
    }
};

bool begin(Start& start, Rng& rng, std::optional<LightKind> kind = {})
{
    start.setup = ordinarySetup(rng);
    if (kind && start.setup.light.kind != *kind) return false;
    const FitInput input = start.input();
    findVisiblePoints(input, start.scratch.points);
    if (start.scratch.points.empty()) return false;
    const auto body = frameAround(input, start.scratch.points);
    if (!body) return false;
    start.body = *body;
    start.depths = seenDepths(input, viewDepth(input.view, input.originWorld), start.scratch.points);
    start.line = lineOfSight(input, *body, start.depths);
    return start.line.has_value();
}

// Of a point in the map, -1 to +1.
Vec2d ndc(const Fit& fit, Vec3d pointLocal)
{
    const Vec3d p = project(fit.lightClipFromLocal, pointLocal);
    return {p.x, p.y};
}

// A map narrower than floats resolve is made wider than the points it holds, by what its own rows may round by.
bool isWidened(const Fit& fit, std::span<const Vec3d> points)
{
    double farthest = 0;
    for (const Vec3d& p : points) farthest = std::max(farthest, std::abs(ndc(fit, p).y));
    return farthest < 1 - 1.5e-6;
}

TEST(Lispsm, WithItsCentreAtInfinityIsTheParallelMapInTheSameOrientation)
{
    forEachCase(test::kCases, [](Rng& rng) {
        Start start;
        if (!begin(start, rng)) return;
        const std::span<const Vec3d> points = start.scratch.points;
        const FitInput input = start.input();
        const Fit far = fitAlong(input, *start.body, *start.line, 1e12 * start.line->length);
        const Vec2d a = start.line->along;
        const auto turned = warped(*start.body, {{a.y, -a.x, 0}, {a.x, a.y, 0}, {0, 0, 1}});
        ASSERT_TRUE(turned);
        const Fit parallel = fitTightly(*turned, RectangleKind::Upright, input);
        if (isWidened(far, points) || isWidened(parallel, points)) return;
        for (const Vec3d& p : points) {
            EXPECT_NEAR(ndc(far, p).x, ndc(parallel, p).x, 1e-6);
            EXPECT_NEAR(ndc(far, p).y, ndc(parallel, p).y, 1e-6);
        }
    });
}

TEST(Lispsm, WhereLightAndLineOfSightAlignIsFocused)
{
    forEachCase(test::kCases, [](Rng& rng) {
        Start start;
        start.setup = ordinarySetup(rng);
        start.setup.light.kind = LightKind::Directional;
        const Vec3d forward = viewDepth(start.setup.view, start.setup.originWorld).forward;
        const double aside = rng.chance(0.3) ? 0 : rng.logUniform(1e-12, 1e-4);
        start.setup.light.directionWorld =
            normalized((rng.chance(0.5) ? 1.0 : -1.0) * forward + aside * rng.onSphere());
        const FitResult lispsm = fitLispsm(start.input()), focused = fitFocused(start.input());
        ASSERT_EQ(lispsm.hasValue(), focused.hasValue());
        if (lispsm) {
            EXPECT_EQ(lispsm->lightClipFromLocal, focused->lightClipFromLocal);
        }
    });
}

TEST(Lispsm, ForParallelLightTheCentreIsWhereThePaperPutsIt)
{
    int tried = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        Start start;
        if (!begin(start, rng, LightKind::Directional)) return;
        const double gamma = std::acos(dot(normalized(start.line->perDepth), -start.setup.light.directionWorld));
        const double zn = start.depths.nearest, zf = start.depths.farthest;
        const double paper = (zn + std::sqrt(zn * zf)) / std::sin(gamma);
        EXPECT_NEAR(lispsmDistance(start.body->frame, *start.line, start.depths) / paper, 1, 1e-6);
        ++tried;
    });
    EXPECT_GT(tried, test::scaled(test::kCases) / 10);
}

// What section 4 of the paper asks for: how long a lixel is in the picture along the line of sight, the same at both ends, so
// that the greater of the two is as small as it can be.
TEST(Lispsm, AcrossTheLineOfSightErrorsAreEqualAtBothEndsForLightsOfEveryKind)
{
    int tried = 0;
    forEachCase(10 * test::kCases, [&](Rng& rng) {
        Start start;
        if (!begin(start, rng) || start.line->sineSquared < 0.95) return;
        const double best = lispsmDistance(start.body->frame, *start.line, start.depths) * start.line->sineSquared;
        if (!std::isfinite(best)) return;
        const auto errorAt = [&](double distance, double depth) {
            // Of the perspective from `distance` before the first point of the line itself.
            const double first = placeAlong(*start.line, start.body->frame, start.line->at(start.depths.nearest));
            const auto mapped = [&](double z) {
                const double t = placeAlong(*start.line, start.body->frame, start.line->at(z)) - first;
                return t / (distance + t);
            };
            const double h = 1e-5 * depth, lixelsPerDepth = (mapped(depth + h) - mapped(depth - h)) / (2 * h);
            return 1 / (depth * std::abs(lixelsPerDepth)); // a length at this depth has 1 / depth of the pixels
        };
        const auto worst = [&](double distance) {
            return std::max(errorAt(distance, start.depths.nearest), errorAt(distance, start.depths.farthest));
        };
        EXPECT_NEAR(errorAt(best, start.depths.nearest) / errorAt(best, start.depths.farthest), 1, 1e-3);
        ++tried;
        for (const double other : {0.7, 0.95, 1.05, 1.4}) {
            const double scale = other * best; // the whole span is one map in each: compare at equal lixels
            const double span = placeAlong(*start.line, start.body->frame, start.line->at(start.depths.farthest)) -
                                placeAlong(*start.line, start.body->frame, start.line->at(start.depths.nearest));
            const auto perMap = [&](double distance) { return worst(distance) * span / (distance + span); };
            EXPECT_LE(perMap(best), perMap(scale) * (1 + 1e-3));
        }
    });
    EXPECT_GT(tried, 20);
}

// Of parallel light: how much larger the largest lixel is than the smallest, across and along together, over what is held.
double strength(const Fit& fit, std::span<const Vec3d> points)
{
    double least = INFINITY, most = 0;
    for (const Vec3d& p : points) {
        const double w = dot(fit.lightClipFromLocal.row(3), point(p));
        least = std::min(least, w), most = std::max(most, w);
    }
    return std::pow(most / least, 3);
}

// Of parallel light: the lixel's area across it at a point, in units of the map's own square.
double lixelArea(const Fit& fit, Vec3d pointLocal)
{
    const Mat4d& clip = fit.lightClipFromLocal;
    const Vec4d w = clip.row(3);
    const double at = dot(w, point(pointLocal));
    const Vec3d ndc = project(clip, pointLocal);
    const Vec3d x = xyz(clip.row(0)) - ndc.x * xyz(w), y = xyz(clip.row(1)) - ndc.y * xyz(w);
    return at * at / length(cross(x, y));
}

// Greater over less.
double change(double a, double b) { return std::max(a / b, b / a); }

// The farthest centre is 8 lengths of the body away: there lixels differ by (9/8)^3 = 1.424, and all but no more is lost when the
// perspective goes between two angles one part in a hundred apart. What the map gains besides is its turn from upright along the line
// to the rectangle of least area, a by b: no rectangle around that one has more than 1 + (a/b + b/a) / 2 times its area.
// A perspective may change faster with the angle than that; then it does so little by little.
TEST(Lispsm, FadesToFocusedWithoutALargerJumpAsLightAndLineOfSightAlign)
{
    constexpr double kStep = 0.99, kSmooth = 1.15, kLast = 1.46, kOfATenth = 1.05;
    int faded = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        Start start;
        start.setup = ordinarySetup(rng);
        start.setup.light = {};
        const Vec3d forward = viewDepth(start.setup.view, start.setup.originWorld).forward;
        const Vec3d aside = normalized(cross(forward, rng.onSphere())), towards = rng.chance(0.5) ? forward : -forward;
        std::optional<Fit> before;
        std::vector<Vec3d> points;
        const auto fitAt = [&](double angle) {
            start.setup.light.directionWorld = std::cos(angle) * towards + std::sin(angle) * aside;
            const FitResult fit = fitLispsm(start.input());
            points = start.scratch.points;
            return fit;
        };
        const auto largestChange = [&](double from, double to, int parts) {
            double largest = 1;
            FitResult last = fitAt(from);
            for (int i = 1; i <= parts; ++i) {
                const FitResult next = fitAt(std::lerp(from, to, double(i) / parts));
                if (!last || !next) return double(INFINITY);
                largest = std::max(largest, change(strength(*last, points), strength(*next, points)));
                last = next;
            }
            return largest;
        };
        for (double angle = 1.2; angle > 1e-4; angle *= kStep) {
            const FitResult fit = fitAt(angle);
            if (!fit) return;
            if (before) {
                const double was = strength(*before, points), is = strength(*fit, points);
                const bool fades = was == 1 || is == 1;
                if (change(was, is) >= (fades ? kLast : kSmooth)) {
                    EXPECT_LT(largestChange(angle / kStep, angle, 10), fades ? kLast : kOfATenth) << angle;
                }
                if (was > 1 && is == 1) {
                    ++faded;
                    const OrientedRectangle r =
                        rectangleAround(*visibleBody(start.input()), RectangleKind::LeastArea, start.scratch);
                    const double a = r.halfSize.x, b = r.halfSize.y, turn = 1 + 0.5 * (a / b + b / a);
                    for (const Vec3d& p : points) {
                        const double ratio = lixelArea(*before, p) / lixelArea(*fit, p);
                        EXPECT_LT(ratio, 1.01 * kLast * turn);
                        EXPECT_GT(ratio, 1 / (1.01 * kLast));
                    }
                }
            }
            before = *fit;
        }
        EXPECT_EQ(strength(*before, points), 1);
    });
    EXPECT_GT(faded, test::scaled(test::kCases) / 2);
}

// The centre's distance is told by the map: w goes from 1 to 1 + length / n over the body.
TEST(Lispsm, ItsCentreIsThatOfTheNearestAndFarthestDepthThatIsSeen)
{
    int tried = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        Start start;
        if (!begin(start, rng, LightKind::Directional)) return;
        const ViewDepth depth = viewDepth(start.setup.view, start.setup.originWorld);
        const std::vector<Vec3d> points = start.scratch.points;
        // Some of what may be seen, the nearest of it left out as other things may hide it.
        std::vector<Vec3d> seen;
        const double least = rng.uniform(0.05, 0.6) * start.depths.farthest;
        for (int i = 0; i < 200; ++i) {
            const Vec3d a = points[std::size_t(rng.integer(0, int(points.size()) - 1))],
                        b = points[std::size_t(rng.integer(0, int(points.size()) - 1))];
            const Vec3d p = a + rng.uniform(0, 1) * (b - a);
            if (depth.of(p) > least) seen.push_back(p);
        }
        if (seen.empty()) return;
        double zn = INFINITY, zf = 0;
        for (const Vec3d& p : seen) zn = std::min(zn, depth.of(p)), zf = std::max(zf, depth.of(p));
        if (!(zf > 1.01 * zn)) return;
        FitInput input = start.input();
        input.hasViewSamples = true;
        input.seenLocal = seen;
        const FitResult fit = fitLispsm(input);
        ASSERT_TRUE(fit);
        const double lixels = std::cbrt(strength(*fit, points));
        if (lixels == 1) return; // focused
        const double n = start.line->length / (lixels - 1);
        const double gamma = std::acos(dot(normalized(start.line->perDepth), -start.setup.light.directionWorld));
        EXPECT_NEAR(n / ((zn + std::sqrt(zn * zf)) / std::sin(gamma)), 1, 1e-6);
        ++tried;
    });
    EXPECT_GT(tried, test::scaled(test::kCases) / 10);
}

TEST(Tsm, TheFocusPointComesToLieAtEightyPercentOfTheMap)
{
    int tried = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        Start start;
        if (!begin(start, rng)) return;
        const double focus = start.depths.nearest * std::pow(start.depths.farthest / start.depths.nearest, 0.4);
        const double delta = placeAlong(*start.line, start.body->frame, start.line->at(focus));
        const double distance = tsmDistance(start.line->length, delta);
        // So strong a perspective is none but for rounding.
        if (!(distance > 1e-5 * start.line->length) || !std::isfinite(distance)) return;
        const FitResult fit = fitTsm(start.input(), focus);
        ASSERT_TRUE(fit);
        if (isWidened(*fit, start.scratch.points)) return;
        EXPECT_NEAR(ndc(*fit, start.line->at(focus)).y, -1 + 2 * 0.8, 1e-5);
        ++tried;
    });
    EXPECT_GT(tried, test::scaled(test::kCases) / 4);
}

TEST(Tsm, TheCentresDistanceSolvesTheEightyPercentRule)
{
    forEachCase(test::kCases, [](Rng& rng) {
        const double lambda = rng.logUniform(1e-3, 1e3), delta = lambda * rng.uniform(0.01, 0.79);
        const double eta = tsmDistance(lambda, delta);
        EXPECT_NEAR((delta / (delta + eta)) / (lambda / (lambda + eta)), 0.8, 1e-9);
        EXPECT_TRUE(std::isinf(tsmDistance(lambda, 0.8 * lambda * (1 + 1e-9))));
    });
}

} // namespace
} // namespace lixel
