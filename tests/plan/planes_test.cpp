// SPDX-License-Identifier: MIT
// Regions of planes: which plane a light ray belongs to, what has no region, exact allocation, and planes that are found.
#include "lixel/plan/partition/planes.h"

#include "plan/ordinary_setups.h"
#include "plan/planed_setups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace lixel {
namespace {

using test::forEachCase;
using test::kCases;
using test::RandomSetup;
using test::Rng;

// How far along the way from the light a ray meets a plane; parallel rays are followed from far away. Infinity where it does not.
double meetingAt(const RandomSetup& setup, const Plane& plane, Vec3d p)
{
    const Vec3d d = -towardsLight(setup.light, setup.originWorld, p);
    const bool isParallel = setup.light.kind == LightKind::Directional;
    const Vec3d from = isParallel ? p - 1e3 * setup.radius * d : setup.light.positionWorld - setup.originWorld;
    const double t = -plane.signedDistance(from) / dot(plane.normal, d);
    return t > 0 || isParallel ? t : std::numeric_limits<double>::infinity();
}

bool isHeld(const CellPlanes& cell, Vec3d p, double room)
{
    return std::all_of(cell.begin(), cell.end(), [&](const Plane& plane) { return plane.signedDistance(p) >= -room; });
}

TEST(Planes, ARayBelongsToThePlaneThatItMeetsFirst)
{
    int first = 0, second = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        const RandomSetup setup = test::ordinarySetup(rng);
        FitInput input = test::inputOf(setup);
        // They meet above the floor's middle.
        InterestPlanes planes;
        const Vec3d line = -1.0 * setup.originWorld;
        for (int i = 0; i < 2; ++i) planes.push_back({planeThrough(line, rng.onSphere()), {}, i});
        // One that faces away has no map, and takes no ray from the other.
        const Vec3d eye = setup.view.anchorWorld - setup.originWorld;
        const auto isFacing = [&](const InterestPlane& plane) {
            const Vec3d n = plane.planeLocal.normal;
            const double ofLight = setup.light.kind == LightKind::Directional
                                       ? -dot(n, setup.light.directionWorld)
                                       : plane.planeLocal.signedDistance(setup.light.positionWorld - setup.originWorld);
            return ofLight * plane.planeLocal.signedDistance(eye) > 0;
        };
        if (!isFacing(planes[0]) || !isFacing(planes[1])) return;
        const CellsResult cells = splitPlanes(input, {planes.data(), 2}, Twist::Line);
        ASSERT_TRUE(cells);
        ASSERT_EQ(cells->size(), 2u);
        for (int i = 0; i < 20; ++i) {
            const Vec3d p = setup.sceneLocal().centre() + setup.radius * rng.inBox(1);
            const double a = meetingAt(setup, planes[0].planeLocal, p), b = meetingAt(setup, planes[1].planeLocal, p);
            if (std::min(a, b) == std::numeric_limits<double>::infinity() || !(std::abs(a - b) > 1e-6 * setup.radius))
                continue;
            EXPECT_EQ(isHeld((*cells)[0].servesLocal, p, 0), a < b);
            EXPECT_EQ(isHeld((*cells)[1].servesLocal, p, 0), b < a);
            ++(a < b ? first : second);
        }
    });
    EXPECT_GT(first, test::scaled(1000));
    EXPECT_GT(second, test::scaled(1000));
}

