// SPDX-License-Identifier: MIT
#include "lixel/base/plane.h"
#include "lixel/plan/observe.h"
#include "lixel/plan/shading_light.h"
#include "support/random_cases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <set>

namespace lixel::test {
namespace {

struct Hit
{
    Vec3d pointLocal, normal;
};
using Surface = std::function<std::optional<Hit>(Vec3d eye, Vec3d along)>;

// What a camera at the origin, looking along -z, sees of a surface: a sample a pixel.
ViewSamples seen(const View& view, const Surface& surface)
{
    const Mat4d localFromClip = inverse(clipFromLocal(view, {})).value();
    ViewSamples samples;
    samples.width = view.width, samples.height = view.height;
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const Vec3d along =
                project(localFromClip, {(2 * x + 1.0) / view.width - 1, (2 * y + 1.0) / view.height - 1, 0});
            const std::optional<Hit> hit = surface({}, along);
            if (!hit) continue;
            samples.pixel.push_back({float(x) + 0.5f, float(y) + 0.5f});
            samples.positionLocal.push_back(toFloat(hit->pointLocal));
            samples.normal.push_back(toFloat(dot(hit->normal, along) > 0 ? -hit->normal : hit->normal));
            samples.triangle.push_back(0);
        }
    return samples;
}

std::optional<Hit> onPlane(const Plane& plane, Vec3d eye, Vec3d along)
{
    const double t = -plane.signedDistance(eye) / dot(plane.normal, along);
    if (!(t > 0) || t > 1e4) return std::nullopt;
    return Hit{eye + t * along, plane.normal};
}

View anyView(Rng& rng) { return perspectiveView({}, {0, 0, -1}, {0, 1, 0}, rng.uniform(0.3, 1.5), 0.01, 1e5, 60, 45); }

std::size_t jumps(const Observation& observation)
{
    std::size_t count = 0;
    for (const std::uint8_t isAtJump : observation.samples.atDepthJump) count += isAtJump;
    return count;
}

TEST(Observe, EachCellTakesThePixelNearestToItsCentreAndStandsForItsShareOfThePicture)
{
    forEachCase(kCases, [](Rng& rng) {
        View view = anyView(rng);
        view.width = rng.integer(1, 90), view.height = rng.integer(1, 90);
        const ObservationGrid asked{rng.integer(1, 100), rng.integer(1, 100)};
        const ObservationGrid grid = gridWithin(asked, view);
        const ViewSamples picture = seen(view, [](Vec3d eye, Vec3d along) {
            return onPlane({{0, 0, 1}, 3}, eye, along);
        });
        const Observation observation = observe(picture, view, {}, {}, asked);
        ASSERT_EQ(observation.samples.size(), std::size_t(grid.width * grid.height));
        std::set<std::pair<float, float>> pixels;
        double weight = 0;
        for (std::size_t i = 0; i < observation.samples.size(); ++i) {
            const double x = (double(int(i) % grid.width) + 0.5) * view.width / grid.width;
            const double y = (double(int(i) / grid.width) + 0.5) * view.height / grid.height;
            EXPECT_LE(std::abs(observation.samples.pixel[i].x - x), 0.5);
            EXPECT_LE(std::abs(observation.samples.pixel[i].y - y), 0.5);
            pixels.insert({observation.samples.pixel[i].x, observation.samples.pixel[i].y});
            weight += observation.samples.weightOf(i);
        }
        EXPECT_EQ(pixels.size(), observation.samples.size());
        EXPECT_NEAR(weight, double(view.width) * view.height, 1e-3 * weight);
        EXPECT_TRUE(observation.lit.empty() && observation.atBoundary.empty());
        EXPECT_EQ(observation.ageFrames, 0);
    });
}

TEST(Observe, AGridAsFineAsThePictureHasItsSamplesInTheirOrder)
{
    Rng rng(1);
    const View view = anyView(rng);
    const ViewSamples picture = seen(view, [](Vec3d eye, Vec3d along) {
        return onPlane({normalized({0, 1, 0.3}), 1}, eye, along);
    });
    const Observation observation = observe(picture, view, {}, {}, {1000, 1000});
    EXPECT_EQ(observation.samples.pixel, picture.pixel);
    EXPECT_EQ(observation.samples.positionLocal, picture.positionLocal);
    EXPECT_EQ(observation.samples.normal, picture.normal);
}

// Planes at any slope, edges to and from the eye, and spheres: depth is continuous, its derivative need not be.
TEST(Observe, OneSurfaceHasNoDepthJumpHoweverItBends)
{
    forEachCase(kCases, [](Rng& rng) {
        const View view = anyView(rng);
        const double scale = rng.logUniform(1e-3, 1e4);
        const Vec3d centre = scale * Vec3d{rng.uniform(-0.2, 0.2), rng.uniform(-0.2, 0.2), -1};
        const auto facing = [&] {
            const Vec3d n = normalized(rng.onSphere() + Vec3d{0, 0, 1.2});
            return n;
        };
        const Plane a = planeThrough(centre, facing()), b = planeThrough(centre, facing());
        const bool isRidge = rng.chance(0.5);
        const Surface edge = [&](Vec3d eye, Vec3d along) -> std::optional<Hit> {
            const std::optional<Hit> onA = onPlane(a, eye, along), onB = onPlane(b, eye, along);
            if (!onA || !onB) return std::nullopt;
            const bool isANearer = length(onA->pointLocal) < length(onB->pointLocal);
            return isANearer == isRidge ? onB : onA; // the farther of both planes makes a ridge towards the eye
        };
        const double radius = 0.7 * scale;
        const Surface sphere = [&](Vec3d eye, Vec3d along) -> std::optional<Hit> {
            const Vec3d d = normalized(along), o = eye - 1.2 * centre;
            const double half = dot(o, d), under = half * half - dot(o, o) + radius * radius;
            if (under < 0) return std::nullopt;
            const Vec3d p = eye + (-half - std::sqrt(under)) * d;
            return Hit{p, normalized(p - 1.2 * centre)};
        };
        const auto jumpsInside = [&](const Surface& surface) {
            const ViewSamples picture = seen(view, surface);
            const Observation observation = observe(picture, view, {}, {}, {60, 45});
            std::set<std::pair<float, float>> seenPixels;
            for (const Vec2f& p : picture.pixel) seenPixels.insert({p.x, p.y});
            std::size_t inside = 0;
            for (std::size_t i = 0; i < picture.size(); ++i) {
                const Vec2f p = picture.pixel[i];
                const auto ends = [&](float x, float y) {
                    return x > 0 && y > 0 && x < float(view.width) && y < float(view.height) &&
                           !seenPixels.contains({x, y});
                };
                if (ends(p.x - 1, p.y) || ends(p.x + 1, p.y) || ends(p.x, p.y - 1) || ends(p.x, p.y + 1)) {
                    EXPECT_EQ(observation.samples.atDepthJump[i], 1) << "beside nothing";
                    continue;
                }
                inside += observation.samples.atDepthJump[i];
            }
            return inside;
        };
        EXPECT_EQ(jumpsInside(edge), 0u);
        EXPECT_EQ(jumpsInside(sphere), 0u);
    });
}

TEST(Observe, ASurfaceBeforeAnotherIsMarkedOnBothSidesOfItsBorderAndNowhereElse)
{
    forEachCase(kCases, [](Rng& rng) {
        const View view = anyView(rng);
        const Plane behind{normalized({rng.uniform(-0.5, 0.5), rng.uniform(-0.5, 0.5), 1}), 1};
        const Plane before{behind.normal, rng.uniform(0.3, 0.8)};
        const double border = rng.uniform(-0.1, 0.1);
        const auto isBefore = [&](Vec3d along) { return along.x / -along.z < border; };
        const ViewSamples picture =
            seen(view, [&](Vec3d eye, Vec3d along) { return onPlane(isBefore(along) ? before : behind, eye, along); });
        if (picture.size() < 60 * 45) return; // looks past the horizon
        const Observation observation = observe(picture, view, {}, {}, {60, 45});
        for (std::size_t i = 0; i < picture.size(); ++i) {
            const auto onSide = [&](std::size_t k) { return isBefore(toDouble(picture.positionLocal[k])); };
            const bool isLeftEnd = i % 60 == 0, isRightEnd = i % 60 == 59;
            const bool isAtBorder =
                (!isLeftEnd && onSide(i) != onSide(i - 1)) || (!isRightEnd && onSide(i) != onSide(i + 1));
            EXPECT_EQ(observation.samples.atDepthJump[i] != 0, isAtBorder);
        }
    });
}

TEST(Observe, FacingIsThatOfTheLightsButForRounding)
{
    std::size_t facing = 0;
    forEachCase(kCases, [&](Rng& rng) {
        Light light;
        light.kind = LightKind(rng.integer(0, 2));
        light.positionWorld = rng.inBox(3);
        light.directionWorld = rng.onSphere();
        light.coneAngle = rng.uniform(0.1, 3.1);
        if (rng.chance(0.5)) light.range = rng.uniform(0.5, 5);
        const Vec3d p = rng.inBox(2), n = rng.onSphere();
        const Vec3d toLight = light.kind == LightKind::Directional ? -light.directionWorld : light.positionWorld - p;
        const double distance = length(toLight), cosine = dot(toLight, n) / distance;
        const double inCone = -dot(toLight, light.directionWorld) / distance - std::cos(light.coneAngle / 2);
        const bool isClose =
            std::abs(cosine) < 1e-5 || std::abs(inCone) < 1e-5 || std::abs(distance - light.range) < 1e-5;
        if (isClose) return;
        const Vec3f pf = toFloat(p), nf = toFloat(n);
        const bool isFacing = shared::lxFaces(shadingLight(light, {}), {pf.x, pf.y, pf.z}, {nf.x, nf.y, nf.z});
        EXPECT_EQ(isFacing, isLightFacing(light, {}, p, n));
        facing += isFacing;
    });
    EXPECT_GT(facing, 100u);
}

// Stripes of shadow on a plane: a boundary is where two neighbours differ, if the light reaches both.
TEST(Observe, BoundariesLieWhereLitSamplesMeetShadowedOnesOfTheSameLight)
{
    Rng rng(3);
    const View view = anyView(rng);
    const ViewSamples picture = seen(view, [](Vec3d eye, Vec3d along) { return onPlane({{0, 0, 1}, 2}, eye, along); });
    std::vector<Light> lights(3);
    lights[0].directionWorld = lights[1].directionWorld = {0, 0, -1};
    lights[2].directionWorld = {0, 0, 1}; // from behind: reaches nothing
    std::vector<Visibility> visibility(3);
    for (std::size_t i = 0; i < picture.size(); ++i) {
        const auto x = int(i % 60), y = int(i / 60);
        visibility[0].value.push_back(x < 20 ? 0.49f : 0.5f);
        visibility[1].value.push_back(y < 10 ? 1.0f : 0.0f);
        visibility[2].value.push_back(x % 2 ? 1.0f : 0.0f);
    }
    const Observation observation = observe(picture, view, lights, visibility, {60, 45});
    ASSERT_EQ(observation.atBoundary.size(), picture.size());
    for (std::size_t i = 0; i < picture.size(); ++i) {
        const auto x = int(i % 60), y = int(i / 60);
        EXPECT_EQ(observation.lit[i], (x < 20 ? 0u : 1u) | (y < 10 ? 2u : 0u));
        EXPECT_EQ(observation.atBoundary[i], (x == 19 || x == 20 ? 1u : 0u) | (y == 9 || y == 10 ? 2u : 0u));
    }
    EXPECT_EQ(jumps(observation), 0u);
}

TEST(Observe, ShadowsAcrossADepthJumpMakeNoBoundary)
{
    Rng rng(4);
    const View view = anyView(rng);
    const ViewSamples picture = seen(view, [](Vec3d eye, Vec3d along) {
        return onPlane({{0, 0, 1}, along.x < 0 ? 1.0 : 2.0}, eye, along);
    });
    Light sun;
    sun.directionWorld = {0, 0, -1};
    Visibility visibility;
    for (const Vec3f& p : picture.positionLocal) visibility.value.push_back(p.x < 0 ? 1.0f : 0.0f);
    const Observation observation = observe(picture, view, {&sun, 1}, {&visibility, 1}, {60, 45});
    EXPECT_EQ(jumps(observation), 2u * 45u);
    for (const std::uint32_t bits : observation.atBoundary) EXPECT_EQ(bits, 0u);
}

} // namespace
} // namespace lixel::test
