// SPDX-License-Identifier: MIT
#include "lixel/trace/exact_visibility.h"

#include "trace/shapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lixel {
namespace {

using namespace lixel::test;

TraceScene sceneOf(const LocalTriangles& casters) { return TraceScene(casters, {}, {}); }

// Turned to the outside of a convex body around `centreLocal`.
void turnOutwards(ViewSamples& samples, Vec3d centreLocal)
{
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Vec3d n = toDouble(samples.normal[i]);
        if (dot(n, toDouble(samples.positionLocal[i]) - centreLocal) < 0) samples.normal[i] = toFloat(-n);
    }
}

// How many light-facing samples are dark.
int darkOf(const ViewSamples& samples, const std::vector<float>& visibility, const Light& light)
{
    int dark = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Vec3d p = toDouble(samples.positionLocal[i]), n = toDouble(samples.normal[i]);
        if (isLightFacing(light, samples.originWorld, p, n) && visibility[i] == 0) ++dark;
    }
    return dark;
}

// Any rotation, scale from 1 mm to 10 km, up to 1e5 units from the origin; floats count from nearby.
struct Placement
{
    Mat4d worldFromShape;
    Vec3d centreWorld, originWorld;
    double scale;

    explicit Placement(Rng& rng) : scale(rng.logUniform(1e-3, 1e4))
    {
        centreWorld = rng.inBox(rng.chance(0.5) ? 1e5 : 0);
        originWorld = centreWorld + rng.inBox(scale);
        worldFromShape = translation(centreWorld) * anyRotation(rng) * scaling({scale, scale, scale});
    }
};

// A light whose rays come at the plane through `centreWorld` under a small angle.
Light grazingLight(Rng& rng, Vec3d centreWorld, Vec3d normal, double radius)
{
    const double angle = rng.logUniform(1e-7, 1);
    const Vec3d along = normalized(cross(normal, rng.onSphere()));
    const Vec3d towards = std::cos(angle) * along + std::sin(angle) * normal;
    Light light;
    light.kind = rng.chance(0.5) ? LightKind::Directional : LightKind::Point;
    light.directionWorld = -towards;
    light.positionWorld = centreWorld + radius * rng.logUniform(2, 1e6) * towards;
    return light;
}

TEST(ExactVisibility, AFlatFloorOfManyTrianglesIsLitUnderAnyGrazingLight)
{
    forEachCase(kCases, [](Rng& rng) {
        const Placement place(rng);
        const Shape floor = placed(place.worldFromShape, gridPlane(rng.integer(1, 40), 1));
        const LocalTriangles casters = triangles(floor, place.originWorld);
        const Vec3d up = normalized(transformDirection(place.worldFromShape, {0, 1, 0}));
        const Light light = grazingLight(rng, place.centreWorld, up, place.scale);
        ViewSamples samples = anySamplesOn(casters, 0, casters.triangleCount(), 300, rng);
        for (Vec3f& n : samples.normal)
            if (dot(toDouble(n), up) < 0) n = toFloat(-toDouble(n));
        EXPECT_EQ(darkOf(samples, exactVisibility(sceneOf(casters), samples, light), light), 0);
    });
}