TEST(Planes, APolygonHasTheRaysThroughIt)
{
    int inside = 0, outside = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        const RandomSetup setup = test::ordinarySetup(rng);
        FitInput input = test::inputOf(setup);
        NamedPlane named{
            "table", {rng.uniform(-1, 1), 1, rng.uniform(-1, 1)}, {0, rng.chance(0.5) ? 1.0 : -1.0, 0}, {}};
        test::addPolygon(named, rng.uniform(0.5, 3), rng);
        const InterestPlane table = interestPlane(named, setup.originWorld, 0, input.scratch.plane);
        const CellsResult cells = splitPlanes(input, {&table, 1}, Twist::Tight);
        ASSERT_TRUE(cells);
        for (int i = 0; i < 30; ++i) {
            const Vec3d p = named.pointWorld - setup.originWorld + Vec3d{rng.uniform(-3, 3), 0, rng.uniform(-3, 3)};
            const auto& corners = table.polygonLocal;
            double least = std::numeric_limits<double>::infinity(), most = -least;
            for (std::size_t k = 0; k < corners.size(); ++k) {
                const double side = cross(corners[(k + 1) % corners.size()] - corners[k], p - corners[k]).y;
                least = std::min(least, side), most = std::max(most, side);
            }
            if (std::min(std::abs(least), std::abs(most)) < 1e-6) continue;
            const bool isInside = least > 0 || most < 0;
            // Anywhere along the ray behind the light.
            const Vec3d q = p - rng.uniform(0, 1) * towardsLight(setup.light, setup.originWorld, p);
            EXPECT_EQ(isHeld((*cells)[0].servesLocal, q, 0), isInside);
            ++(isInside ? inside : outside);
        }
    });
    EXPECT_GT(inside, test::scaled(1000));
    EXPECT_GT(outside, test::scaled(1000));
}

PlanInput inputFor(const RandomSetup& setup, const char* technique, LixelSize lixels)
{
    return {setup.view,
            {&setup.light, 1},
            setup.boxesWorld,
            setup.originWorld,
            std::get<MapTechnique>(*parseTechnique(technique)),
            lixels};
}

TEST(Planes, ThatHaveNoMapAreLeftOutByNameAndTheRestIsServed)
{
    int away = 0, edgeOn = 0, inPlane = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        const RandomSetup setup = test::ordinarySetup(rng);
        const ViewSamples samples = test::anySamples(setup, rng);
        if (samples.size() == 0) return;
        const Vec3d toLight = setup.light.kind == LightKind::Directional
                                  ? -setup.light.directionWorld
                                  : normalized(setup.light.positionWorld - setup.view.anchorWorld);
        const Vec3d across = normalized(cross(toLight, rng.onSphere()));
        // Between eye and light; with the light, and with the eye in it.
        const double half = setup.light.kind == LightKind::Directional
                                ? 1
                                : 0.5 * length(setup.light.positionWorld - setup.view.anchorWorld);
        const std::vector<NamedPlane> planes{
            {"away", setup.view.anchorWorld + half * toLight, toLight, {}},
            {"light",
             setup.light.kind == LightKind::Directional ? setup.view.anchorWorld + across : setup.light.positionWorld,
             across,
             {}},
            {"eye", setup.view.anchorWorld, normalized(across + 0.5 * toLight), {}},
            {"floor", {0, 0, 0}, {0, 1, 0}, {}}};
        PlanInput input = inputFor(setup, "planes(away,light,eye,floor)", {512, 512});
        input.planes = planes;
        const FramePlan plan = planShadows(input);
        ASSERT_FALSE(plan.lights[0].refused);
        for (const LeftOutPlane& left : plan.lights[0].leftOut) {
            away += left.plane == 0 && left.why == FitFailure::PlaneFacesAway;
            inPlane += left.plane == 1 && left.why == FitFailure::LightInPlane;
            edgeOn += left.plane == 2 && left.why == FitFailure::EyeInPlane;
        }
        EXPECT_GE(plan.lights[0].leftOut.size(), 3u);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            shared::LxReceiver receiver{};
            EXPECT_NE(test::serving(plan, samples.positionLocal[i], samples.normal[i], receiver), nullptr);
        }
    });
    EXPECT_GT(away, test::scaled(1000));
    EXPECT_GT(edgeOn, test::scaled(1000));
    EXPECT_GT(inPlane, test::scaled(1000));
}

