// SPDX-License-Identifier: MIT
#include "lixel/plan/host_matrix.h"
#include "lixel/plan/host_region.h"
#include "lixel/plan/host_view.h"

#include "plan/host_cameras.h"
#include "plan/planed_setups.h"
#include "plan/random_setups.h"

#include <gtest/gtest.h>

namespace lixel {
namespace {

using test::Camera;
using test::forEachCase;
using test::Host;
using test::HostMatrices;
using test::kCases;
using test::kHosts;
using test::kLenses;
using test::Lens;
using test::Rng;

// What is tried in every convention; a new fit or partition is one line.
constexpr const char* kTechniques[] = {
    "uniform",
    "focused",
    "focused(stable)",
    "desired-view",
    "desired-view(rotated)",
    "minimal-frustum",
    "psm",
    "psm(shift=none)",
    "tsm",
    "tsm(focus=5)",
    "lispsm",
    "lispsm(stable)",
    "scene-optimal",
    "scene-optimal(metric=l2,search=paper)",
    "scene-optimal(metric=lloyd,update=1,weight=0)+else(cube)",
    "pssm(3)+scene-optimal",
    "planes(a)+scene-optimal",
    "pssm(4)",
    "pssm(4,stable)",
    "pssm(3)+lispsm",
    "sdsm(3)",
    "sdsm(3,stable)",
    "cube",
    "cube+desired-view",
    "lispsm+else(focused)",
    "planes(a)",
    "planes(a,b,c)",
    "planes(a,b,twist=line)+else(lispsm)",
    "planes(a,b,twist=none)+else(cube)",
    "planes(a,b)+plane-optimal(desired-view)",
    "planes(a,b)+focused",
    "planes(a,b)+allocation=exact",
};

MapTechnique techniqueOf(const char* text) { return std::get<MapTechnique>(parseTechnique(text).value()); }

test::RandomSetup anySetupSeenBy(Rng& rng, Lens lens, bool isInfinite, Camera& camera)
{
    test::RandomSetup setup = test::anySetup(rng);
    Box scene;
    for (const Box& box : setup.boxesWorld) scene.include(box);
    camera = test::anyCamera(rng, lens, isInfinite, scene.centre(), setup.radius);
    setup.view = test::lixelView(camera);
    setup.originWorld = camera.eyeWorld;
    return setup;
}

std::vector<Vec3d> pointsOf(const test::RandomSetup& setup, Rng& rng, int count)
{
    std::vector<Vec3d> pointsLocal;
    const Box box = setup.sceneLocal();
    for (int i = 0; i < count; ++i)
        pointsLocal.push_back(
            {rng.uniform(box.min.x, box.max.x), rng.uniform(box.min.y, box.max.y), rng.uniform(box.min.z, box.max.z)});
    return pointsLocal;
}

// What the view sees, for techniques made from it: points of the scene, whatever stands before them.
ViewSamples anySamples(const test::RandomSetup& setup, const std::vector<Vec3d>& pointsLocal)
{
    ViewSamples seen;
    seen.width = setup.view.width, seen.height = setup.view.height;
    seen.originWorld = setup.originWorld;
    for (const Vec3d& p : pointsLocal) {
        const Vec4d clip = clipFromLocal(setup.view, setup.originWorld) * point(p);
        if (!(std::abs(clip.x) < clip.w && std::abs(clip.y) < clip.w && std::abs(clip.z) < clip.w)) continue;
        const Vec3d pixel = pixelFromLocal(setup.view, setup.originWorld, p);
        const Vec3d normal = towardsLight(setup.light, setup.originWorld, p);
        seen.pixel.push_back({float(pixel.x), float(pixel.y)});
        seen.positionLocal.push_back({float(p.x), float(p.y), float(p.z)});
        seen.normal.push_back({float(normal.x), float(normal.y), float(normal.z)});
        seen.triangle.push_back(kNoTriangle);
    }
    return seen;
}

std::optional<View> viewOf(const HostMatrices& matrices, const Camera& camera, const Host& host)
{
    return viewFromHost(matrices.clipFromView, matrices.viewFromWorld, host.clip, camera.width, camera.height);
}

// Every lens, with finite and infinite far planes, in every host.
void forEachHostAndLens(int cases, const std::function<void(const Host&, Lens, bool isInfinite, Rng&)>& property)
{
    forEachCase(cases, [&](Rng& rng) {
        for (const Host& host : kHosts)
            for (const Lens lens : kLenses)
                for (const bool isInfinite : {false, true}) {
                    SCOPED_TRACE(std::string(host.name) + ", lens " + std::to_string(int(lens)) +
                                 (isInfinite ? ", infinite far" : ""));
                    property(host, lens, isInfinite, rng);
                    if (testing::Test::HasFatalFailure()) return;
                }
    });
}

// As a rasterizer and its depth buffer do it: divide, viewport, depth range 0..1. Texels of a layer, and the depth stored.
Vec3d rasterized(const HostRegion& region, const Host& host, Vec3d pointLocal)
{
    const Vec3d ndc = project(region.clipFromLocal, pointLocal);
    const LixelRectangle& r = region.viewport;
    const double fromRowZero = 0.5 - 0.5 * host.ndcYOfRowZero * ndc.y;
    const double depth = host.clip.depth == ClipDepth::MinusOneToOne ? 0.5 * ndc.z + 0.5 : ndc.z;
    return {r.x0 + (0.5 + 0.5 * ndc.x) * r.width(), r.y0 + fromRowZero * r.height(), depth};
}

TEST(HostConvention, AViewIsTheSameWhateverHostItComesFrom)
{
    forEachHostAndLens(20, [](const Host& host, Lens lens, bool isInfinite, Rng& rng) {
        Camera camera;
        const test::RandomSetup setup = anySetupSeenBy(rng, lens, isInfinite, camera);
        const std::optional<View> view = viewOf(test::matricesOf(camera, host), camera, host);
        ASSERT_TRUE(view);
        for (const Vec3d& p : pointsOf(setup, rng, 8)) {
            const Vec4d clip = clipFromLocal(setup.view, setup.originWorld) * point(p);
            if (clip.w < 1e-3 * setup.radius && lens != Lens::Orthographic) continue;
            const Vec3d expected = pixelFromLocal(setup.view, setup.originWorld, p);
            const Vec3d pixel = pixelFromLocal(*view, setup.originWorld, p);
            // The eye is rounded where it stands: an angle of the picture, up to 1e4 pixels a radian.
            const double distance = lens == Lens::Orthographic ? setup.radius : clip.w;
            const double angle = 1e-12 + 1e-15 * length(camera.eyeWorld) / distance;
            const double scale = angle * (1e4 + 10 * length(expected));
            EXPECT_NEAR(pixel.x, expected.x, scale);
            EXPECT_NEAR(pixel.y, expected.y, scale);
            EXPECT_NEAR(pixel.z, expected.z, scale);
            const Vec3d towards = normalized(towardsEye(*view, setup.originWorld, p));
            EXPECT_GT(dot(towards, normalized(towardsEye(setup.view, setup.originWorld, p))), 1 - 1e-9);
        }
    });
}

TEST(HostConvention, EveryTechniqueGivesEveryHostTheSameLixelOfAPoint)
{
    int planned = 0, ofPlanes = 0;
    const auto tryHost = [&](const MapTechnique& technique, const Host& host, Lens lens, bool isInfinite, Rng& rng) {
        Camera camera;
        const test::RandomSetup setup = anySetupSeenBy(rng, lens, isInfinite, camera);
        // Beyond, rounding of the eye's place moves the picture by more than a map's details.
        if (length(camera.eyeWorld) > 1e5 * setup.radius) return;
        const int most = technique.allocation == Allocation::Exact ? 4096 : 1024; // of whole pictures a lixel a pixel
        const LixelSize lixels{rng.integer(most / 16, most), rng.integer(most / 16, most)};
        PlanInput input{setup.view, {&setup.light, 1}, setup.boxesWorld, setup.originWorld, technique, lixels};
        const ViewSamples seen = anySamples(setup, pointsOf(setup, rng, 200));
        input.seen = &seen;
        const std::vector<NamedPlane> planes = test::anyPlanes(setup, rng);
        input.planes = planes;
        const FramePlan own = planShadows(input);
        input.view = viewOf(test::matricesOf(camera, host), camera, host).value();
        const FramePlan plan = planShadows(input);

        ASSERT_EQ(own.lights[0].refused, plan.lights[0].refused);
        ASSERT_EQ(own.lights[0].regions.size(), plan.lights[0].regions.size());
        planned += !plan.lights[0].refused;
        for (std::size_t i = 0; i < plan.lights[0].regions.size(); ++i) {
            const PlannedRegion &ownRegion = own.lights[0].regions[i], &region = plan.lights[0].regions[i];
            ASSERT_EQ(ownRegion.rectangle, region.rectangle);
            ofPlanes += region.plane >= 0;
            const LightImage image(ownRegion.lightClipFromLocal, ownRegion.rectangle);
            const HostRegion drawn = toHost(region, plan.atlas, host.clip, host.origin);
            for (const Vec3d& p : pointsOf(setup, rng, 8)) {
                const std::optional<Vec3d> lixel = image.lixelAt(p);
                if (!lixel) continue;
                const Vec3d texel = rasterized(drawn, host, p);
                const Vec2d expected = toHost(Vec2d{lixel->x, lixel->y}, plan.atlas, host.origin);
                EXPECT_NEAR(texel.x, expected.x, 1e-3);
                EXPECT_NEAR(texel.y, expected.y, 1e-3);
                const double depth01 = 0.5 + 0.5 * lixel->z;
                EXPECT_NEAR(texel.z, host.clip.depth == ClipDepth::OneToZero ? 1 - depth01 : depth01, 1e-6);
            }
        }
    };
    for (const char* text : kTechniques) {
        SCOPED_TRACE(text);
        MapTechnique technique = techniqueOf(text);
        // Shares by need round to lixels, which may tip over.
        if (technique.allocation == Allocation::Need) technique.allocation = Allocation::Share;
        forEachHostAndLens(10, [&](const Host& host, Lens lens, bool isInfinite, Rng& rng) {
            tryHost(technique, host, lens, isInfinite, rng);
        });
    }
    EXPECT_GT(planned, test::scaled(1000));
    EXPECT_GT(ofPlanes, test::scaled(1000));
}

TEST(HostConvention, TheTextureMatrixReadsWhereTheClipMatrixDraws)
{
    forEachCase(kCases, [](Rng& rng) {
        for (const Host& host : kHosts) {
            SCOPED_TRACE(host.name);
            const test::RandomSetup setup = test::anySetup(rng);
            const LixelSize atlas{rng.integer(100, 1000), rng.integer(100, 1000)};
            const FramePlan plan = planShadows(
                {setup.view, {&setup.light, 1}, setup.boxesWorld, setup.originWorld, {}, {atlas.width, 100}});
            if (plan.lights[0].refused) continue;
            PlannedRegion region = plan.lights[0].regions[0];
            region.rectangle = {rng.integer(0, 20), rng.integer(0, 20), rng.integer(30, 99), rng.integer(30, 99), 0};
            const HostRegion drawn = toHost(region, atlas, host.clip, host.origin);
            for (const Vec3d& p : pointsOf(setup, rng, 8)) {
                if ((region.lightClipFromLocal * point(p)).w < 1e-3 * setup.radius) continue;
                const Vec3d texel = rasterized(drawn, host, p), read = project(drawn.textureFromLocal, p);
                const double scale = 1e-9 * (1 + length(texel));
                EXPECT_NEAR(read.x * atlas.width, texel.x, scale);
                EXPECT_NEAR(read.y * atlas.height, texel.y, scale);
                EXPECT_NEAR(read.z, texel.z, scale);
            }
        }
    });
}

TEST(HostConvention, WhatEntersLeavesUnchanged)
{
    forEachCase(kCases, [](Rng& rng) {
        for (const Host& host : kHosts) {
            Mat4d matrix;
            for (int i = 0; i < 4; ++i)
                matrix.setRow(i, {rng.uniform(-9, 9), rng.uniform(-9, 9), rng.uniform(-9, 9), rng.uniform(-9, 9)});
            const Mat4d back = toHost(fromHost(matrix, host.clip), host.clip);
            for (int i = 0; i < 4; ++i)
                for (int j = 0; j < 4; ++j) EXPECT_NEAR(back.m[i][j], matrix.m[i][j], 1e-13);
        }
    });
}

// Engines hold floats: 24 bits of each number are what is left.
TEST(HostConvention, AViewComesThroughFloatColumns)
{
    forEachHostAndLens(20, [](const Host& host, Lens lens, bool isInfinite, Rng& rng) {
        const Camera camera = test::anyCamera(rng, lens, isInfinite, {}, 1);
        const HostMatrices matrices = test::matricesOf(camera, host);
        const auto asFloats = [](const Mat4d& matrix) {
            return matrixFromColumns(std::span<const float, 16>(columnsOf(matrix)));
        };
        const View exact = test::lixelView(camera);
        const std::optional<View> view =
            viewOf({asFloats(matrices.clipFromView), asFloats(matrices.viewFromWorld)}, camera, host);
        ASSERT_TRUE(view);
        for (int i = 0; i < 8; ++i) {
            const Vec3d p = rng.inBox(1);
            const Vec3d expected = pixelFromLocal(exact, {}, p), pixel = pixelFromLocal(*view, {}, p);
            if (!(length(expected) < 2000) || (clipFromWorld(exact) * point(p)).w < 0.1) continue;
            EXPECT_NEAR(pixel.x, expected.x, 0.02);
            EXPECT_NEAR(pixel.y, expected.y, 0.02);
        }
    });
}

TEST(HostConvention, ABrokenCameraGivesNoView)
{
    const View good = perspectiveView({0, 1, 5}, {}, {0, 1, 0}, 1, 0.1, 100, 64, 48);
    Mat4d flat = good.clipFromAnchored, broken = good.clipFromAnchored;
    flat.setRow(1, flat.row(0));
    broken.m[2][1] = NAN;
    EXPECT_TRUE(viewFromHost(good.clipFromAnchored, good.anchorWorld, {}, 64, 48));
    EXPECT_FALSE(viewFromHost(flat, good.anchorWorld, {}, 64, 48));
    EXPECT_FALSE(viewFromHost(broken, good.anchorWorld, {}, 64, 48));
    EXPECT_FALSE(viewFromHost(good.clipFromAnchored, scaling({1, 0, 1}), {}, 64, 48));
    EXPECT_FALSE(viewFromHost(good.clipFromAnchored, good.anchorWorld, {}, 0, 48));
}

} // namespace
} // namespace lixel