TEST(ExactVisibility, AConvexBodyAloneIsLitWhereverItFacesTheLight)
{
    forEachCase(kCases, [](Rng& rng) {
        const Placement place(rng);
        const int kind = rng.integer(0, 3);
        const Shape body = kind == 0   ? sphere(rng.integer(3, 128), rng.integer(2, 64), 1)
                           : kind == 1 ? box({-1, -0.5, -0.3}, {1, 0.5, 0.3}, rng.integer(1, 12))
                           : kind == 2 ? cylinder(rng.integer(3, 60), rng.integer(1, 20), 0.7, 1)
                                       : box({-1, -0.001, -1}, {1, 0.001, 1}, 3);
        const LocalTriangles casters = triangles(placed(place.worldFromShape, body), place.originWorld);
        ViewSamples samples = anySamplesOn(casters, 0, casters.triangleCount(), 300, rng);
        const Vec3d axis = kind == 2 ? Vec3d{0, 0.5, 0} : Vec3d{};
        const Vec3d centreLocal = transformPoint(place.worldFromShape, axis) - place.originWorld;
        turnOutwards(samples, centreLocal);
        // Half of the lights graze one of the samples.
        Light light = anyLight(rng, place.centreWorld, 2 * place.scale);
        if (rng.chance(0.5) && samples.size() > 0) {
            const Vec3d p = toDouble(samples.positionLocal[0]) + place.originWorld;
            light = grazingLight(rng, p, toDouble(samples.normal[0]), 4 * place.scale);
        }
        const TraceScene scene = sceneOf(casters);
        EXPECT_EQ(darkOf(samples, exactVisibility(scene, samples, light), light), 0) << "kind " << kind;
    });
}

TEST(ExactVisibility, ABoxOnAFloorShadowsTheFloorRightUpToTheContact)
{
    forEachCase(kCases, [](Rng& rng) {
        const Placement place(rng);
        Shape shape = joined(gridPlane(8, 2), box({-0.5, 0, -0.5}, {0.5, 1, 0.5}, 2));
        const LocalTriangles casters = triangles(placed(place.worldFromShape, shape), place.originWorld);
        // Light travels along +x and down, not so steep that the shadow ends within the distances asked for.
        const double slope = rng.logUniform(1e-3, 10);
        Light light;
        light.directionWorld =
            normalized(transformDirection(place.worldFromShape, normalized({1, -slope, rng.uniform(-0.2, 0.2)})));
        const TraceScene scene = sceneOf(casters);
        ViewSamples samples;
        for (int i = 0; i < 40; ++i) {
            // Floats place the sample no better than their step, nor the wall.
            const double away = rng.logUniform(1e-5, 0.08);
            const double z = rng.uniform(-0.4, 0.4);
            const Vec3d pointWorld = transformPoint(place.worldFromShape, {0.5 + away, 0, z});
            const int cellX = int((0.5 + away + 2) * 2), cellZ = int((z + 2) * 2);
            const double inX = (0.5 + away + 2) * 2 - cellX, inZ = (z + 2) * 2 - cellZ;
            const auto triangle = std::uint32_t(2 * (cellZ * 8 + cellX) + (inZ > inX ? 1 : 0));
            const Vec3d up = transformDirection(place.worldFromShape, {0, 1, 0});
            addSample(samples, casters, triangle, pointWorld - place.originWorld, up);
        }
        for (const float lit : exactVisibility(scene, samples, light)) EXPECT_EQ(lit, 0);
    });
}

TEST(ExactVisibility, NoRayLeaksThroughAClosedMeshEvenAtItsEdgesAndCorners)
{
    forEachCase(kCases, [](Rng& rng) {
        const Placement place(rng);
        // A small floor within a closed hull; every ray must be stopped by the hull.
        const Shape floor = gridPlane(1, 0.05);
        const Shape hull = rng.chance(0.5) ? sphere(rng.integer(3, 40), rng.integer(2, 20), 1)
                                           : box({-0.7, -0.4, -0.3}, {0.2, 0.5, 0.6}, rng.integer(1, 6));
        const Shape all = placed(place.worldFromShape, joined(floor, hull));
        const LocalTriangles casters = triangles(all, place.originWorld);
        const TraceScene scene = sceneOf(casters);
        for (int i = 0; i < 100; ++i) {
            ViewSamples samples = anySamplesOn(casters, 0, 2, 1, rng);
            if (samples.size() == 0) continue;
            // Aimed at a corner or the middle of an edge of the hull, as exactly as doubles go.
            const int k = rng.integer(2, int(casters.triangleCount()) - 1);
            const std::uint32_t* corner = casters.indices.data() + 3 * k;
            const Vec3d a = toDouble(casters.positionLocal[corner[0]]), b = toDouble(casters.positionLocal[corner[1]]);
            const Vec3d target = rng.chance(0.5) ? a : 0.5 * (a + b);
            Light light;
            const Vec3d towards = target - toDouble(samples.positionLocal[0]);
            light.directionWorld = -normalized(towards);
            if (rng.chance(0.5)) {
                light.kind = LightKind::Point;
                light.positionWorld = toDouble(samples.positionLocal[0]) + 3.0 * towards + place.originWorld;
            }
            if (dot(toDouble(samples.normal[0]), towards) < 0)
                samples.normal[0] = toFloat(-toDouble(samples.normal[0]));
            EXPECT_EQ(exactVisibility(scene, samples, light)[0], 0);
        }
    });
}