TEST(Planes, WithExactAllocationLieOnThePixelGridWithinTheBudgetOrAreTooManyByName)
{
    int planned = 0, tooFew = 0;
    forEachCase(test::kCases, [&](Rng& rng) {
        const RandomSetup setup = test::ordinarySetup(rng);
        const std::vector<NamedPlane> planes = test::anyPlanes(setup, rng, true, 2);
        const int side = int(rng.logUniform(16, 3000));
        PlanInput input =
            inputFor(setup, rng.chance(0.5) ? "planes(a,b)+allocation=exact" : "planes(a,b)+allocation=exact+pcf(9)",
                     {side, side});
        input.planes = planes;
        const FramePlan plan = planShadows(input);
        if (plan.lights[0].refused) {
            tooFew += plan.lights[0].refused == FitFailure::TooFewLixels;
            return;
        }
        EXPECT_LE(plan.lixelsOf(0), std::int64_t(side) * side);
        for (const PlannedRegion& region : plan.lights[0].regions) {
            if (!region.pixels) continue;
            ++planned;
            const int band = int(std::ceil(plan.lookup.reach));
            EXPECT_EQ(region.rectangle.width(), region.pixels->width() + 2 * band);
            EXPECT_EQ(region.rectangle.height(), region.pixels->height() + 2 * band);
            // A point of the plane has the same fraction of a lixel as of a pixel: they differ by whole numbers.
            const NamedPlane& named = planes[std::size_t(region.plane)];
            const LightImage image(region.lightClipFromLocal, region.rectangle);
            for (int i = 0; i < 5; ++i) {
                const Vec3d offset = setup.radius * cross(named.normalWorld, rng.onSphere());
                const Vec3d p = named.pointWorld + rng.uniform(0, 0.3) * offset - setup.originWorld;
                if (!test::isInView(setup, p)) continue;
                const auto lixel = image.lixelAt(p);
                if (!lixel) continue;
                const Vec3d pixel = pixelFromLocal(setup.view, setup.originWorld, p);
                EXPECT_NEAR(lixel->x - region.rectangle.x0 - band + region.pixels->x0, pixel.x, 1e-5);
                EXPECT_NEAR(lixel->y - region.rectangle.y0 - band + region.pixels->y0, pixel.y, 1e-5);
            }
        }
    });
    EXPECT_GT(planned, test::scaled(200));
    EXPECT_GT(tooFew, test::scaled(20));
}

// Receivers of a floor and a wall at right angles, with shadows that end along some lines of both.
struct RoomView
{
    RandomSetup setup;
    ViewSamples samples;
    Observation observed;

    explicit RoomView(Rng& rng)
    {
        setup.radius = 20;
        setup.boxesWorld = {{{-20, -1, -20}, {20, 0, 20}}, {{-20, 0, -21}, {20, 10, -20}}};
        const Vec3d eye{rng.uniform(-8, 8), rng.uniform(1, 5), rng.uniform(0, 15)};
        setup.view = perspectiveView(eye, {rng.uniform(-8, 8), 0, -18}, {0, 1, 0}, 1, 0.1, 200, 320, 240);
        setup.light.directionWorld = normalized({rng.uniform(-1, 1), -1, rng.uniform(-1, -0.3)});
        setup.originWorld = {std::round(eye.x), std::round(eye.y), std::round(eye.z)};
        samples.width = 320, samples.height = 240;
        samples.originWorld = setup.originWorld;
        for (int i = 0; i < 3000; ++i) {
            const bool isFloor = rng.chance(0.6);
            const Vec3d world = isFloor ? Vec3d{rng.uniform(-20, 20), 0, rng.uniform(-20, 15)}
                                        : Vec3d{rng.uniform(-20, 20), rng.uniform(0, 10), -20};
            const Vec3d p = world - setup.originWorld;
            if (!test::isInView(setup, p)) continue;
            const Vec3d pixel = pixelFromLocal(setup.view, setup.originWorld, p);
            samples.pixel.push_back({float(pixel.x), float(pixel.y)});
            samples.positionLocal.push_back(toFloat(p));
            samples.normal.push_back(isFloor ? Vec3f{0, 1, 0} : Vec3f{0, 0, 1});
            samples.triangle.push_back(kNoTriangle);
        }
        observed = test::anyObservation(setup, samples, rng);
    }
};

double predictedErrorOf(const RoomView& room, const FramePlan& plan)
{
    BoundaryDirections directions;
    std::vector<NeedSample> need;
    std::vector<Vec3d> points, normals;
    for (std::size_t i = 0; i < room.samples.size(); ++i)
        points.push_back(toDouble(room.samples.positionLocal[i])), normals.push_back(toDouble(room.samples.normal[i]));
    gatherNeedSamples({&room.observed, 0, points, normals}, room.setup.light, room.setup.originWorld, directions, need);
    const NeedPredictor predictor(room.setup.view, room.setup.originWorld);
    double sum = 0;
    for (const NeedSample& sample : need) {
        shared::LxReceiver receiver{};
        const PlannedRegion* region = test::serving(plan, toFloat(sample.pointLocal), toFloat(sample.normal), receiver);
        if (!region) continue;
        Fit fit;
        fit.lightClipFromLocal = region->lightClipFromLocal;
        sum += predictor.of(fit, sample).within(region->rectangle.width(), region->rectangle.height());
    }
    return sum;
}

TEST(PlanesAuto, AreTheSameAgainAndTakenWhereThePredictedErrorFalls)
{
    int withPlanes = 0, kept = 0;
    forEachCase(kCases, [&](Rng& rng) {
        const RoomView room(rng);
        PlanInput input = inputFor(room.setup, "planes(auto)", {512, 512});
        input.seen = &room.samples;
        input.seenIsAll = true;
        if (rng.chance(0.8)) input.observed = &room.observed;
        const FramePlan plan = planShadows(input), again = planShadows(input);
        ASSERT_FALSE(plan.lights[0].refused);
        ASSERT_EQ(plan.lights[0].regions.size(), again.lights[0].regions.size());
        for (std::size_t i = 0; i < plan.lights[0].regions.size(); ++i) {
            EXPECT_EQ(plan.lights[0].regions[i].lightClipFromLocal, again.lights[0].regions[i].lightClipFromLocal);
            EXPECT_EQ(plan.lights[0].regions[i].rectangle, again.lights[0].regions[i].rectangle);
        }
        if (plan.lights[0].regions[0].plane < 0) return;
        ++withPlanes;
        if (input.observed) {
            PlanInput without = input;
            without.technique = std::get<MapTechnique>(*parseTechnique("desired-view(rotated)"));
            EXPECT_LT(predictedErrorOf(room, plan), predictedErrorOf(room, planShadows(without)));
        }
        std::vector<Plane> before;
        for (const FoundPlane& found : plan.lights[0].foundPlanes) before.push_back(found.planeLocal);
        const auto remembered = rememberedBy(plan);
        input.before = remembered;
        const FramePlan next = planShadows(input);
        for (const FoundPlane& found : next.lights[0].foundPlanes)
            kept += std::any_of(before.begin(), before.end(), [&](const Plane& p) {
                return p.normal == found.planeLocal.normal && p.offset == found.planeLocal.offset;
            });
        EXPECT_GE(next.lights[0].foundPlanes.size(), 1u);
    });
    std::printf("%d of 200 with planes, %d kept\n", withPlanes, kept);
    EXPECT_GT(withPlanes, test::scaled(50));
    EXPECT_GE(kept, withPlanes);
}

TEST(PlanesAuto, ServeMoreLightsThanAreObserved)
{
    Rng rng(20040621);
    const RoomView room(rng);
    std::vector<Light> lights(40, room.setup.light);
    for (Light& light : lights) light.directionWorld = normalized({rng.uniform(-1, 1), -1, rng.uniform(-1, -0.3)});
    PlanInput input = inputFor(room.setup, "planes(auto)", {512, 512});
    input.lights = lights;
    input.seen = &room.samples;
    input.observed = &room.observed;
    input.lixelsSpent = 128 * 128;
    const FramePlan plan = planShadows(input);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        EXPECT_FALSE(plan.lights[i].refused) << i;
        EXPECT_LE(plan.lixelsOf(i), 512 * 512);
    }
}

} // namespace
} // namespace lixel