TEST(ExactVisibility, WhatLiesBehindALightAtAPointDoesNotCount)
{
    forEachCase(kCases, [](Rng& rng) {
        const Placement place(rng);
        const double height = rng.uniform(0.3, 0.9), gap = rng.logUniform(1e-4, 0.1);
        const Shape plates = joined(gridPlane(1, 1), placed(translation({0, height, 0}), gridPlane(1, 1)));
        const LocalTriangles casters = triangles(placed(place.worldFromShape, plates), place.originWorld);
        const TraceScene scene = sceneOf(casters);
        const Vec3d up = transformDirection(place.worldFromShape, {0, 1, 0});
        ViewSamples samples = anySamplesOn(casters, 0, 2, 50, rng);
        for (Vec3f& n : samples.normal)
            if (dot(toDouble(n), up) < 0) n = toFloat(-toDouble(n));
        Light light;
        light.kind = LightKind::Point;
        light.positionWorld = transformPoint(place.worldFromShape, {0.1, height - gap, 0.2});
        for (const float lit : exactVisibility(scene, samples, light)) EXPECT_EQ(lit, 1);
        light.positionWorld = transformPoint(place.worldFromShape, {0.1, height + gap, 0.2});
        for (const float lit : exactVisibility(scene, samples, light)) EXPECT_EQ(lit, 0);
    });
}

TEST(ExactVisibility, ALampOnTheCeilingIsNotHiddenByTheCeiling)
{
    const Shape plates = joined(gridPlane(4, 1), placed(translation({0, 1, 0}), gridPlane(4, 1)));
    const LocalTriangles casters = triangles(plates);
    const TraceScene scene = sceneOf(casters);
    Rng rng(1);
    ViewSamples samples = anySamplesOn(casters, 0, 32, 500, rng);
    for (Vec3f& n : samples.normal) n = {0, 1, 0};
    Light light;
    light.kind = LightKind::Point;
    for (const Vec3d position : {Vec3d{0, 1, 0}, Vec3d{0.1, 1, 0.3}, Vec3d{1, 1, 1}}) { // a corner, inside, the border
        light.positionWorld = position;
        for (const float lit : exactVisibility(scene, samples, light)) EXPECT_EQ(lit, 1);
    }
}

TEST(ExactVisibility, ALightAtASampleOrAtACornerOfTheGeometryIsSurvived)
{
    const LocalTriangles casters = triangles(box({-1, -1, -1}, {1, 1, 1}, 2));
    const TraceScene scene = sceneOf(casters);
    Rng rng(2);
    const ViewSamples samples = anySamplesOn(casters, 0, casters.triangleCount(), 200, rng);
    Light light;
    light.kind = LightKind::Point;
    for (const Vec3d position : {Vec3d{1, 1, 1}, Vec3d{0, 1, 0}, Vec3d{0, 0, 0}, toDouble(samples.positionLocal[3])}) {
        light.positionWorld = position;
        for (const float lit : exactVisibility(scene, samples, light)) EXPECT_TRUE(lit == 0 || lit == 1);
    }
}

TEST(ExactVisibility, FromInsideABoxEveryWallIsLitByALampInside)
{
    forEachCase(kCases, [](Rng& rng) {
        const Placement place(rng);
        const LocalTriangles casters =
            triangles(placed(place.worldFromShape, box({-1, -1, -1}, {1, 1, 1}, rng.integer(1, 8))), place.originWorld);
        ViewSamples samples = anySamplesOn(casters, 0, casters.triangleCount(), 200, rng);
        const Vec3d centreLocal = place.centreWorld - place.originWorld;
        turnOutwards(samples, centreLocal);
        for (Vec3f& n : samples.normal) n = toFloat(-toDouble(n));
        Light light;
        light.kind = LightKind::Point;
        light.positionWorld = transformPoint(place.worldFromShape, rng.inBox(0.999));
        EXPECT_EQ(darkOf(samples, exactVisibility(sceneOf(casters), samples, light), light), 0);
    });
}

TEST(ExactVisibility, SamplesThatFaceAwayAreDark)
{
    const LocalTriangles casters = triangles(gridPlane(2, 1));
    Rng rng(3);
    ViewSamples samples = anySamplesOn(casters, 0, 8, 50, rng);
    for (Vec3f& n : samples.normal) n = {0, -1, 0};
    for (const float lit : exactVisibility(sceneOf(casters), samples, Light{})) EXPECT_EQ(lit, 0);
}

TEST(ExactVisibility, SamplesWithoutATriangleOnAFlatFloorAreLit)
{
    forEachCase(kCases, [](Rng& rng) {
        const Placement place(rng);
        const LocalTriangles casters = triangles(placed(place.worldFromShape, gridPlane(10, 1)), place.originWorld);
        const Vec3d up = normalized(transformDirection(place.worldFromShape, {0, 1, 0}));
        ViewSamples samples = anySamplesOn(casters, 0, casters.triangleCount(), 100, rng);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (dot(toDouble(samples.normal[i]), up) < 0) samples.normal[i] = toFloat(-toDouble(samples.normal[i]));
            samples.triangle[i] = kNoTriangle;
        }
        const Light light = grazingLight(rng, place.centreWorld, up, place.scale);
        if (dot(-light.directionWorld, up) < 1e-4 && light.kind == LightKind::Directional) return;
        EXPECT_EQ(darkOf(samples, exactVisibility(sceneOf(casters), samples, light), light), 0);
    });
}

TEST(ExactVisibility, TheAnswerForASampleDoesNotDependOnTheOthersOrTheThreads)
{
    Rng rng(4);
    const Shape shape = joined(gridPlane(10, 4), placed(translation({0, 1.2, 0}), sphere(40, 20, 1)));
    const LocalTriangles casters = triangles(shape);
    const TraceScene scene = sceneOf(casters);
    const ViewSamples samples = anySamplesOn(casters, 0, casters.triangleCount(), 20000, rng);
    const Light light = anyLight(rng, {}, 5);
    const std::vector<float> together = exactVisibility(scene, samples, light);
    for (std::size_t i = 0; i < samples.size(); i += 97) {
        ViewSamples alone;
        alone.positionLocal = {samples.positionLocal[i]}, alone.normal = {samples.normal[i]};
        alone.triangle = {samples.triangle[i]}, alone.pixel = {samples.pixel[i]};
        EXPECT_EQ(exactVisibility(scene, alone, light)[0], together[i]);
    }
}

TEST(ExactVisibility, ASceneWithoutTrianglesLightsEverything)
{
    const TraceScene scene = sceneOf({});
    ViewSamples samples;
    samples.pixel = {{0.5f, 0.5f}}, samples.positionLocal = {{1, 2, 3}}, samples.normal = {{0, 1, 0}};
    samples.triangle = {kNoTriangle};
    EXPECT_EQ(exactVisibility(scene, samples, Light{})[0], 1);
}

} // namespace
} // namespace lixel
